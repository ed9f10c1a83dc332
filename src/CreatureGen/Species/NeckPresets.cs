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

    /// <summary>A ruff around neck and chest, whiskers along the jaw, and a tufted tail (lion).</summary>
    public static readonly ManePreset Ruff = new(
        0.85,
        1.2,
        new ManeBlueprint(15.4, 23.6, 0, 16, 7, 14, 1.6, 1.1, 0.17, 0.34, 0.65, 0.6),
        new ManeBlueprint(15.3, 16.8, 0, 13, 2, 14, 1.4, 1.1, 0.16, 0.9, 0.4, 0.2),
        new ManeBlueprint(13.4, 14.6, 6.5, 14.5, 2, 9, 1.1, 1.15, 0.13, 0.6, 0.8, 0.4),
        new ManeBlueprint(50.5, 53, 0, 16, 3, 5, 1.25, 0.8, 0.14, 0.22, 0, 0.1));

    /// <summary>A mane that falls to both sides of the neck, a forelock and a tail of long hair (horse).</summary>
    public static readonly ManePreset Falling = new(
        0.85,
        1.2,
        new ManeBlueprint(13.6, 25.4, 0.3, 1.5, 24, 2, 1.7, 0.95, 0.17, 0.2, 1.1, 0),
        new ManeBlueprint(13.2, 25.6, 0, 0, 24, 1, 0.85, 0.8, 0.1, 0.62, 0, 0),
        new ManeBlueprint(11.8, 13.8, 0, 1.1, 4, 3, 1.05, 1, 0.1, 0.3, Forward, 0),
        new ManeBlueprint(45.2, 52.5, 0, 16, 7, 5, 2.2, 0.9, 0.2, 0.14, 0, 0.2));

    /// <summary>A crest of bristles from the poll to behind the shoulders (hyena, boar).</summary>
    public static readonly ManePreset Bristles = new(
        0.8,
        1.25,
        new ManeBlueprint(14, 30, 0, 1.6, 22, 3, 1.1, 0.75, 0.12, 0.6, 0.12, 0),
        new ManeBlueprint(50.5, 53, 0, 16, 3, 5, 1.0, 0.8, 0.11, 0.22, 0, 0.1));

    /// <summary>Shaggy shoulders, a mop between the horns and a beard (bison).</summary>
    public static readonly ManePreset Shag = new(
        0.85,
        1.2,
        new ManeBlueprint(15, 27, 0, 10.5, 7, 15, 1.35, 0.65, 0.13, 0.15, 0.95, 0.3),
        new ManeBlueprint(11.8, 14.6, 0, 2.4, 4, 5, 0.62, 1, 0.075, 0.35, 2.95, 0),
        new ManeBlueprint(12.4, 20, 11.5, 16, 6, 7, 1.15, 1.1, 0.1, 0.25, 0.5, 0.8),
        new ManeBlueprint(51, 53, 0, 16, 3, 5, 0.8, 0.8, 0.08, 0.2, 0, 0.1));

    /// <summary>A topknot, a beard along the throat and a tuft on the hump (camel).</summary>
    public static readonly ManePreset Beard = new(
        0.8,
        1.2,
        new ManeBlueprint(13, 15, 0, 2.4, 4, 5, 1.0, 1.1, 0.11, 0.45, 0.6, 0),
        new ManeBlueprint(16.5, 24.5, 12, 16, 9, 7, 1.2, 1.2, 0.12, 0.25, 0.5, 0.8),
        new ManeBlueprint(32.6, 35.6, 0, 1.6, 6, 5, 1.2, 0.9, 0.12, 0.35, 0.6, 0),
        new ManeBlueprint(51, 53, 0, 16, 3, 5, 1.0, 0.8, 0.11, 0.2, 0, 0.1));

    /// <summary>A bony shield over the neck (horned dinosaur).</summary>
    public static readonly FrillPreset Shield = new(0.9, 1.2, new FrillBlueprint(14, 9, 1.9, 0.95, -0.12, 0.17, 6, 0.08));

    /// <summary>A wide fan of skin all around the neck (frilled lizard).</summary>
    public static readonly FrillPreset Fan = new(0.85, 1.25, new FrillBlueprint(14.6, 13.5, 2.3, 0.30, 0.12, 0.07, 8, 0.16));
}
