using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Clips;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>How far a clip is off another one in model space, measured at three points beside each joint, one along each of its axes, at every moment asked for; the farthest of the three counts.</summary>
/// <param name="Median">Metres that half of all cases stay below.</param>
/// <param name="P99">Metres that 99 of 100 cases stay below.</param>
/// <param name="Worst">Metres of the worst case.</param>
/// <remarks>Based on: N. Frechette, "Animation compression: measuring accuracy" (2016), who measures 3 cm beside joints of people.</remarks>
public readonly record struct ClipError(float Median, float P99, float Worst)
{
    /// <summary>Compares two clips of a skeleton.</summary>
    /// <param name="original">What is right.</param>
    /// <param name="other">What is compared with it; it lasts as long.</param>
    /// <param name="skeleton">Of both.</param>
    /// <param name="moments">How many moments, evenly from the beginning to the end; 2 at least.</param>
    /// <param name="distance">Metres from a joint to the points beside it.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">A clip is of another number of joints, or a number is out of its range.</exception>
    public static ClipError Between(IClip original, IClip other, Skeleton skeleton, int moments, float distance = 0.03f)
    {
        _ = original ?? throw new ArgumentNullException(nameof(original));
        _ = other ?? throw new ArgumentNullException(nameof(other));
        _ = skeleton ?? throw new ArgumentNullException(nameof(skeleton));
        Finite.RequireWithin(distance, 0f, float.MaxValue, nameof(distance));
        if (moments < 2)
        {
            throw new ArgumentException(FormattableString.Invariant($"{moments} moments; expected 2 at least"), nameof(moments));
        }

        int count = skeleton.Count;
        var right = new ModelPose(skeleton);
        var shown = new ModelPose(skeleton);
        float[] errors = new float[moments * count];
        for (int k = 0; k < moments; k++)
        {
            right.Sample(original, PartOf(original.Duration, k, moments));
            shown.Sample(other, PartOf(other.Duration, k, moments));
            for (int joint = 0; joint < count; joint++)
            {
                errors[(k * count) + joint] = At(right, shown, joint, distance);
            }
        }

        Array.Sort(errors);
        return new ClipError(errors[errors.Length / 2], errors[Math.Max(0, (int)Math.Ceiling(0.99 * errors.Length) - 1)], errors[errors.Length - 1]);
    }

    /// <summary>The k-th of so many moments, seconds.</summary>
    internal static float PartOf(float duration, int k, int moments) => k == moments - 1 ? duration : (float)((double)duration * k / (moments - 1));

    /// <summary>How far the points beside a joint are apart in two poses, metres.</summary>
    internal static float At(ModelPose a, ModelPose b, int joint, float distance)
    {
        Rotation.ToBasis(a.Pose.Rotations[joint], out Vector3 ax, out Vector3 ay, out Vector3 az);
        Rotation.ToBasis(b.Pose.Rotations[joint], out Vector3 bx, out Vector3 by, out Vector3 bz);
        Vector3 apart = a.Pose.Positions[joint] - b.Pose.Positions[joint];
        return Math.Max(Vec.Length(apart + (distance * (ax - bx))), Math.Max(Vec.Length(apart + (distance * (ay - by))), Vec.Length(apart + (distance * (az - bz)))));
    }
}
