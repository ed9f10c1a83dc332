using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>What came of reading options: either the options or what is wrong with their text.</summary>
public sealed class OptionsReading
{
    internal OptionsReading(CreatureOptions? options, IReadOnlyList<Problem> problems)
    {
        Options = problems.Count == 0 ? options : null;
        Problems = problems;
    }

    /// <summary>The options, valid in all their fields; null if there is any problem.</summary>
    public CreatureOptions? Options { get; }

    /// <summary>All problems; empty if there are options.</summary>
    public IReadOnlyList<Problem> Problems { get; }

    /// <summary>The options.</summary>
    /// <exception cref="InvalidOperationException">There are none; the message tells all problems.</exception>
    public CreatureOptions GetOptions() =>
        Options ?? throw new InvalidOperationException("these options cannot be read:\n" + string.Join("\n", Problems));
}
