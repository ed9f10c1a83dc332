using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Poses;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Differences between poses, and poses with differences laid on top: a breath, a flinch or an aim on any motion. Nothing is allocated.</summary>
/// <remarks>
/// A difference is a pose whose rotations are turns in the joints' own axes (reference⁻¹ · pose) and whose positions are shifts in the parents' space. Laying it on turns each joint by it
/// after its own rotation: result = pose · difference^weight, the power taken along the shorter arc.
/// </remarks>
public static class AdditivePose
{
    /// <summary>What makes a reference into a pose.</summary>
    /// <param name="pose">A local pose.</param>
    /// <param name="reference">The local pose that gives no difference, usually the rest pose.</param>
    /// <param name="difference">Receives the difference; may lie over the same spans as <paramref name="pose"/>.</param>
    /// <exception cref="ArgumentException">The poses differ in length.</exception>
    public static void Subtract(in Pose pose, in Pose reference, in Pose difference)
    {
        PoseCheck.SameLength(pose, reference);
        PoseCheck.SameLength(pose, difference);
        for (int i = 0; i < pose.Rotations.Length; i++)
        {
            difference.Rotations[i] = Rotation.Multiply(Rotation.Inverse(reference.Rotations[i]), pose.Rotations[i]);
            difference.Positions[i] = pose.Positions[i] - reference.Positions[i];
        }
    }

    /// <summary>Lays a share of a difference on a pose.</summary>
    /// <param name="difference">From <see cref="Subtract"/>.</param>
    /// <param name="weight">1 for all of it, 0 for nothing; beyond these it goes on, negative numbers turn back.</param>
    /// <param name="pose">A local pose, changed in place.</param>
    /// <exception cref="ArgumentException">The poses differ in length, or a number is not finite.</exception>
    public static void Add(in Pose difference, float weight, in Pose pose) => Add(difference, weight, ReadOnlySpan<float>.Empty, pose);

    /// <summary>Lays a share of a difference on a pose, with a weight for every joint.</summary>
    /// <param name="difference">From <see cref="Subtract"/>.</param>
    /// <param name="weight">Multiplied with each joint's own.</param>
    /// <param name="mask">One factor per joint; empty for 1 everywhere.</param>
    /// <param name="pose">A local pose, changed in place.</param>
    /// <exception cref="ArgumentException">The poses or the mask differ in length, or a number is not finite.</exception>
    public static void Add(in Pose difference, float weight, ReadOnlySpan<float> mask, in Pose pose)
    {
        Finite.Require(weight, nameof(weight));
        PoseCheck.SameLength(difference, pose);
        int count = pose.Rotations.Length;
        PoseCheck.Mask(mask, count);
        for (int i = 0; i < count; i++)
        {
            float t = mask.IsEmpty ? weight : weight * mask[i];
            if (t == 0f)
            {
                continue;
            }

            Quaternion turn = difference.Rotations[i];
            Quaternion before = pose.Rotations[i];
            Vector3 shift = difference.Positions[i];
            if ((t + (turn.X + turn.Y + turn.Z + turn.W) + (before.X + before.Y + before.Z + before.W) + (shift.X + shift.Y + shift.Z)) * 0f != 0f)
            {
                throw PoseCheck.NotFinite(i);
            }

            if (t != 1f)
            {
                turn = Rotation.Slerp(Quaternion.Identity, turn, t);
            }

            pose.Rotations[i] = Rotation.Normalize(Rotation.Multiply(before, turn));
            pose.Positions[i] += shift * t;
        }
    }
}
