using System;
using System.Collections.Generic;

namespace CreatureGen.Events;

/// <summary>Lists of moments: merged, and thinned out to one in an interval.</summary>
public static class Moments
{
    /// <summary>Numbers of frames in ascending order, each once: 0, 4, 4, 4, 8, 10, 11 becomes 0, 4, 8, 10, 11.</summary>
    public static IReadOnlyList<int> Merge(IEnumerable<int> frames)
    {
        var sorted = new List<int>(frames ?? throw new ArgumentNullException(nameof(frames)));
        sorted.Sort();
        var merged = new List<int>();
        foreach (int frame in sorted)
        {
            if (merged.Count == 0 || merged[merged.Count - 1] != frame)
            {
                merged.Add(frame);
            }
        }

        return merged;
    }

    /// <summary>Leaves at most one moment in an interval.</summary>
    /// <param name="times">Seconds, ascending.</param>
    /// <param name="strengths">One for each time.</param>
    /// <param name="interval">Seconds; moments nearer than this to one that stays go.</param>
    /// <param name="winner">Which one stays.</param>
    /// <param name="loop">Length of the loop that they lie in, seconds: the last is near the first. 0 for none.</param>
    /// <returns>Numbers of those that stay, ascending.</returns>
    /// <exception cref="ArgumentException">Lists differ in length, times do not ascend, or the interval is negative or not a number.</exception>
    public static IReadOnlyList<int> Thin(IReadOnlyList<float> times, IReadOnlyList<float> strengths, float interval, IntervalWinner winner, float loop)
    {
        _ = times ?? throw new ArgumentNullException(nameof(times));
        _ = strengths ?? throw new ArgumentNullException(nameof(strengths));
        if (times.Count != strengths.Count)
        {
            throw new ArgumentException(FormattableString.Invariant($"{times.Count} times and {strengths.Count} strengths; expected one of each"), nameof(strengths));
        }

        if (!(interval >= 0f && interval <= float.MaxValue))
        {
            throw new ArgumentException(FormattableString.Invariant($"an interval of {interval} s; expected a finite time not below 0"), nameof(interval));
        }

        for (int i = 1; i < times.Count; i++)
        {
            if (!(times[i] >= times[i - 1]))
            {
                throw new ArgumentException(FormattableString.Invariant($"time {i} is {times[i]} s after {times[i - 1]} s; expected ascending times"), nameof(times));
            }
        }

        int[] order = new int[times.Count];
        for (int i = 0; i < order.Length; i++)
        {
            order[i] = i;
        }

        if (winner == IntervalWinner.Strongest)
        {
            Array.Sort(order, (a, b) => strengths[a] != strengths[b] ? strengths[b].CompareTo(strengths[a]) : a.CompareTo(b));
        }

        var kept = new List<int>();
        foreach (int one in order)
        {
            if (!IsNearAny(one, kept, times, interval, loop))
            {
                kept.Add(one);
            }
        }

        kept.Sort();
        return kept;
    }

    private static bool IsNearAny(int one, List<int> kept, IReadOnlyList<float> times, float interval, float loop)
    {
        foreach (int other in kept)
        {
            float apart = Math.Abs(times[one] - times[other]);
            apart = loop > 0f ? Math.Min(apart, Math.Abs(loop - apart)) : apart;
            if (apart < interval)
            {
                return true;
            }
        }

        return false;
    }
}
