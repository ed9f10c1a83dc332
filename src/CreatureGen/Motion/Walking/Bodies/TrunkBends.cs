using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>How far a trunk bends from the pelvis to the joint of its fore legs, radians: all its joints bend alike, and the stiffest decides.</summary>
internal sealed class TrunkBends
{
    /// <summary>Part of the joints' limits that bends take up, about one axis or about several at once.</summary>
    public const float Fraction = 0.95f;

    /// <summary>The same of bends up and down: the rest is for those to a side that go with them.</summary>
    private const float PitchFraction = 0.75f * Fraction;

    /// <summary>A limit below this, radians, counts as this.</summary>
    private const float Least = 1e-5f;

    private readonly (Quaternion ToBone, JointLimit Limit)[] joints;

    /// <param name="skeleton">Its limits are taken.</param>
    /// <param name="trunk">The joints from the pelvis on.</param>
    /// <param name="foreSlot">The place among them of the joint of the fore legs.</param>
    public TrunkBends(Skeleton skeleton, int[] trunk, int foreSlot)
    {
        joints = new (Quaternion, JointLimit)[Math.Min(foreSlot, trunk.Length - 1)];
        for (int i = 0; i < joints.Length; i++)
        {
            int joint = trunk[i + 1];
            joints[i] = (Rotation.Inverse(skeleton.ModelRotations[joint]), skeleton.Joints[joint].Limit);
        }

        Yaw = Fraction * Narrowest(limit => limit.SwingZ);
        Pitch = PitchFraction * Narrowest(limit => limit.SwingX);
        Roll = Fraction * Narrowest(limit => limit.Twist);
    }

    /// <summary>To either side.</summary>
    public float Yaw { get; }

    /// <summary>Rounding or hollowing the back.</summary>
    public float Pitch { get; }

    /// <summary>Twisting about its length.</summary>
    public float Roll { get; }

    /// <summary>What is left of a bend about all axes at once: bones that do not lie along the trunk are twisted by its bends to a side, and these and those up and down swing the same joints.</summary>
    /// <param name="bend">Pitch, yaw and roll, the axes of the model.</param>
    public Vector3 Within(Vector3 bend)
    {
        float most = Fraction;
        Vector3 each = bend / Math.Max(joints.Length, 1);

        // Yaw after pitch after roll is a turn about this, but for what is of the third order.
        each += 0.5f * new Vector3(each.Y * each.Z, -each.X * each.Z, -each.X * each.Y);
        foreach ((Quaternion toBone, JointLimit limit) in joints)
        {
            Vector3 turn = Rotation.Rotate(toBone, each);
            float swing = Scalar.Square(Part(turn.X, limit.SwingX)) + Scalar.Square(Part(turn.Z, limit.SwingZ));
            most = Math.Max(most, Math.Max((float)Math.Sqrt(swing), Part(turn.Y, limit.Twist)));
        }

        return most > Fraction ? bend * (Fraction / most) : bend;
    }

    private static float Part(float angle, AngleRange range) => Math.Abs(angle) / Math.Max(angle < 0f ? -range.Min : range.Max, Least);

    private float Narrowest(Func<JointLimit, AngleRange> axis)
    {
        float min = float.MaxValue;
        foreach ((_, JointLimit limit) in joints)
        {
            AngleRange side = axis(limit);
            min = Math.Min(min, Math.Min(-side.Min, side.Max));
        }

        return min == float.MaxValue ? 0f : min * joints.Length;
    }
}
