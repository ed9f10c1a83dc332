using System;
using System.Collections.Generic;
using CreatureGen.Maths;

namespace CreatureGen.Genetics.Populations;

/// <summary>One of the traits by which niches differ.</summary>
/// <param name="Name">A word for reports.</param>
/// <param name="Bounds">Where one niche ends and the next begins, rising; n bounds part n + 1 niches.</param>
/// <param name="Measure">The trait of a creature.</param>
public sealed record NicheAxis(string Name, IReadOnlyList<double> Bounds, Func<BodyMeasures, double> Measure)
{
    /// <summary>Number of niches along it.</summary>
    public int Count => Bounds.Count + 1;

    /// <summary>Bounds that rise by one factor from the first to the last.</summary>
    public static double[] Geometric(double first, double last, int count)
    {
        var bounds = new double[count];
        for (int i = 0; i < count; i++)
        {
            bounds[i] = first * PortableMath.Exp(PortableMath.Log(last / first) * i / Math.Max(1, count - 1));
        }

        return bounds;
    }

    /// <summary>The niche of a creature along this axis.</summary>
    public int Of(BodyMeasures measures)
    {
        double value = Measure(measures);
        int niche = 0;
        while (niche < Bounds.Count && value >= Bounds[niche])
        {
            niche++;
        }

        return niche;
    }
}

/// <summary>Niches that each have room for one creature: all combinations of some traits.</summary>
public sealed class NicheGrid
{
    private readonly NicheAxis[] axes;

    /// <summary>Crosses axes.</summary>
    /// <exception cref="ArgumentException">There is none.</exception>
    public NicheGrid(IReadOnlyList<NicheAxis> axes)
    {
        this.axes = new List<NicheAxis>(axes ?? throw new ArgumentNullException(nameof(axes))).ToArray();
        if (this.axes.Length == 0)
        {
            throw new ArgumentException("there is no axis; expected at least one", nameof(axes));
        }

        Count = 1;
        foreach (NicheAxis axis in this.axes)
        {
            Count *= axis.Count;
        }
    }

    /// <summary>Size × pairs of legs × length for the size: 4 × 5 × 5 niches.</summary>
    public static NicheGrid Default { get; } = new(new[]
    {
        new NicheAxis("size", NicheAxis.Geometric(0.3, 1, 3), m => m.Size),
        new NicheAxis("legs", new double[] { 1, 2, 3, 4 }, m => m.LegPairs),
        new NicheAxis("length", NicheAxis.Geometric(3, 6, 4), m => m.Length / m.Size),
    });

    /// <summary>The traits.</summary>
    public IReadOnlyList<NicheAxis> Axes => axes;

    /// <summary>Number of niches.</summary>
    public int Count { get; }

    /// <summary>The niche of a creature, 0 up to <see cref="Count"/>.</summary>
    public int Of(BodyMeasures measures)
    {
        int niche = 0;
        foreach (NicheAxis axis in axes)
        {
            niche = (niche * axis.Count) + axis.Of(measures);
        }

        return niche;
    }
}
