using System;
using System.Collections.Generic;
using CreatureGen.Maths;

namespace CreatureGen.Events;

/// <summary>Stretches of a curve above a threshold, and the moment of each.</summary>
internal static class Chunks
{
    /// <summary>Part of the highest peak that a last peak has at least.</summary>
    private const float LastPeakFraction = 0.5f;

    /// <summary>Adds the moments of a curve.</summary>
    /// <param name="curve">What is looked at.</param>
    /// <param name="number">Of the curve.</param>
    /// <param name="max">The greatest value that the rule's fraction is of.</param>
    /// <param name="rule">What to look for.</param>
    /// <param name="edge">What lies beyond the ends.</param>
    /// <param name="moments">Gets the moments.</param>
    public static void Find(AngularCurve curve, int number, float max, AngularRule rule, ClipEdge edge, List<Moment> moments)
    {
        ReadOnlySpan<float> a = curve.Signal;
        float threshold = Math.Max((float)rule.Threshold, rule.ThresholdFraction * max);
        int gap = (int)(rule.ChunkGap * curve.Rate);
        float quiet = Math.Max(rule.Quiet, rule.QuietFraction * LongestQuiet(a, threshold, out int behind) / curve.Rate);
        int start = edge == ClipEdge.Joined ? behind : 0;
        int first = -1;
        int last = -1;
        for (int k = 0; k < a.Length; k++)
        {
            if (Math.Abs(a[(start + k) % a.Length]) < threshold)
            {
                continue;
            }

            if (first >= 0 && k - last - 1 > gap)
            {
                Add(first, last, k);
                first = -1;
            }

            first = first < 0 ? k : first;
            last = k;
        }

        if (first >= 0)
        {
            // Around a loop the first stretch comes again; at an open end nothing does.
            Add(first, last, edge == ClipEdge.Joined ? a.Length + FirstAbove(a, start, threshold) : int.MaxValue);
        }

        void Add(int from, int to, int next)
        {
            ReadOnlySpan<float> values = curve.Signal;
            int best = PeakOf(values, start, from, to, threshold, rule.Peak);
            if (best >= 0 && (next == int.MaxValue || (next - to - 1) / curve.Rate >= quiet))
            {
                moments.Add(At(curve, (start + best) % values.Length, number, threshold, edge));
            }
        }
    }

    /// <summary>The greatest value of a curve.</summary>
    public static float MaxOf(AngularCurve curve)
    {
        float max = 0f;
        foreach (float one in curve.Signal)
        {
            max = Math.Max(max, one);
        }

        return max;
    }

    /// <summary>The sample that the moment of a stretch is at, −1 if no change in it counts.</summary>
    private static int PeakOf(ReadOnlySpan<float> a, int start, int from, int to, float threshold, AngularPeak peak)
    {
        int best = -1;
        for (int k = from; k <= to; k++)
        {
            float value = a[(start + k) % a.Length];
            best = value >= threshold && value > 0f && (best < 0 || value > a[(start + best) % a.Length]) ? k : best;
        }

        if (best < 0 || peak == AngularPeak.Highest)
        {
            return best;
        }

        float min = Math.Max(threshold, LastPeakFraction * a[(start + best) % a.Length]);
        for (int k = to; k > best; k--)
        {
            float value = a[(start + k) % a.Length];
            if (value >= min && value >= a[(start + k - 1) % a.Length] && value >= a[(start + k + 1) % a.Length])
            {
                return k;
            }
        }

        return best;
    }

    private static int FirstAbove(ReadOnlySpan<float> a, int start, float threshold)
    {
        int k = 0;
        while (k < a.Length - 1 && Math.Abs(a[(start + k) % a.Length]) < threshold)
        {
            k++;
        }

        return k;
    }

    /// <summary>Number of samples of the longest quiet of a curve that goes around, and where it ends: a walk from there cuts no stretch.</summary>
    private static int LongestQuiet(ReadOnlySpan<float> a, float threshold, out int behind)
    {
        int longest = 0;
        behind = 0;
        int run = 0;
        for (int k = 0; k < 2 * a.Length; k++)
        {
            run = Math.Abs(a[k % a.Length]) < threshold ? run + 1 : 0;
            if (run > longest)
            {
                longest = run;
                behind = (k + 1) % a.Length;
            }
        }

        return Math.Min(longest, a.Length);
    }

    /// <summary>The top of the parabola through a maximum and its neighbours, at most half a sample away.</summary>
    private static Moment At(AngularCurve curve, int i, int number, float threshold, ClipEdge edge)
    {
        ReadOnlySpan<float> a = curve.Signal;
        float shift = 0f;
        if (edge == ClipEdge.Joined || (i > 0 && i < a.Length - 1))
        {
            float before = Math.Max(a[(i + a.Length - 1) % a.Length], 0f);
            float after = Math.Max(a[(i + 1) % a.Length], 0f);
            float curvature = before - (2f * a[i]) + after;
            shift = curvature < 0f ? Scalar.Clamp(0.5f * (before - after) / curvature, -0.5f, 0.5f) : 0f;
        }

        return new Moment(number, Math.Max(i + shift + curve.Place, 0f) / curve.Rate, threshold > 0f ? a[i] / threshold : 1f);
    }
}
