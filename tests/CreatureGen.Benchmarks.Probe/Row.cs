using System;
using System.Diagnostics;

namespace CreatureGen.Benchmarks.Probe;

/// <summary>Work on some items, each done and timed alone.</summary>
/// <param name="items">What is done on each.</param>
/// <param name="operations">How many operations that is, of which one is told.</param>
internal sealed class Row(Action[] items, int operations = 1)
{
    /// <summary>Nanoseconds of an operation of each item, done once.</summary>
    public double[] Round()
    {
        double[] times = new double[items.Length];
        for (int i = 0; i < items.Length; i++)
        {
            long start = Stopwatch.GetTimestamp();
            items[i]();
            times[i] = (Stopwatch.GetTimestamp() - start) * (1e9 / Stopwatch.Frequency) / operations;
        }

        return times;
    }
}
