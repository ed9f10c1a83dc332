using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Animation.Poses;

/// <summary>The pose between two poses, joint by joint. Nothing is allocated.</summary>
/// <remarks>
/// <para>Rotations go the shorter way round. <see cref="Mix(in Pose, in Pose, float, in Pose)"/> takes the straight line between the two unit quaternions and brings it back to unit length
/// (nlerp): the same path as the arc, faster in its middle, by 8° at most and only between rotations 180° apart. <see cref="Slerp"/> keeps an even speed at about ten times the cost.
/// Positions go in straight lines. Between quaternions 180° apart both ways round are equally short; the way of positive product is taken.</para>
/// <para>Based on: K. Shoemake, "Animating rotation with quaternion curves" (1985); J. Blow, "Understanding slerp, then not using it" (2004).</para>
/// </remarks>
public static class PoseBlend
{
    /// <summary>The pose at <paramref name="weight"/> of the way from one pose to another.</summary>
    /// <param name="from">Weight 0; a local pose, or any pose of independent joints.</param>
    /// <param name="to">Weight 1.</param>
    /// <param name="weight">0..1; numbers beyond count as the nearer end.</param>
    /// <param name="result">Receives the pose; may lie over the same spans as either.</param>
    /// <exception cref="ArgumentException">The poses differ in length, or a number is not finite.</exception>
    public static void Mix(in Pose from, in Pose to, float weight, in Pose result) => Mix(from, to, weight, ReadOnlySpan<float>.Empty, result);

    /// <summary>The pose between two poses, with a weight for every joint.</summary>
    /// <param name="from">Weight 0.</param>
    /// <param name="to">Weight 1.</param>
    /// <param name="weight">0..1, multiplied with each joint's own.</param>
    /// <param name="mask">0..1, one per joint; empty for 1 everywhere.</param>
    /// <param name="result">Receives the pose; may lie over the same spans as either.</param>
    /// <exception cref="ArgumentException">The poses or the mask differ in length, or a number is not finite.</exception>
    public static void Mix(in Pose from, in Pose to, float weight, ReadOnlySpan<float> mask, in Pose result)
    {
        Finite.Require(weight, nameof(weight));
        PoseCheck.SameLength(from, to);
        PoseCheck.SameLength(from, result);
        int count = from.Rotations.Length;
        PoseCheck.Mask(mask, count);
        weight = Scalar.Clamp(weight, 0f, 1f);
        ReadOnlySpan<Quaternion> a = from.Rotations;
        ReadOnlySpan<Quaternion> b = to.Rotations.Slice(0, count);
        ReadOnlySpan<Vector3> p = from.Positions.Slice(0, count);
        ReadOnlySpan<Vector3> q = to.Positions.Slice(0, count);
        Span<Quaternion> rotations = result.Rotations.Slice(0, count);
        Span<Vector3> positions = result.Positions.Slice(0, count);
        float nought = 0f;
        for (int i = 0; i < count; i++)
        {
            float t = mask.IsEmpty ? weight : weight * Scalar.Clamp(mask[i], 0f, 1f);
            ref readonly Quaternion x = ref a[i];
            ref readonly Quaternion y = ref b[i];
            float dot = (x.X * y.X) + (x.Y * y.Y) + (x.Z * y.Z) + (x.W * y.W);
            float u = 1f - t;
            float v = dot < 0f ? -t : t;
            float qx = (x.X * u) + (y.X * v);
            float qy = (x.Y * u) + (y.Y * v);
            float qz = (x.Z * u) + (y.Z * v);
            float qw = (x.W * u) + (y.W * v);
            float squared = (qx * qx) + (qy * qy) + (qz * qz) + (qw * qw);
            float scale = 1f / (float)Math.Sqrt(squared);
            nought += scale * 0f;
            rotations[i] = new Quaternion(qx * scale, qy * scale, qz * scale, qw * scale);
            Vector3 place = (p[i] * u) + (q[i] * t);
            nought += (place.X + place.Y + place.Z) * 0f;
            positions[i] = place;
        }

        if (nought != 0f)
        {
            PoseCheck.Refuse(result, mask);
        }
    }

    /// <summary>The pose at <paramref name="weight"/> of the way from one pose to another, every joint at even speed along its arc.</summary>
    /// <param name="from">Weight 0.</param>
    /// <param name="to">Weight 1.</param>
    /// <param name="weight">0..1; numbers beyond count as the nearer end.</param>
    /// <param name="result">Receives the pose; may lie over the same spans as either.</param>
    /// <exception cref="ArgumentException">The poses differ in length, or a number is not finite.</exception>
    public static void Slerp(in Pose from, in Pose to, float weight, in Pose result)
    {
        Finite.Require(weight, nameof(weight));
        PoseCheck.SameLength(from, to);
        PoseCheck.SameLength(from, result);
        weight = Scalar.Clamp(weight, 0f, 1f);
        float nought = 0f;
        for (int i = 0; i < from.Rotations.Length; i++)
        {
            Quaternion a = from.Rotations[i];
            Quaternion b = to.Rotations[i];
            Vector3 p = (from.Positions[i] * (1f - weight)) + (to.Positions[i] * weight);
            nought += ((a.X + a.Y + a.Z + a.W) + (b.X + b.Y + b.Z + b.W) + (p.X + p.Y + p.Z)) * 0f;
            result.Rotations[i] = Rotation.Slerp(a, b, weight);
            result.Positions[i] = p;
            if (nought != 0f)
            {
                throw PoseCheck.NotFinite(i);
            }
        }
    }
}
