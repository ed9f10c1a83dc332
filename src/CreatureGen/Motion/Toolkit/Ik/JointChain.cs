using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Ik;

/// <summary>Joints each of which is the parent of the next, as solvers see them.</summary>
internal static class JointChain
{
    private const float Hinged = 1e-4f;

    /// <summary>Radians from the end of a range that count as being there.</summary>
    private const double AtLimit = 2e-3;

    /// <summary>Its length, metres.</summary>
    /// <exception cref="ArgumentException">It is not a chain.</exception>
    public static float Prove(Skeleton skeleton, ReadOnlySpan<int> chain, in Pose local)
    {
        if (chain.Length < 2)
        {
            throw new ArgumentException(FormattableString.Invariant($"a chain of {chain.Length} joints; expected a joint that turns and an end at least"), nameof(chain));
        }

        float length = 0f;
        for (int k = 1; k < chain.Length; k++)
        {
            if ((uint)chain[k] >= (uint)skeleton.Count || skeleton.Parents[chain[k]] != chain[k - 1])
            {
                throw new ArgumentException(FormattableString.Invariant($"chain[{k - 1}] = {chain[k - 1]} is not the parent of chain[{k}] = {chain[k]}; expected a chain without gaps"), nameof(chain));
            }

            length += Vec.Length(local.Positions[chain[k]]);
        }

        return length;
    }

    /// <summary>Copies the rotations of its joints from a pose.</summary>
    public static void Keep(ReadOnlySpan<int> chain, in Pose local, Span<Quaternion> best)
    {
        for (int k = 0; k < chain.Length; k++)
        {
            best[k] = local.Rotations[chain[k]];
        }
    }

    /// <summary>Copies them back.</summary>
    public static void Restore(ReadOnlySpan<int> chain, ReadOnlySpan<Quaternion> best, in Pose local)
    {
        for (int k = 0; k < chain.Length; k++)
        {
            local.Rotations[chain[k]] = best[k];
        }
    }

    /// <summary>Whether a joint has no room left to some side.</summary>
    public static bool IsAtLimit(Skeleton skeleton, ReadOnlySpan<int> chain, in Pose local)
    {
        for (int k = 0; k < chain.Length - 1; k++)
        {
            Joint joint = skeleton.Joints[chain[k]];
            if (joint.Limit == JointLimit.Free)
            {
                continue;
            }

            Quaternion axes = BoneAxes.Of(joint);
            Quaternion turn = Rotation.Multiply(Rotation.Inverse(axes), Rotation.Multiply(Rotation.Multiply(Rotation.Inverse(joint.LocalRotation), local.Rotations[chain[k]]), axes));
            SwingTwistLimit.Split(turn, out double x, out double z, out double twist);
            if (IsAtEnd(joint.Limit.SwingX, x) || IsAtEnd(joint.Limit.SwingZ, z) || IsAtEnd(joint.Limit.Twist, twist) || IsOnRim(joint.Limit, x, z))
            {
                return true;
            }
        }

        return false;
    }

    private static bool IsAtEnd(AngleRange range, double angle) => Width(range) > Hinged && (angle <= range.Min + AtLimit || angle >= range.Max - AtLimit);

    private static bool IsOnRim(JointLimit limit, double x, double z)
    {
        double a = Math.Max(x < 0 ? -limit.SwingX.Min : limit.SwingX.Max, 1e-6);
        double b = Math.Max(z < 0 ? -limit.SwingZ.Min : limit.SwingZ.Max, 1e-6);
        return (x / a * (x / a)) + (z / b * (z / b)) >= 1 - AtLimit;
    }

    /// <summary>Whether a joint turns about one axis alone, the bone's X.</summary>
    public static bool IsHinge(JointLimit limit) => Width(limit.SwingZ) <= Hinged && Width(limit.Twist) <= Hinged;

    private static float Width(AngleRange range) => range.Max - range.Min;
}
