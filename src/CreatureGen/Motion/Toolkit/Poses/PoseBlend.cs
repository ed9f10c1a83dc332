using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Poses;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

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
        float nought = mask.IsEmpty
            ? Mix(Rows(from.Rotations), Rows(to.Rotations), from.Positions, to.Positions, weight, MemoryMarshal.Cast<Quaternion, Vector4>(result.Rotations), result.Positions)
            : Mix(Rows(from.Rotations), Rows(to.Rotations), from.Positions, to.Positions, weight, mask, MemoryMarshal.Cast<Quaternion, Vector4>(result.Rotations), result.Positions);
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
            Vector3 p = Vec.Scale(from.Positions[i], 1f - weight) + Vec.Scale(to.Positions[i], weight);
            nought += ((a.X + a.Y + a.Z + a.W) + (b.X + b.Y + b.Z + b.W) + (p.X + p.Y + p.Z)) * 0f;
            result.Rotations[i] = Rotation.Slerp(a, b, weight);
            result.Positions[i] = p;
            if (nought != 0f)
            {
                throw PoseCheck.NotFinite(i);
            }
        }
    }

    private static ReadOnlySpan<Vector4> Rows(Span<Quaternion> rotations) => MemoryMarshal.Cast<Quaternion, Vector4>(rotations);

    private static float Mix(ReadOnlySpan<Vector4> a, ReadOnlySpan<Vector4> b, ReadOnlySpan<Vector3> p, ReadOnlySpan<Vector3> q, float weight, Span<Vector4> rotations, Span<Vector3> positions)
    {
        int count = a.Length;
        b = b.Slice(0, count);
        p = p.Slice(0, count);
        q = q.Slice(0, count);
        rotations = rotations.Slice(0, count);
        positions = positions.Slice(0, count);
        float nought = WeightedSums.Mix(MemoryMarshal.Cast<Vector3, float>(p), 1f - weight, MemoryMarshal.Cast<Vector3, float>(q), weight, MemoryMarshal.Cast<Vector3, float>(positions));
        int first = 0;
#if NET
        if (EightVectors.Pay)
        {
            first = RotationBlend.Between(a, b, weight, rotations, ref nought);
        }
#endif
        for (int i = first; i < count; i++)
        {
            nought += Between(a[i], b[i], weight, out rotations[i]);
        }

        return nought;
    }

    private static float Mix(ReadOnlySpan<Vector4> a, ReadOnlySpan<Vector4> b, ReadOnlySpan<Vector3> p, ReadOnlySpan<Vector3> q, float weight, ReadOnlySpan<float> mask, Span<Vector4> rotations, Span<Vector3> positions)
    {
        float nought = 0f;
        for (int i = 0; i < a.Length; i++)
        {
            float t = weight * Scalar.Clamp(mask[i], 0f, 1f);
            nought += Between(a[i], b[i], t, out rotations[i]);
            Vector3 place = Vec.Scale(p[i], 1f - t) + Vec.Scale(q[i], t);
            nought += (place.X + place.Y + place.Z) * 0f;
            positions[i] = place;
        }

        return nought;
    }

    /// <summary>The unit quaternion between two; 0, or NaN if it is none. By component, which is exact on every platform.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Between(Vector4 a, Vector4 b, float t, out Vector4 result)
    {
        Vector4 product = a * b;
        float v = (product.X + product.Y) + (product.Z + product.W) < 0f ? -t : t;

        // Numbers in all four places: an operator that takes one is a call in browsers.
        Vector4 sum = (a * new Vector4(1f - t)) + (b * new Vector4(v));
        Vector4 squares = sum * sum;
        float squared = (squares.X + squares.Y) + (squares.Z + squares.W);
        float scale = 1f / (float)Math.Sqrt(squared);
        result = sum * new Vector4(scale);

        // A length that is nought or infinite leaves no rotation.
        return (squared + scale) * 0f;
    }
}
