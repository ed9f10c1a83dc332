using System;

namespace CreatureGen.Console.Working;

/// <summary>Which of two figures is the worse.</summary>
internal enum WorseFigure
{
    /// <summary>The greater.</summary>
    Greater,

    /// <summary>The smaller.</summary>
    Smaller,
}

/// <summary>A figure that every run has, or has not where it does not apply.</summary>
/// <typeparam name="TRun">What was measured.</typeparam>
/// <param name="Name">In JSON. These names are a contract.</param>
/// <param name="Worse">Which of two is the worse.</param>
/// <param name="Value">Of a run; null where it does not apply.</param>
internal sealed record Measure<TRun>(string Name, WorseFigure Worse, Func<TRun, float?> Value)
{
    /// <summary>Whether a figure is worse than another.</summary>
    public bool IsWorse(float value, float than) => Worse == WorseFigure.Greater ? value > than : value < than;
}
