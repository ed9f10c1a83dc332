using System;
using System.Numerics;
#if NET
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
#endif
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Poses;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>
/// The weighted mean of any number of poses: created over a result and scratch weights of the caller, fed with <see cref="Add(in Pose, float)"/>, and closed with <see cref="Finish"/>.
/// Until then the result holds unfinished sums. Nothing is allocated.
/// </summary>
/// <remarks>
/// <para>Weights need not add up to one: they are divided by their sum, joint by joint. Rotations are added as quaternions on the same side as the sum so far, and brought to unit length
/// (so two poses give exactly <see cref="PoseBlend.Mix(in Pose, in Pose, float, in Pose)"/> but for rounding).</para>
/// <para>Based on: ozz-animation's BlendingJob (G. Blanc) for the threshold; F. L. Markley et al., "Averaging quaternions" (2007), whose mean this approaches for rotations near each other.</para>
/// </remarks>
public readonly ref struct PoseMixer
{
    /// <summary>Where the weights of a joint add up to less than this, the fallback makes up for the rest, so that layers fade in and out without a jump.</summary>
    public const float MinTotal = 0.1f;

    private readonly Pose result;
    private readonly Span<float> totals;

    /// <summary>Starts a mean at nothing.</summary>
    /// <param name="result">Receives the mean; must not lie over the spans of a pose to be added or of the fallback.</param>
    /// <param name="totals">Scratch, one number per joint.</param>
    /// <exception cref="ArgumentException">The scratch has another length than the pose.</exception>
    public PoseMixer(Pose result, Span<float> totals)
    {
        if (totals.Length != result.Rotations.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"scratch for {totals.Length} joints; expected {result.Rotations.Length} like the pose"), nameof(totals));
        }

        this.result = result;
        this.totals = totals;
        result.Rotations.Clear();
        result.Positions.Clear();
        totals.Clear();
    }

    /// <summary>Adds a pose with one weight for all joints.</summary>
    /// <param name="pose">As long as the result.</param>
    /// <param name="weight">Not negative; in proportion to the others.</param>
    /// <exception cref="ArgumentException">The weight is negative or not finite, or the pose is of another length.</exception>
    public void Add(in Pose pose, float weight) => Add(pose, weight, ReadOnlySpan<float>.Empty);

    /// <summary>Adds a pose with a weight for every joint.</summary>
    /// <param name="pose">As long as the result.</param>
    /// <param name="weight">Not negative; multiplied with each joint's own.</param>
    /// <param name="mask">One factor per joint, 0..1; empty for 1 everywhere.</param>
    /// <exception cref="ArgumentException">A weight is negative or not finite, or the pose or the mask is of another length.</exception>
    public void Add(in Pose pose, float weight, ReadOnlySpan<float> mask)
    {
        Finite.RequireWithin(weight, 0f, float.MaxValue, nameof(weight));
        PoseCheck.SameLength(pose, result);
        int count = totals.Length;
        PoseCheck.Mask(mask, count);
        if (weight == 0f)
        {
            return;
        }

        if (mask.IsEmpty)
        {
            AddEvenly(pose, weight);
            return;
        }

        for (int i = 0; i < count; i++)
        {
            Finite.RequireWithin(mask[i], 0f, 1f, nameof(mask));
            float w = weight * mask[i];
            Add(pose.Rotations[i], w, ref result.Rotations[i]);
            result.Positions[i] += pose.Positions[i] * w;
            totals[i] += w;
        }
    }

    private void AddEvenly(in Pose pose, float weight)
    {
        PlaceSums.Add(result.Positions, pose.Positions, weight);
        foreach (ref float total in totals)
        {
            total += weight;
        }

        int first = 0;
#if NET
        if (FourRotations.Pay)
        {
            AddFours(MemoryMarshal.Cast<Quaternion, Vector4>(pose.Rotations), weight, MemoryMarshal.Cast<Quaternion, Vector4>(result.Rotations));
            first = totals.Length - (totals.Length % FourRotations.Count);
        }
#endif
        for (int i = first; i < totals.Length; i++)
        {
            Add(pose.Rotations[i], weight, ref result.Rotations[i]);
        }
    }

    /// <summary>Adds a rotation to a sum, on its side.</summary>
    private static void Add(Quaternion q, float weight, ref Quaternion sum)
    {
        float dot = ((sum.X * q.X) + (sum.Y * q.Y)) + ((sum.Z * q.Z) + (sum.W * q.W));
        float s = dot < 0f ? -weight : weight;
        sum.X += q.X * s;
        sum.Y += q.Y * s;
        sum.Z += q.Z * s;
        sum.W += q.W * s;
    }

#if NET
    /// <summary>Adds the rotations of all joints but the last few that make no four.</summary>
    private static void AddFours(ReadOnlySpan<Vector4> rotations, float weight, Span<Vector4> sums)
    {
        ref Vector4 q = ref MemoryMarshal.GetReference(rotations);
        ref Vector4 s = ref MemoryMarshal.GetReference(sums);
        for (int i = 0; i <= sums.Length - FourRotations.Count; i += FourRotations.Count)
        {
            Vector128<float> q0 = FourRotations.Load(ref q, i), q1 = FourRotations.Load(ref q, i + 1), q2 = FourRotations.Load(ref q, i + 2), q3 = FourRotations.Load(ref q, i + 3);
            Vector128<float> s0 = FourRotations.Load(ref s, i), s1 = FourRotations.Load(ref s, i + 1), s2 = FourRotations.Load(ref s, i + 2), s3 = FourRotations.Load(ref s, i + 3);
            Vector128<float> dots = FourRotations.Sums(s0 * q0, s1 * q1, s2 * q2, s3 * q3);
            Vector128<float> signed = FourRotations.WithSignsOf(dots, weight);
            FourRotations.Store(s0 + (q0 * FourRotations.First(signed)), ref s, i);
            FourRotations.Store(s1 + (q1 * FourRotations.Second(signed)), ref s, i + 1);
            FourRotations.Store(s2 + (q2 * FourRotations.Third(signed)), ref s, i + 2);
            FourRotations.Store(s3 + (q3 * FourRotations.Fourth(signed)), ref s, i + 3);
        }
    }
