using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
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

    /// <summary>What the first joint's weight is before anything is added; no sum of weights is negative.</summary>
    private const float Untouched = -1f;

    /// <summary>What the second joint's weight is as long as all have the first joint's: poses without masks need not add to each joint's, nor divide by each.</summary>
    private const float Even = -2f;

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
        if (totals.Length > 0)
        {
            totals[0] = Untouched;
        }
    }

    /// <summary>Whether nothing has been added: the first pose is then written and not added to noughts, which saves a walk over the result.</summary>
    private bool IsUntouched => totals.Length > 0 && totals[0] == Untouched;

    private bool IsEven => totals.Length > 1 && totals[1] == Even;

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

        ClearIfUntouched();
        SpreadIfEven();
        for (int i = 0; i < count; i++)
        {
            Finite.RequireWithin(mask[i], 0f, 1f, nameof(mask));
            float w = weight * mask[i];
            Add(pose.Rotations[i], w, ref result.Rotations[i]);
            result.Positions[i] += Vec.Scale(pose.Positions[i], w);
            totals[i] += w;
        }
    }

    private void ClearIfUntouched()
    {
        if (IsUntouched)
        {
            result.Rotations.Clear();
            result.Positions.Clear();
            totals.Clear();
        }
    }

    /// <summary>Gives each joint the weight that all have.</summary>
    private void SpreadIfEven()
    {
        if (IsEven)
        {
            totals.Fill(totals[0]);
        }
    }

    private void AddEvenly(in Pose pose, float weight)
    {
        if (IsUntouched)
        {
            WeightedSums.Begin(MemoryMarshal.Cast<Quaternion, float>(result.Rotations), MemoryMarshal.Cast<Quaternion, float>(pose.Rotations), weight);
            WeightedSums.Begin(MemoryMarshal.Cast<Vector3, float>(result.Positions), MemoryMarshal.Cast<Vector3, float>(pose.Positions), weight);
            totals[0] = weight;
            if (totals.Length > 1)
            {
                totals[1] = Even;
            }

            return;
        }

        WeightedSums.Add(MemoryMarshal.Cast<Vector3, float>(result.Positions), MemoryMarshal.Cast<Vector3, float>(pose.Positions), weight);
        WeightedSums.Add(IsEven ? totals.Slice(0, 1) : totals, weight);
        int first = 0;
#if NET
        if (EightVectors.Pay)
        {
            first = RotationSums.Add(pose.Rotations, weight, result.Rotations);
        }
#endif
        for (int i = first; i < totals.Length; i++)
        {
            Add(pose.Rotations[i], weight, ref result.Rotations[i]);
        }
    }

    /// <summary>Adds a rotation to a sum, on its side.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Add(Quaternion q, float weight, ref Quaternion sum)
    {
        float dot = ((sum.X * q.X) + (sum.Y * q.Y)) + ((sum.Z * q.Z) + (sum.W * q.W));
        float s = dot < 0f ? -weight : weight;
        sum.X += q.X * s;
        sum.Y += q.Y * s;
        sum.Z += q.Z * s;
        sum.W += q.W * s;
    }

    /// <summary>Divides by the weights; the result is a pose now.</summary>
    /// <param name="fallback">For joints whose weights add up to less than <see cref="MinTotal"/>; usually the rest pose.</param>
    /// <exception cref="ArgumentException">The fallback is of another length, or a pose had a number that is not finite.</exception>
    public void Finish(in Pose fallback)
    {
        PoseCheck.SameLength(fallback, result);
        ClearIfUntouched();
        float nought = 0f;
        int i = 0;
#if NET
        if (EightVectors.Pay && IsEven && totals[0] >= MinTotal)
        {
            i = RotationSums.FinishEvenly(totals[0], result, ref nought);
        }
#endif
        SpreadIfEven();
        while (i < totals.Length)
        {
#if NET
            if (EightVectors.Pay)
            {
                i += RotationSums.Finish(i, totals, result, ref nought);
            }
#endif
            for (int end = Math.Min(i + 8, totals.Length); i < end; i++)
            {
                nought += FinishOne(i, fallback);
            }
        }

        if (nought != 0f)
        {
            PoseCheck.Refuse(result, ReadOnlySpan<float>.Empty);
        }
    }

    /// <summary>Divides one joint by its weight; gives 0, or NaN if it is not finite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
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
            p += Vec.Scale(fallback.Positions[joint], rest);
            total = MinTotal;
        }

        float squared = ((q.X * q.X) + (q.Y * q.Y)) + ((q.Z * q.Z) + (q.W * q.W));
        float scale = 1f / (float)Math.Sqrt(squared);
        q = new Quaternion(q.X * scale, q.Y * scale, q.Z * scale, q.W * scale);
        p = Vec.Scale(p, 1f / total);
        result.Rotations[joint] = q;
        result.Positions[joint] = p;

        // A length that is nought or infinite leaves no rotation.
        return (squared + scale + (p.X + p.Y + p.Z)) * 0f;
    }
}
