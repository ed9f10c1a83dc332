using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Features;

/// <summary>Parts that no animal has so many of: further eyes, eyes on stalks, further tails. How often follows the strangeness, and no creature has two sorts of them.</summary>
internal static class StrangeParts
{
    /// <summary>Probability of any at full strangeness.</summary>
    private const double Any = 0.3;

    /// <summary>First ring of a further tail: where the tail of the body begins.</summary>
    private const double TailRing = 43.4;

    // Least length of a further tail in torsos, and in radii of its root: shorter and thicker ones are horns on the rump.
    private const double LeastTail = 0.6;
    private const double Slenderness = 16;

    /// <summary>Draws what there is.</summary>
    public static void Add(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("strange parts");
        bool any = random.Chance(Any * builder.Strangeness);
        int sort = random.Weighted(stackalloc double[] { 0.22, 0.2, 0.14, 0.12, 0.14, 0.18 });
        double size = random.Uniform();
        if (!any)
        {
            return;
        }

        bool insect = builder.Parents.Head.Class == AnimalClass.Arthropod;
        switch (sort)
        {
            case 0 when !insect && !FaceRule.IsDressed(builder):
                Eye(builder, 1.2, 0, 0.75 + (0.15 * size));
                break;
            case 1 when !insect:
                Eye(builder, 2.3, -1.7, 0.6 + (0.12 * size));
                break;
            case 2 when !insect:
                Eye(builder, -2.0, -1.4, 0.5);
                Eye(builder, 2.2, -1.8, 0.58);
                Eye(builder, 3.4, 0.9, 0.48);
                break;
            case 3 when builder.Plan is BodyPlan.Legless or BodyPlan.ManyLegged or BodyPlan.Fish or BodyPlan.Eel or BodyPlan.Sprawling:
                for (int ring = 18; ring <= 36; ring += 3)
                {
                    AddEye(builder, ring, 5.4, 0.4);
                }

                break;
            case 4 when !FaceRule.IsDressed(builder) && builder.Ears.Count == 0:
                Stalks(builder, size);
                break;
            case 5:
                Tails(builder, size);
                break;
        }
    }

    /// <summary>An eye or a pair of them, so far behind and below the two that the face has, in radii of these; on the midline where the way down is 0.</summary>
    private static void Eye(CreatureBuilder builder, double behind, double below, double radius)
    {
        (double ring, double segment) = builder.Parents.Head.Eye;
        AddEye(builder, ring + behind, below == 0 ? 0 : segment + below, radius);
    }

    private static void AddEye(CreatureBuilder builder, double ring, double segment, double fraction)
    {
        double radius = fraction * EyeRadius(builder);
        builder.Features.Add(new FeatureBlueprint(FeatureKind.Eye, ring, segment, radius, radius, Outward: 1, Upward: 0, Forward: 0, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 1, Taper: 1));
    }

    private static void Stalks(CreatureBuilder builder, double size)
    {
        double radius = 0.8 * EyeRadius(builder);
        double length = (4 + (4 * size)) * radius;
        builder.Features.Add(new FeatureBlueprint(FeatureKind.Eye, builder.Parents.Head.Eye.Ring + 2.5, Segment: 2.6, Length: length, Radius: radius, Outward: 0.3, Upward: 0.9, Forward: 0.15, Sideward: 0.3, BendUp: 0.05, BendForward: 0.1, BendSide: 0.1, Flatness: 1, Taper: 1));
    }

    private static double EyeRadius(CreatureBuilder builder) =>
        Math.Min(builder.Parents.Head.EyeSize, Math.Min(0.4, builder.Parents.Head.LargestEye)) * HeadSampler.HalfHeight(builder.Shape);

    /// <summary>A pair of tails beside the one of the body, where that has no end of its own.</summary>
    private static void Tails(CreatureBuilder builder, double size)
    {
        BodyShape s = builder.Shape;
        bool plain = builder.Tail.Style is TailStyle.Plain or TailStyle.Whip or TailStyle.Saurian or TailStyle.Prehensile;
        if (!plain || builder.Kind == LocomotionKind.Swimming || builder.Plan == BodyPlan.Legless || builder.Parents.Tail.Class == AnimalClass.Arthropod || builder.Parents.First.Disc.Sweep != 0)
        {
            return;
        }

        double length = (0.75 + (0.4 * size)) * Math.Max(s.Arc[BodyGrid.Rings - 1] - s.Arc[StationRing.TorsoLast], LeastTail * builder.TorsoLength);
        double radius = Math.Min(0.5 * 0.5 * (s.Width[StationRing.TailBase] + builder.HalfDepth(StationRing.TailBase)), length / Slenderness);
        var tail = new FeatureBlueprint(FeatureKind.Tail, TailRing, Segment: 4.6, Length: length, Radius: radius, Outward: 0.22, Upward: -0.1, Forward: -1, Sideward: 0.12, BendUp: -0.4, BendForward: 0, BendSide: 0, Flatness: 1, Taper: 0.7);
        builder.Features.Add(FeatureSampler.OffGround(builder, tail));
    }
}
