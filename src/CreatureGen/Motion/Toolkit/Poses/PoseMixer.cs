using System;
using System.Numerics;
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

        ReadOnlySpan<Quaternion> from = pose.Rotations.Slice(0, count);
        ReadOnlySpan<Vector3> places = pose.Positions.Slice(0, count);
        Span<Quaternion> rotations = result.Rotations.Slice(0, count);
        Span<Vector3> positions = result.Positions.Slice(0, count);
        for (int i = 0; i < count; i++)
        {
            float w = weight;
            if (!mask.IsEmpty)
            {
                w = weight * mask[i];
                Finite.RequireWithin(mask[i], 0f, 1f, nameof(mask));
            }

            ref readonly Quaternion q = ref from[i];
            ref Quaternion sum = ref rotations[i];
            float dot = (sum.X * q.X) + (sum.Y * q.Y) + (sum.Z * q.Z) + (sum.W * q.W);
            float s = dot < 0f ? -w : w;
            sum.X += q.X * s;
            sum.Y += q.Y * s;
            sum.Z += q.Z * s;
            sum.W += q.W * s;
            positions[i] += places[i] * w;
            totals[i] += w;
        }
    }

    /// <summary>Divides by the weights; the result is a pose now.</summary>
    /// <param name="fallback">For joints whose weights add up to less than <see cref="MinTotal"/>; usually the rest pose.</param>
    /// <exception cref="ArgumentException">The fallback is of another length, or a pose had a number that is not finite.</exception>
    public void Finish(in Pose fallback)
    {
        PoseCheck.SameLength(fallback, result);
        float nought = 0f;
        for (int i = 0; i < totals.Length; i++)
        {
            float total = totals[i];
            Quaternion q = result.Rotations[i];
            Vector3 p = result.Positions[i];
            if (total < MinTotal)
            {
                Quaternion f = fallback.Rotations[i];
                float rest = MinTotal - total;
                float s = (q.X * f.X) + (q.Y * f.Y) + (q.Z * f.Z) + (q.W * f.W) < 0f ? -rest : rest;
                q = new Quaternion(q.X + (f.X * s), q.Y + (f.Y * s), q.Z + (f.Z * s), q.W + (f.W * s));
                p += fallback.Positions[i] * rest;
                total = MinTotal;
            }

            float scale = 1f / (float)Math.Sqrt((q.X * q.X) + (q.Y * q.Y) + (q.Z * q.Z) + (q.W * q.W));
            q = new Quaternion(q.X * scale, q.Y * scale, q.Z * scale, q.W * scale);
            p *= 1f / total;
            nought += ((q.X + q.Y + q.Z + q.W) + (p.X + p.Y + p.Z)) * 0f;
            result.Rotations[i] = q;
            result.Positions[i] = p;
        }

        if (nought != 0f)
        {
            PoseCheck.Refuse(result, ReadOnlySpan<float>.Empty);
        }
    }
}
