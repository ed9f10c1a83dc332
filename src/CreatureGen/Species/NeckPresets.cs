using System;
using CreatureGen.Blueprints;

namespace CreatureGen.Species;

/// <summary>Hair of a species or a family: lengths and widths in half depths of the neck.</summary>
internal readonly struct ManePreset
{
    public ManePreset(double min, double max, params ManeBlueprint[] fields)
    {
        Min = min;
        Max = max;
        Fields = fields;
    }

    /// <summary>Least factor on its length.</summary>
    public double Min { get; }

    /// <summary>Most factor on its length.</summary>
    public double Max { get; }

    /// <summary>The fields of hair that make it up.</summary>
    public ManeBlueprint[] Fields { get; }
}

/// <summary>A collar: lengths in half widths of the head.</summary>
internal readonly struct FrillPreset
{
    public FrillPreset(double min, double max, FrillBlueprint frill)
    {
        Min = min;
        Max = max;
        Frill = frill;
    }

    /// <summary>Least factor on its length.</summary>
    public double Min { get; }

    /// <summary>Most factor on its length.</summary>
    public double Max { get; }

    public FrillBlueprint Frill { get; }
}

/// <summary>What necks wear, as data. Numbers were tuned by eye from the front, the side and behind.</summary>
internal static class NeckPresets
{
    private const double Forward = Math.PI;

    /// <summary>A ruff around neck and chest and whiskers along the jaw (lion).</summary>
    public static readonly ManePreset Ruff = new(
        0.85,
        1.2,
        new ManeBlueprint(Ring: 15.4, LastRing: 23.6, Segment: 0, LastSegment: 16, Rows: 7, Columns: 14, Length: 1.6, Growth: 1.1, Width: 0.17, Rise: 0.34, Fall: 0.65, Hang: 0.4),
        new ManeBlueprint(Ring: 15.3, LastRing: 16.8, Segment: 0, LastSegment: 13, Rows: 2, Columns: 14, Length: 1.4, Growth: 1.1, Width: 0.16, Rise: 0.9, Fall: 0.4, Hang: 0.2),
        new ManeBlueprint(Ring: 13.4, LastRing: 14.6, Segment: 6.5, LastSegment: 14.5, Rows: 2, Columns: 9, Length: 1.1, Growth: 1.15, Width: 0.13, Rise: 0.6, Fall: 0.8, Hang: 0.3));

    /// <summary>A mane that falls to both sides of the neck and a forelock (horse).</summary>
    public static readonly ManePreset Falling = new(
        0.85,
        1.2,
        new ManeBlueprint(Ring: 13.6, LastRing: 25.4, Segment: 0.3, LastSegment: 1.5, Rows: 24, Columns: 2, Length: 1.7, Growth: 0.95, Width: 0.17, Rise: 0.2, Fall: 1.1, Hang: 0),
        new ManeBlueprint(Ring: 13.2, LastRing: 25.6, Segment: 0, LastSegment: 0, Rows: 24, Columns: 1, Length: 0.85, Growth: 0.8, Width: 0.1, Rise: 0.62, Fall: 0, Hang: 0),
        new ManeBlueprint(Ring: 11.8, LastRing: 13.8, Segment: 0, LastSegment: 1.1, Rows: 4, Columns: 3, Length: 1.05, Growth: 1, Width: 0.1, Rise: 0.3, Fall: Forward, Hang: 0));

    /// <summary>A crest of bristles from the poll to behind the shoulders (hyena, boar).</summary>
    public static readonly ManePreset Bristles = new(
        0.8,
        1.25,
        new ManeBlueprint(Ring: 14, LastRing: 30, Segment: 0, LastSegment: 1.6, Rows: 22, Columns: 3, Length: 1.1, Growth: 0.75, Width: 0.12, Rise: 0.6, Fall: 0.12, Hang: 0));

    /// <summary>Shaggy shoulders, a mop between the horns and a beard (bison).</summary>
    public static readonly ManePreset Shag = new(
        0.85,
        1.2,
        new ManeBlueprint(Ring: 15, LastRing: 27, Segment: 0, LastSegment: 10.5, Rows: 7, Columns: 15, Length: 1.35, Growth: 0.65, Width: 0.13, Rise: 0.15, Fall: 0.95, Hang: 0.3),
        new ManeBlueprint(Ring: 11.8, LastRing: 14.6, Segment: 0, LastSegment: 2.4, Rows: 4, Columns: 5, Length: 0.62, Growth: 1, Width: 0.075, Rise: 0.35, Fall: 2.95, Hang: 0),
        new ManeBlueprint(Ring: 12.4, LastRing: 20, Segment: 11.5, LastSegment: 16, Rows: 6, Columns: 7, Length: 1.15, Growth: 1.1, Width: 0.1, Rise: 0.25, Fall: 0.5, Hang: 0.6));

    /// <summary>A topknot, a beard along the throat and a tuft on the hump (camel).</summary>
    public static readonly ManePreset Beard = new(
        0.8,
        1.2,
        new ManeBlueprint(Ring: 13, LastRing: 15, Segment: 0, LastSegment: 2.4, Rows: 4, Columns: 5, Length: 1.0, Growth: 1.1, Width: 0.11, Rise: 0.45, Fall: 0.6, Hang: 0),
        new ManeBlueprint(Ring: 16.5, LastRing: 24.5, Segment: 12, LastSegment: 16, Rows: 9, Columns: 7, Length: 1.2, Growth: 1.2, Width: 0.12, Rise: 0.25, Fall: 0.5, Hang: 0.8),
        new ManeBlueprint(Ring: 32.6, LastRing: 35.6, Segment: 0, LastSegment: 1.6, Rows: 6, Columns: 5, Length: 1.2, Growth: 0.9, Width: 0.12, Rise: 0.35, Fall: 0.6, Hang: 0));

    /// <summary>A bony shield over the neck (horned dinosaur).</summary>
    public static readonly FrillPreset Shield = new(0.9, 1.2, new FrillBlueprint(Ring: 14, Spread: 9, Length: 1.9, Tilt: 0.95, Bend: -0.12, Thickness: 0.17, Points: 6, Scallop: 0.08));

    /// <summary>A wide fan of skin all around the neck (frilled lizard).</summary>
    public static readonly FrillPreset Fan = new(0.85, 1.25, new FrillBlueprint(Ring: 14.6, Spread: 13.5, Length: 2.3, Tilt: 0.30, Bend: 0.12, Thickness: 0.07, Points: 8, Scallop: 0.16));
}
