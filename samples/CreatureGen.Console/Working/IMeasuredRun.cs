using System;
using System.Collections.Generic;
using System.Text.Json;
using CreatureGen.Anatomy;

namespace CreatureGen.Console.Working;

/// <summary>What came of measuring a creature once.</summary>
/// <typeparam name="TSelf">The kind of run.</typeparam>
internal interface IMeasuredRun<TSelf>
    where TSelf : IMeasuredRun<TSelf>
{
    /// <summary>The figures of all runs of the kind, in the order of the JSON.</summary>
    static abstract IReadOnlyList<Measure<TSelf>> Measures { get; }

    /// <summary>Those of them that a table shows, from left to right.</summary>
    static abstract IReadOnlyList<MeasureColumn<TSelf>> Columns { get; }

    /// <summary>The row of a table that it counts to.</summary>
    MeasureRow Row { get; }

    /// <summary>Writes which run it is, into an open object.</summary>
    void WriteName(Utf8JsonWriter json);

    /// <summary>Writes what is known of it beside its name and its figures, into an open object.</summary>
    void WriteFacts(Utf8JsonWriter json);
}

/// <summary>A column of a table of runs.</summary>
/// <typeparam name="TRun">The kind of run.</typeparam>
/// <param name="Heading">Above it.</param>
/// <param name="Measure">What stands in it.</param>
/// <param name="Text">How a figure is written.</param>
internal sealed record MeasureColumn<TRun>(string Heading, Measure<TRun> Measure, Func<float, string> Text);

/// <summary>A row of a table of runs: all that do the same on the same ground.</summary>
/// <param name="Kind">Of the creatures.</param>
/// <param name="Act">What they do.</param>
/// <param name="Ground">What they go on.</param>
internal readonly record struct MeasureRow(LocomotionKind Kind, string Act, string Ground) : IComparable<MeasureRow>
{
    /// <inheritdoc/>
    public int CompareTo(MeasureRow other) =>
        Kind != other.Kind ? Kind.CompareTo(other.Kind) : Act != other.Act ? string.CompareOrdinal(Act, other.Act) : string.CompareOrdinal(Ground, other.Ground);
}
