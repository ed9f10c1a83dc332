using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Sampling.Features;
using CreatureGen.Sampling.Limbs;
using CreatureGen.Sampling.Placement;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Individuals;

/// <summary>
/// The trunk and the legs of an individual. Its legs grow from the same cells as those of its species, so that all individuals share one topology; how high they carry the body, how thick they
/// are and where their feet stand is settled anew by the rules that settled the type's.
/// </summary>
internal sealed class IndividualBody
{
    /// <summary>A larger head than this is left to those whose type has one.</summary>
    private const double LargestHead = 1.8;

    private const double LargestInsectHead = 1.35;

    /// <summary>How far an individual with teeth can open its mouth at the least if its type's is open as far or farther, radians.</summary>
    private const double LeastBite = 0.05;

    /// <summary>Shares of its traits that an individual may be left with, when its body cannot carry them all.</summary>
    private static readonly double[] strengths = { 1, 0.5, 0.25 };

    private IndividualBody(CreatureBuilder builder, IReadOnlyList<LegBlueprint> legs)
    {
        Builder = builder;
        Legs = legs;
    }

    /// <summary>The body as it stands.</summary>
    public CreatureBuilder Builder { get; }

    /// <summary>Its legs and arms, in the order of the type's.</summary>
    public IReadOnlyList<LegBlueprint> Legs { get; }

    /// <summary>The body of an individual. It keeps as much of its traits as it can carry: all, a half, a quarter, or none.</summary>
    public static IndividualBody Of(CreatureBlueprint type, CreatureBuilder ofType, IndividualTraits traits)
    {
        foreach (double strength in strengths)
        {
            CreatureBuilder builder = Shape(type, ofType, traits, strength);
            IReadOnlyList<LegBlueprint>? legs = Stand(type, ofType, builder, traits);
            if (legs != null && !StanceSampler.Sinks(builder) && !StanceSampler.TipsOver(builder) && ClearsTheGround(type, builder))
            {
                return new IndividualBody(builder, legs);
            }
        }

        return new IndividualBody(ofType, type.Legs);
    }

    private static CreatureBuilder Shape(CreatureBlueprint type, CreatureBuilder ofType, IndividualTraits traits, double strength)
    {
        BodyProportions p = type.Body.Proportions;
        BodyPosture posture = ofType.Drawn;
        double tilt = ofType.Kind == LocomotionKind.Swimming || ofType.Plan == BodyPlan.Legless ? 0 : strength * ofType.Species.TiltVariety;
        double largest = Math.Max(p.Head, ofType.Parents.Head.Class == AnimalClass.Arthropod ? LargestInsectHead : LargestHead);
        var builder = new CreatureBuilder(ofType.Seed, ofType.Kind, ofType.Parents, ofType.Plan, ofType.Strangeness)
        {
            Blend = ofType.Blend,
            Signature = ofType.Signature,
            Style = ofType.Style,
            Slices = ofType.Slices,
            Disc = ofType.Disc,
            Stand = ofType.Stand,
            Tail = ofType.Kind == LocomotionKind.Swimming ? new TailBlueprint(TailStyle.Plain, 0, 0) : type.Tail,
            StanceShift = strength * traits.Stance,
            Proportions = p with
            {
                Head = Math.Min(largest, p.Head * Of(traits.Head)),
                Snout = p.Snout * Of(traits.Snout),
                Neck = p.Neck * Of(traits.Neck),
                Girth = p.Girth * Of(traits.Girth),
                Belly = p.Belly * Of(traits.Belly),
                Chest = p.Chest * Of(traits.Chest),
                Rump = p.Rump * Of(traits.Rump),
                Tail = p.Tail * Of(traits.Tail),
            },
            Posture = posture with
            {
                Head = posture.Head + Tilted(traits.Tilt.Head, 2),
                Neck = posture.Neck + Tilted(traits.Tilt.Neck, 3),
                Tail = posture.Tail + Tilted(traits.Tilt.Tail, 5),
            },
        };
        builder.Wings.AddRange(ofType.Wings);
        StanceSampler.Settle(builder);
        builder.Elevation += ofType.Raised;
        builder.Shape = StanceSampler.ShapeOf(builder);
        if (builder.Kind == LocomotionKind.Flying)
        {
            StanceSampler.Clear(builder);
        }

        return builder;

        double Of(double trait) => 1 + (strength * (trait - 1));

        double Tilted(double deviations, double degrees) => tilt * Scalar.Radians(Scalar.Clamp(deviations, -2, 2) * degrees);
    }

    /// <summary>The legs that carry a body; null when no legs at the places of the type's do.</summary>
    private static List<LegBlueprint>? Stand(CreatureBlueprint type, CreatureBuilder ofType, CreatureBuilder builder, IndividualTraits traits)
    {
        WalkingPlacement? placement = null;
        if (ofType.Stand is LegStand stand)
        {
            placement = LegSampler.Settle(builder, _ => stand.Places, stand.Size with { Girth = stand.Size.Girth * traits.LegGirth });
            if (placement.PlanChange != null || placement.RaiseBody != 0 || placement.Balance is null || placement.Balance.Remedy == BalanceRemedy.AddPairOrTail)
            {
                return null;
            }
        }

        var legs = new List<LegBlueprint>();
        int standing = 0;
        foreach (LegBlueprint leg in type.Legs)
        {
            LegBlueprint own = leg with { ClawLength = leg.ClawLength * traits.Claws };
            legs.Add(leg.Stance == LegStance.Standing && placement != null
                ? Carry(builder, own, placement, placement.Legs[standing++], ofType.Stand!.FootGrowth)
                : Hang(ofType, builder, own, traits));
        }

        return legs;
    }

    private static LegBlueprint Carry(CreatureBuilder builder, LegBlueprint leg, WalkingPlacement placement, LegPlacement place, double growthOfType)
    {
        bool splayed = LegKinds.Of(leg.Archetype).Build.Posture == LimbPosture.Splayed;
        (double azimuth, double shear) = LegSampler.Posture(builder, placement, place);
        return leg with
        {
            Thickness = place.RootRadius,
            Length = place.RootHeight,
            Reach = splayed ? place.Reach : place.RootHeight,
            Azimuth = azimuth,
            Shear = shear,
            FootSize = leg.FootSize * (placement.Balance?.FootGrowth ?? 1) / growthOfType,
        };
    }

    /// <summary>A limb that hangs is never longer than its body is high.</summary>
    private static LegBlueprint Hang(CreatureBuilder ofType, CreatureBuilder builder, LegBlueprint leg, IndividualTraits traits)
    {
        int ring = leg.Socket.Ring + (leg.Socket.Rows / 2);
        double lowered = builder.IsOnGround ? Math.Min(1, builder.Shape.Y[ring] / ofType.Shape.Y[ring]) : 1;
        double length = lowered * (1 + (0.3 * traits.Stance));
        return leg with { Thickness = leg.Thickness * traits.LegGirth, Length = leg.Length * length, Reach = leg.Reach * length };
    }

    /// <summary>Whether the round end of a walker's tail, a club there and its open jaw, if it has them, are off the ground.</summary>
    private static bool ClearsTheGround(CreatureBlueprint type, CreatureBuilder builder)
    {
        if (!builder.IsOnGround)
        {
            return true;
        }

        bool bites = type.Head.Mouth.Teeth == 0 || HeadSampler.WidestOpening(builder) >= Math.Min(type.Head.Mouth.Opening, LeastBite);
        BodyShape s = builder.Shape;
        return bites && s.Y[^1] > s.Bottom[^1] && FeatureSampler.TailClears(builder, type.Features);
    }
}
