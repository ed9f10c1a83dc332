using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Shapes;

/// <summary>Trunks of strange creatures with a shape: chest, waist and hips of three species may even one another out to a log.</summary>
internal static class TrunkFit
{
    // Deepest section against the shallowest from girdle to girdle: below the first a trunk is a log, from the second on it has a shape.
    private const double Log = 1.08;
    private const double Shaped = 1.4;

    // What a log gains at the chest and at the hips, and what its belly loses.
    private const double Chest = 0.3;
    private const double Rump = 0.2;
    private const double Belly = 0.16;

    /// <summary>What the abdomen of an insect gains: behind its waist it is the hips.</summary>
    private const double Abdomen = 0.35;

    // A swimmer's largest hips against its belly, least root of its tail against its hips, and most that the tail's girth grows by for it.
    private const double Hips = 0.8;
    private const double Root = 0.5;
    private const double MaxRoot = 1.3;

    // Broadest trunk against its depth that legs under the body carry without looking like those of a table, and what of the excess the depth and the breadth give way by.
    private const double Broad = 1.25;
    private const double Deepened = 0.6;
    private const double Narrowed = 0.3;

    /// <summary>The proportions with a deeper chest, a tucked belly and broader hips where the trunk has none; swimmers thin out to the tail, what lies is a rope, and what stands on two legs would be top-heavy.</summary>
    public static BodyProportions Fit(CreatureBuilder builder)
    {
        BodyProportions drawn = builder.Proportions;
        if (builder.Kind == LocomotionKind.Swimming)
        {
            return Streamlined(builder);
        }

        if (builder.Plan is BodyPlan.Legless or BodyPlan.ManyLegged or BodyPlan.Upright or BodyPlan.Theropod || builder.Species.Disc.Sweep != 0)
        {
            return drawn;
        }

        (double relief, double breadth) = Measure(StanceSampler.ShapeOf(builder));
        double strange = builder.Fitting;
        bool under = builder.Kind == LocomotionKind.Walking && builder.Plan is BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar or BodyPlan.Centaur;
        double excess = under ? Math.Max(1, breadth / Broad) : 1;
        double want = strange * Scalar.Clamp((Shaped - relief) / (Shaped - Log), 0, 1);
        bool insect = builder.Species.Class == AnimalClass.Arthropod;
        return drawn with
        {
            Chest = drawn.Chest * (1 + (Chest * want)),
            Belly = drawn.Belly * (1 - (Belly * want)),
            Rump = drawn.Rump * (1 + ((insect ? 0 : Rump) * want)),
            TailGirth = drawn.TailGirth * (1 + ((insect ? Abdomen : 0) * want)),
            Depth = drawn.Depth * PortableMath.Pow(excess, Deepened * strange),
            Width = drawn.Width * PortableMath.Pow(excess, -Narrowed * strange),
        };
    }

    /// <summary>The deepest section of a trunk against its shallowest, and its greatest breadth against the depth there.</summary>
    private static (double Relief, double Breadth) Measure(BodyShape shape)
    {
        double min = double.MaxValue;
        double max = 0;
        double breadth = 0;
        for (int ring = StationRing.Shoulder; ring <= StationRing.Pelvis; ring++)
        {
            double size = shape.Top[ring] + shape.Bottom[ring];
            min = Math.Min(min, size);
            max = Math.Max(max, size);
            breadth = Math.Max(breadth, 2 * shape.Width[ring] / size);
        }

        return (max / min, breadth);
    }

    /// <summary>The proportions of a swimmer that thins out behind its belly instead of ending like a sack with a tail tied to it; one as flat as a disc stays as it is.</summary>
    private static BodyProportions Streamlined(CreatureBuilder builder)
    {
        BodyProportions drawn = builder.Proportions;
        if (builder.Species.Disc.Sweep != 0)
        {
            return drawn;
        }

        BodyShape shape = StanceSampler.ShapeOf(builder);
        double hips = Size(shape, StationRing.Pelvis);
        double thin = Math.Min(1, Hips * Size(shape, StationRing.Belly) / hips);
        double root = Size(shape, StationRing.TailStem);
        double thick = Math.Max(1, Root * thin * hips / root);
        double strange = builder.Fitting;
        return drawn with
        {
            Rump = drawn.Rump * PortableMath.Pow(thin, strange),
            TailGirth = drawn.TailGirth * Math.Min(MaxRoot, PortableMath.Pow(thick, strange)),
        };
    }

    /// <summary>Radius of a section, metres.</summary>
    private static double Size(BodyShape shape, int ring) => Math.Sqrt(shape.Width[ring] * 0.5 * (shape.Top[ring] + shape.Bottom[ring]));
}
