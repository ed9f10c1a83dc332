using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Fins;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Sampling.Placement;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Limbs;

/// <summary>Gives a mixed swimmer fins and a tail of other outlines than all of its species have: with the same ones two dolphins are twins.</summary>
internal static class FinOutlines
{
    /// <summary>Probability at full strangeness that fins on the midline, paired ones and the tail have another outline that the plan allows.</summary>
    private const double OtherOutline = 0.6;

    // At full strangeness, how far a fin on the midline stands ahead or behind, in rings, and how much lower or higher, shorter or longer (in pairs of cells) and more upright or swept it is.
    private const double Ahead = -2;
    private const double Behind = 3;
    private const double Lower = -0.4;
    private const double Higher = 0.5;
    private const double Longer = 1.4;
    private const double Upright = -0.6;
    private const double FartherSwept = 0.2;

    /// <summary>Least sweep that a fin is drawn upright to.</summary>
    private const double LeastSweep = 0.2;

    /// <summary>Cells of a fin that is too small to be shorter or longer, and ring at which the latest ends.</summary>
    private const int SmallRows = 6;
    private const int LastEnd = 44;

    // At full strangeness, how full or hollow a fluke is, how much farther or less far its tips are swept, as a share, and how uneven the halves of an upright fin are.
    private const double Hollow = 1.1;
    private const double FlukeSweep = 0.5;
    private const double Uneven = 0.4;
    private const double MostUneven = 0.8;

    /// <summary>Half the span of a tail's fin of common size, metres at scale 1.</summary>
    public static double SpreadOf(TailStyle style) => style switch
    {
        TailStyle.Fork => 0.29,
        TailStyle.Fan => 0.24,
        TailStyle.Lance => 0.15,
        TailStyle.Lunate => 0.3,
        TailStyle.Heterocercal => 0.24,
        TailStyle.Truncate => 0.24,
        TailStyle.Veil => 0.26,
        TailStyle.Fluke => 0.34,
        _ => 0,
    };

    /// <summary>A fin of the species as this swimmer has it. What beats a disc keeps its own.</summary>
    public static FinSitePreset Vary(CreatureBuilder builder, FinSitePreset fin)
    {
        if (builder.Species.Disc.Sweep != 0)
        {
            return fin;
        }

        FinAnatomy anatomy = FinAnatomy.Of(builder.Plan);
        return fin.Place == FinPlace.Pectoral ? Paired(builder, fin, anatomy) : Midline(builder, fin, anatomy);
    }

    /// <summary>Height and sweep of a fin on the midline that the plan places: those of one swimmer are alike, those of two are not.</summary>
    public static (double Height, double Sweep) Vary(CreatureBuilder builder, double height, double sweep)
    {
        RandomStream random = builder.Stream("outline of placed fins");
        double higher = 1 + (builder.Strangeness * random.Uniform(Lower, Higher));
        return (higher * height, Swept(builder.Strangeness, random, sweep));
    }

    /// <summary>The upright tail of the species, or another one that the plan allows.</summary>
    public static TailBlueprint Other(CreatureBuilder builder, TailBlueprint own)
    {
        RandomStream random = builder.Stream("other tail");
        if (builder.Plan != BodyPlan.Fish || SpreadOf(own.Style) == 0 || !random.Chance(OtherOutline * builder.Strangeness))
        {
            return own;
        }

        TailStyle style = CreatureBuilder.Choose(random, (TailStyle.Fork, 1), (TailStyle.Fan, 0.7), (TailStyle.Lunate, 1), (TailStyle.Heterocercal, 0.8), (TailStyle.Truncate, 0.7), (TailStyle.Veil, 0.8));
        double fork = style switch { TailStyle.Fork => random.Uniform(1.2, 2.2), TailStyle.Fan => TailSampler.FanFork(builder, random), _ => 0 };
        return style == own.Style ? own : new TailBlueprint(style, own.Size * SpreadOf(style) / SpreadOf(own.Style), fork);
    }

    /// <summary>A tail of the same style with an outline of its own.</summary>
    public static TailBlueprint Vary(CreatureBuilder builder, TailBlueprint tail)
    {
        if (SpreadOf(tail.Style) == 0 || tail.Style == TailStyle.Lance)
        {
            return tail;
        }

        RandomStream random = builder.Stream("outline of tail");
        bool level = tail.Style == TailStyle.Fluke;
        double most = builder.Strangeness * (level ? Hollow : Uneven);
        double lobe = Scalar.Clamp(tail.Lobe + random.Uniform(-most, most), -MostUneven, MostUneven);
        double sweep = 1 + (builder.Strangeness * random.Uniform(-FlukeSweep, FlukeSweep));
        return tail with { Lobe = lobe, Fork = level ? sweep * tail.Fork : tail.Fork };
    }

    private static FinSitePreset Midline(CreatureBuilder builder, FinSitePreset fin, FinAnatomy anatomy)
    {
        RandomStream random = builder.Stream("outline of midline fins");
        double strange = builder.Strangeness;
        FinStyle style = Style(random, strange, fin.Style, anatomy.Midline);
        int rows = fin.Rows + (fin.Rows > SmallRows ? 2 * Whole(strange * random.Uniform(-Longer, Longer)) : 0);
        int ring = Math.Max(Math.Min(fin.Ring, LastEnd - rows), Math.Min(fin.Ring + Whole(strange * random.Uniform(Ahead, Behind)), LastEnd - rows));
        double height = 1 + (strange * random.Uniform(Lower, Higher));
        double sweep = Swept(strange, random, fin.Sweep);
        return new FinSitePreset(fin.Place, style, ring, fin.Segment, rows, (height * fin.Length.Min, height * fin.Length.Max), fin.Width, fin.Drop, sweep);
    }

    private static double Swept(double strangeness, RandomStream random, double own) =>
        Scalar.Clamp(own + (strangeness * random.Uniform(Upright, FartherSwept)), Math.Min(own, LeastSweep), 1);

    private static FinSitePreset Paired(CreatureBuilder builder, FinSitePreset fin, FinAnatomy anatomy)
    {
        FinStyle style = Style(builder.Stream("outline of paired fins"), builder.Strangeness, fin.Style, anatomy.Paired);
        if (FlankFin.Of(style) is not FlankFin form || FlankFin.Of(fin.Style) is not FlankFin own)
        {
            return fin;
        }

        double length = FinSampler.LengthOf(style) / FinSampler.LengthOf(fin.Style);
        double depth = form.Depth / own.Depth;
        return new FinSitePreset(fin.Place, style, fin.Ring, fin.Segment, fin.Rows, (length * fin.Length.Min, length * fin.Length.Max), (depth * fin.Width.Min, depth * fin.Width.Max), fin.Drop, fin.Sweep);
    }

    private static FinStyle Style(RandomStream random, double strangeness, FinStyle own, IReadOnlyList<FinChoice> choices)
    {
        bool other = random.Chance(OtherOutline * strangeness);
        FinStyle style = choices[SwimmingRules.Draw(random, choices, choice => choice.Weight)].Style;
        return other ? style : own;
    }

    private static int Whole(double value) => (int)Math.Floor(value + 0.5);
}
