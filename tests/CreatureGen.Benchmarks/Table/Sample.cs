using System;
using System.Collections.Generic;

namespace CreatureGen.Benchmarks.Table;

/// <summary>Measured values of one thing, in the order they were measured.</summary>
internal sealed class Sample
{
    private readonly List<double> values = new();

    public void Add(double value) => values.Add(value);

    public double Median => At(0.5);

    public double P99 => At(0.99);

    private double At(double share)
    {
        double[] sorted = values.ToArray();
        Array.Sort(sorted);
        return sorted.Length == 0 ? 0 : sorted[(int)Math.Min(sorted.Length - 1, share * sorted.Length)];
    }
}
