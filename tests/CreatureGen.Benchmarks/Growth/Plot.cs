using System.Collections.Generic;

namespace CreatureGen.Benchmarks.Growth;

/// <summary>A cost against what it grows with.</summary>
/// <param name="Title">What is asked.</param>
/// <param name="Across">What it grows with.</param>
/// <param name="Up">The cost and its unit.</param>
/// <param name="Scale">How the numbers across are spaced.</param>
/// <param name="Series">One or more courses.</param>
internal sealed record Plot(string Title, string Across, string Up, PlotScale Scale, IReadOnlyList<PlotSeries> Series);

/// <summary>One course of a cost.</summary>
/// <param name="Name">What it is of.</param>
/// <param name="Points">Of what, and how much.</param>
internal sealed record PlotSeries(string Name, IReadOnlyList<(double Of, double Cost)> Points);

/// <summary>How a plot's numbers are spaced.</summary>
internal enum PlotScale
{
    /// <summary>By their differences; points are single measurements.</summary>
    Scatter,

    /// <summary>By their differences, joined by lines.</summary>
    Linear,

    /// <summary>By their ratios, joined by lines.</summary>
    Logarithmic,
}