#endif

    /// <summary>Divides by the weights; the result is a pose now.</summary>
    /// <param name="fallback">For joints whose weights add up to less than <see cref="MinTotal"/>; usually the rest pose.</param>
    /// <exception cref="ArgumentException">The fallback is of another length, or a pose had a number that is not finite.</exception>
    public void Finish(in Pose fallback)
    {
        PoseCheck.SameLength(fallback, result);
        float nought = 0f;
        for (int i = 0; i < totals.Length; i++)
        {
#if NET
            if (FourRotations.Pay && i <= totals.Length - FourRotations.Count && FinishFour(i, ref nought))
            {
                i += FourRotations.Count - 1;
                continue;
            }
#endif
            nought += FinishOne(i, fallback);
        }

        if (nought != 0f)
        {
            PoseCheck.Refuse(result, ReadOnlySpan<float>.Empty);
        }
    }

    /// <summary>Divides one joint by its weight; gives 0, or NaN if it is not finite.</summary>
    private float FinishOne(int joint, in Pose fallback)
    {
        float total = totals[joint];
        Quaternion q = result.Rotations[joint];
        Vector3 p = result.Positions[joint];
        if (total < MinTotal)
        {
            Quaternion f = fallback.Rotations[joint];
            float rest = MinTotal - total;
            float s = (q.X * f.X) + (q.Y * f.Y) + (q.Z * f.Z) + (q.W * f.W) < 0f ? -rest : rest;
            q = new Quaternion(q.X + (f.X * s), q.Y + (f.Y * s), q.Z + (f.Z * s), q.W + (f.W * s));
            p += fallback.Positions[joint] * rest;
            total = MinTotal;
        }

        float squared = ((q.X * q.X) + (q.Y * q.Y)) + ((q.Z * q.Z) + (q.W * q.W));
        float scale = 1f / (float)Math.Sqrt(squared);
        q = new Quaternion(q.X * scale, q.Y * scale, q.Z * scale, q.W * scale);
        p *= 1f / total;
        result.Rotations[joint] = q;
        result.Positions[joint] = p;

        // A length that is nought or infinite leaves no rotation.
        return (squared + scale + (p.X + p.Y + p.Z)) * 0f;
    }

#if NET
    /// <summary>Divides four joints by their weights, if none needs the fallback.</summary>
    private bool FinishFour(int first, ref float nought)
    {
        Vector128<float> weights = Vector128.LoadUnsafe(ref totals[first]);
        if (weights.GetElement(0) < MinTotal || weights.GetElement(1) < MinTotal || weights.GetElement(2) < MinTotal || weights.GetElement(3) < MinTotal)
        {
            return false;
        }

        ref Vector4 q = ref MemoryMarshal.GetReference(MemoryMarshal.Cast<Quaternion, Vector4>(result.Rotations));
        Vector128<float> q0 = FourRotations.Load(ref q, first), q1 = FourRotations.Load(ref q, first + 1), q2 = FourRotations.Load(ref q, first + 2), q3 = FourRotations.Load(ref q, first + 3);
        Vector128<float> squares = FourRotations.Sums(q0 * q0, q1 * q1, q2 * q2, q3 * q3);
        Vector128<float> scales = FourRotations.Scales(squares);
        FourRotations.Store(q0 * FourRotations.First(scales), ref q, first);
        FourRotations.Store(q1 * FourRotations.Second(scales), ref q, first + 1);
        FourRotations.Store(q2 * FourRotations.Third(scales), ref q, first + 2);
        FourRotations.Store(q3 * FourRotations.Fourth(scales), ref q, first + 3);

        // x0 y0 z0 x1, y1 z1 x2 y2, z2 x3 y3 z3
        Span<float> places = MemoryMarshal.Cast<Vector3, float>(result.Positions.Slice(first, FourRotations.Count));
        Vector128<float> shares = Vector128.Create(1f) / weights;
        Vector128<float> p0 = Vector128.LoadUnsafe(ref places[0]) * Vector128.Shuffle(shares, Vector128.Create(0, 0, 0, 1));
        Vector128<float> p1 = Vector128.LoadUnsafe(ref places[4]) * Vector128.Shuffle(shares, Vector128.Create(1, 1, 2, 2));
        Vector128<float> p2 = Vector128.LoadUnsafe(ref places[8]) * Vector128.Shuffle(shares, Vector128.Create(2, 3, 3, 3));
        p0.StoreUnsafe(ref places[0]);
        p1.StoreUnsafe(ref places[4]);
        p2.StoreUnsafe(ref places[8]);

        // A length that is nought or infinite leaves no rotation.
        nought += FourRotations.Nought(squares + scales + p0 + p1 + p2);
        return true;
    }
#endif
}
