using System;
using System.Collections.Generic;

namespace CreatureGen.Events;

/// <summary>The strokes of a sweep, and the moment at which each begins.</summary>
internal static class Strokes
{
    /// <summary>Adds the moments of a curve.</summary>
    /// <param name="curve">Its signal is the speed of the sweep from each sample to the next.</param>
    /// <param name="number">Of the curve.</param>
    /// <param name="rule">With a sweep.</param>
    /// <param name="edge">What lies beyond the ends.</param>
    /// <param name="moments">Gets the moments.</param>
    public static void Find(AngularCurve curve, int number, AngularRule rule, ClipEdge edge, List<Moment> moments)
    {
        AngularSweep sweep = rule.Sweep!;
        ReadOnlySpan<float> speeds = curve.Signal;
        int fastestBack = 0;
        for (int i = 0; i < speeds.Length; i++)
        {
            fastestBack = speeds[i] < speeds[fastestBack] ? i : fastestBack;
        }

        float min = (float)rule.Threshold;
        float returns = sweep.ReturnsAt * speeds[fastestBack];
        if (returns >= 0f || -returns < sweep.ReturnsAt * min)
        {
            return;
        }

        float begins = Math.Max(min, sweep.BeginsAt * Usual(speeds, min));
        List<Stretch> stretches = edge == ClipEdge.Joined
            ? Stretches(speeds, fastestBack, begins, returns, true)
            : Stretches(speeds, 0, begins, returns, false);
        float farthest = 0f;
        for (int i = 0; i < stretches.Count; i++)
        {
            farthest = Math.Max(farthest, Swept(stretches, i, out _));
        }

        for (int i = 0; i < stretches.Count; i++)
        {
            if (stretches[i].IsFirst && Swept(stretches, i, out float longest) >= sweep.MinPart * farthest)
            {
                int k = i;
                while (stretches[k].Swept < sweep.MinPart * longest)
                {
                    k++;
                }

                float at = edge == ClipEdge.Joined ? stretches[k].At % speeds.Length : stretches[k].At;
                moments.Add(new Moment(number, at / curve.Rate, begins > 0f ? stretches[k].Fastest / begins : 1f));
            }
        }
    }

    /// <summary>The stretches above a speed, in order. Between two of one stroke the limb did not go the other way as fast as <paramref name="returns"/>.</summary>
    private static List<Stretch> Stretches(ReadOnlySpan<float> speeds, int start, float begins, float returns, bool returned)
    {
        var stretches = new List<Stretch>();
        bool above = false;
        for (int k = 0; k < speeds.Length; k++)
        {
            float speed = speeds[(start + k) % speeds.Length];
            if (speed < begins)
            {
                above = false;
                returned |= speed <= returns;
                continue;
            }

            if (!above && (returned || stretches.Count > 0))
            {
                // A speed is that of the middle between two samples.
                float before = speeds[(start + k + speeds.Length - 1) % speeds.Length];
                float over = before < begins ? (speed - begins) / (speed - before) : 0f;
                stretches.Add(new Stretch { At = start + k + 0.5f - over, IsFirst = returned });
                above = true;
                returned = false;
            }

            if (above)
            {
                Stretch grown = stretches[stretches.Count - 1];
                grown.Swept += speed;
                grown.Fastest = Math.Max(grown.Fastest, speed);
                stretches[stretches.Count - 1] = grown;
            }
        }

        return stretches;
    }

    /// <summary>How far the stroke that begins with a stretch sweeps, and the longest of its stretches.</summary>
    private static float Swept(List<Stretch> stretches, int first, out float longest)
    {
        float all = longest = 0f;
        for (int i = first; i < stretches.Count && (i == first || !stretches[i].IsFirst); i++)
        {
            all += stretches[i].Swept;
            longest = Math.Max(longest, stretches[i].Swept);
        }

        return all;
    }

    /// <summary>The median of the speeds of sweeping that are not too small to count.</summary>
    private static float Usual(ReadOnlySpan<float> speeds, float min)
    {
        var sweeping = new List<float>();
        foreach (float speed in speeds)
        {
            if (speed > min)
            {
                sweeping.Add(speed);
            }
        }

        sweeping.Sort();
        return sweeping.Count > 0 ? sweeping[sweeping.Count / 2] : 0f;
    }

    private struct Stretch
    {
        /// <summary>Where it begins, samples.</summary>
        public float At;

        /// <summary>Sum of its speeds.</summary>
        public float Swept;

        /// <summary>Its greatest speed.</summary>
        public float Fastest;

        /// <summary>Whether the limb has gone the other way before it.</summary>
        public bool IsFirst;
    }
}
