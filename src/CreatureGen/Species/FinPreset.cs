using System;
using CreatureGen.Anatomy;

namespace CreatureGen.Species;

/// <summary>A fin or pair of fins of a species' own.</summary>
internal readonly struct FinSitePreset
{
    public FinSitePreset(FinPlace place, FinStyle style, int ring, double segment, int rows, (double Min, double Max) length, (double Min, double Max) width, double drop, double sweep)
    {
        Place = place;
        Style = style;
        Ring = ring;
        Segment = segment;
        Rows = rows;
        Length = length;
        Width = width;
        Drop = drop;
        Sweep = sweep;
    }

    public FinPlace Place { get; }

    public FinStyle Style { get; }

    /// <summary>First ring of a fin on the midline, middle ring of a pair.</summary>
    public int Ring { get; }

    /// <summary>Segment of the middle of a pair.</summary>
    public double Segment { get; }

    public int Rows { get; }

    /// <summary>Metres.</summary>
    public (double Min, double Max) Length { get; }

    /// <summary>Depth of a paired fin relative to its length.</summary>
    public (double Min, double Max) Width { get; }

    public double Drop { get; }

    public double Sweep { get; }
}

/// <summary>The fins and the tail of a species.</summary>
internal sealed record FinPreset
{
    public FinSitePreset[] Fins { get; init; } = Array.Empty<FinSitePreset>();

    public TailStyle Tail { get; init; }

    /// <summary>Metres.</summary>
    public (double Min, double Max) TailSize { get; init; }

    public (double Min, double Max) TailFork { get; init; }

    public double TailLobe { get; init; }
}
