using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Species;

namespace CreatureGen.Bodies;

/// <summary>Swellings and hollows of a mixed torso: those of its bodies in their shares, and over legs that few of its bodies have the shoulders, haunches and lines of back and belly that such legs need. On them a fish or a snake is a log.</summary>
internal static class Girdles
{
    // Shares of the torso that comes from bodies without muscles for legs, from which on it is given some and from which on it has all of them.
    private const double Few = 0.25;
    private const double Most = 0.55;

    /// <summary>How much of the muscles of legs that stand under the body those have that reach out to its side.</summary>
    private const double Sprawling = 0.5;

    // Segments in the middle of a back and of a belly, and to how many on both sides reaches what is on all of one.
    private const double Back = 0;
    private const double Belly = BodyGrid.Segments / 2;
    private const double Broad = 5;

    /// <summary>At shoulders, in rings from the middle of their legs.</summary>
    private static readonly HeadBump[] shoulders =
    {
        new(Ring: -1.6, Segment: 4.6, RingSpread: 1.9, SegmentSpread: 2.2, Amount: 0.12),  // shoulder blade
        new(Ring: -0.2, Segment: Back, RingSpread: 2.8, SegmentSpread: Broad, Amount: 0.12),  // withers
        new(Ring: 5.2, Segment: Back, RingSpread: 3.2, SegmentSpread: Broad, Amount: -0.16),  // dip behind them
        new(Ring: -1, Segment: Belly, RingSpread: 3, SegmentSpread: Broad, Amount: 0.12),  // brisket
    };

    /// <summary>At hips, the same.</summary>
    private static readonly HeadBump[] hips =
    {
        new(Ring: -0.4, Segment: 5.6, RingSpread: 2.2, SegmentSpread: 2.4, Amount: 0.13),  // haunch
        new(Ring: -1.4, Segment: Back, RingSpread: 2.2, SegmentSpread: Broad, Amount: 0.16),  // croup
        new(Ring: -4, Segment: 8.6, RingSpread: 2.2, SegmentSpread: 2.6, Amount: -0.10),  // flank
        new(Ring: -3.2, Segment: Belly, RingSpread: 3, SegmentSpread: Broad, Amount: -0.38),  // groin
    };

    /// <summary>At hips that carry a trunk alone.</summary>
    private static readonly HeadBump[] bipedHips =
    {
        new(Ring: -0.4, Segment: 5.6, RingSpread: 2.4, SegmentSpread: 2.6, Amount: 0.13),  // haunch
        new(Ring: -1, Segment: Back, RingSpread: 2.6, SegmentSpread: Broad, Amount: 0.16),  // hip bone
        new(Ring: -6, Segment: Back, RingSpread: 2.6, SegmentSpread: Broad, Amount: -0.15),  // loin
        new(Ring: 5, Segment: Belly, RingSpread: 3, SegmentSpread: 6, Amount: -0.38),  // vent
    };

    // Share of the first body from which on a torso keeps its line of the back, and at which a straight one is given all of another: mixed ones even one another out.
    private const double Pure = 0.88;
    private const double Mixed = 0.75;

    // Rise and fall of the line of the back between the girdles, in depths of the trunk, from which on it is none of a plank, and at which it is all of one.
    private const double Lively = 0.1;
    private const double Straight = 0.03;

    // What a straight back over legs under it is given, at shoulders and at hips.
    private static readonly HeadBump[] withers =
    {
        new(Ring: -0.4, Segment: Back, RingSpread: 2.6, SegmentSpread: Broad, Amount: 0.13),  // withers
        new(Ring: 6, Segment: Back, RingSpread: 3.4, SegmentSpread: Broad, Amount: -0.17),  // dip behind them
        new(Ring: -1.4, Segment: 4.6, RingSpread: 1.7, SegmentSpread: 1.9, Amount: 0.06),  // shoulder blade
    };

    private static readonly HeadBump[] croup =
    {
        new(Ring: -1.6, Segment: Back, RingSpread: 2, SegmentSpread: Broad, Amount: 0.13),  // croup
        new(Ring: -0.4, Segment: 5.6, RingSpread: 2.2, SegmentSpread: 2.4, Amount: 0.06),  // haunch
        new(Ring: -3.6, Segment: Belly, RingSpread: 2.8, SegmentSpread: Broad, Amount: -0.2),  // groin
    };

    // What a trunk between legs that reach out to its side is given, at shoulders and at hips: without it that is a tube with legs.
    private static readonly HeadBump[] sprawlingShoulders =
    {
        new(Ring: -1.2, Segment: 4.8, RingSpread: 1.8, SegmentSpread: 2.1, Amount: 0.15),  // shoulder blade
        new(Ring: -0.6, Segment: Back, RingSpread: 2.4, SegmentSpread: Broad, Amount: 0.10),  // withers
        new(Ring: 5.4, Segment: Back, RingSpread: 3, SegmentSpread: Broad, Amount: -0.15),  // dip behind them
        new(Ring: 3.2, Segment: 7, RingSpread: 1.5, SegmentSpread: 2.4, Amount: -0.11),  // hollow behind the shoulder
        new(Ring: 7, Segment: 9.5, RingSpread: 2.8, SegmentSpread: 3, Amount: 0.12),  // belly between the legs
    };

    private static readonly HeadBump[] sprawlingHips =
    {
        new(Ring: -0.4, Segment: 5.2, RingSpread: 2, SegmentSpread: 2.2, Amount: 0.18),  // haunch
        new(Ring: -1, Segment: Back, RingSpread: 2.2, SegmentSpread: Broad, Amount: 0.15),  // hip bone
        new(Ring: -3.8, Segment: 8, RingSpread: 1.8, SegmentSpread: 2.6, Amount: -0.15),  // flank
        new(Ring: -3, Segment: Belly, RingSpread: 2.6, SegmentSpread: Broad, Amount: -0.25),  // groin
    };

    /// <summary>What a trunk that stands upright is given, in rings from the middle of its hips: it is seen from before and behind, where it would be a pipe.</summary>
    private static readonly HeadBump[] upright =
    {
        new(Ring: -7, Segment: Back, RingSpread: 6, SegmentSpread: 1.1, Amount: -0.09),  // furrow of the spine
        new(Ring: -13.5, Segment: 3.4, RingSpread: 2.4, SegmentSpread: 1.7, Amount: 0.11),  // shoulder blade
        new(Ring: -11.5, Segment: 6.6, RingSpread: 2.6, SegmentSpread: 1.8, Amount: 0.07),  // side of the chest
        new(Ring: -5, Segment: 7.6, RingSpread: 2.6, SegmentSpread: 3, Amount: -0.09),  // waist
        new(Ring: 0, Segment: 3.6, RingSpread: 2.2, SegmentSpread: 2.2, Amount: 0.14),  // buttock
        new(Ring: -13, Segment: 12.6, RingSpread: 2.2, SegmentSpread: 2, Amount: 0.08),  // breast
    };

    /// <summary>The relief of a creature's torso.</summary>
    /// <param name="creature">The creature.</param>
    /// <param name="shape">Its sections.</param>
    public static ValueList<HeadBump> Of(CreatureBlueprint creature, BodyShape shape)
    {
        var bumps = new List<HeadBump>();
        BodyBlend blend = creature.Body.Blend;
        IReadOnlyList<double> fractions = blend.TorsoFractions;
        for (int k = 0; k < blend.Bodies.Count; k++)
        {
            Add(bumps, SpeciesCatalogue.Find(blend.Bodies[k].Name).Relief, 0, fractions[k]);
        }

        List<LegBlueprint> legs = Standing(creature);
        double bare = creature.Body.Shell.Style == ShellStyle.None ? Scalar.Smooth((Bare(blend, legs.Count) - Few) / (Most - Few)) : 0;
        if (legs.Count > 0 && bare > 0)
        {
            LegBlueprint last = legs[legs.Count - 1];
            Add(bumps, legs.Count > 1 ? hips : bipedHips, Middle(last), bare * Strength(last));
            if (legs.Count > 1)
            {
                Add(bumps, shoulders, Middle(legs[0]), bare * Strength(legs[0]));
            }
        }

        if (creature.Plan == BodyPlan.Upright && legs.Count == 1 && creature.Body.Shell.Style == ShellStyle.None)
        {
            Add(bumps, upright, Middle(legs[0]), 1);
        }

        double mixed = Scalar.Smooth((Pure - fractions[0]) / (Pure - Mixed));
        double plank = (1 - bare) * mixed;
        // Where wings fold the back stays as they know it.
        if (legs.Count > 1 && plank > 0 && creature.Wings.Count == 0 && creature.Body.Shell.Style == ShellStyle.None && legs.TrueForAll(leg => LegKinds.Of(leg.Archetype).Build.Posture == LimbPosture.Under))
        {
            plank *= Scalar.Clamp((Lively - Liveliness(shape)) / (Lively - Straight), 0, 1);
            Add(bumps, withers, Middle(legs[0]), plank);
            Add(bumps, croup, Middle(legs[legs.Count - 1]), plank);
        }

        // The back of what leaps slopes from its hips, without withers.
        if (creature.Plan == BodyPlan.Sprawling && legs.Count > 1 && !LegKinds.Of(legs[legs.Count - 1].Archetype).Step.Leaps && creature.Wings.Count == 0 && creature.Body.Shell.Style == ShellStyle.None)
        {
            double rest = mixed * (1 - (Sprawling * bare));
            Add(bumps, sprawlingShoulders, Middle(legs[0]), rest);
            Add(bumps, sprawlingHips, Middle(legs[legs.Count - 1]), rest);
        }

        return new ValueList<HeadBump>(bumps);
    }

    /// <summary>How far the line of the back between the girdles departs up and down from a straight one, in depths of the trunk.</summary>
    private static double Liveliness(BodyShape shape)
    {
        const int First = StationRing.Shoulder;
        const int Last = StationRing.Pelvis;
        double highest = 0;
        double lowest = 0;
        double depth = 0;
        for (int ring = First; ring <= Last; ring++)
        {
            double along = (shape.Z[First] - shape.Z[ring]) / (shape.Z[First] - shape.Z[Last]);
            double off = BackAt(shape, ring) - Scalar.Lerp(BackAt(shape, First), BackAt(shape, Last), along);
            highest = Math.Max(highest, off);
            lowest = Math.Min(lowest, off);
            depth = Math.Max(depth, shape.Top[ring] + shape.Bottom[ring]);
        }

        return (highest - lowest) / depth;
    }

    private static double BackAt(BodyShape shape, int ring) => shape.Y[ring] + (shape.Top[ring] * PortableMath.Cos(shape.Pitch[ring]));

    private static void Add(List<HeadBump> bumps, HeadBump[] relief, double ring, double factor)
    {
        foreach (HeadBump bump in relief)
        {
            bumps.Add(bump with { Ring = ring + bump.Ring, Amount = factor * bump.Amount });
        }
    }

    /// <summary>The legs that carry the trunk by muscles on it, from the front; insects' are all in their thorax.</summary>
    private static List<LegBlueprint> Standing(CreatureBlueprint creature)
    {
        var legs = new List<LegBlueprint>();
        foreach (LegBlueprint leg in creature.Legs)
        {
            LegOutline outline = LegKinds.Of(leg.Archetype).Outline;
            if (leg.Stance == LegStance.Standing && !outline.Arched && !outline.Carried)
            {
                legs.Add(leg);
            }
        }

        legs.Sort((a, b) => a.Socket.Ring.CompareTo(b.Socket.Ring));
        return legs;
    }

    /// <summary>Share of a torso that comes from bodies that never stood on so many pairs of legs.</summary>
    private static double Bare(BodyBlend blend, int pairs)
    {
        double bare = 0;
        IReadOnlyList<double> fractions = blend.TorsoFractions;
        for (int k = 0; k < fractions.Count; k++)
        {
            SpeciesProfile species = SpeciesCatalogue.Find(blend.Bodies[k].Name);
            bool fitting = species.Relief.Length > 0 || species.Class == AnimalClass.Amphibian || (species.Class == AnimalClass.Bird && pairs == 1);
            bare += fitting ? 0 : fractions[k];
        }

        return bare;
    }

    private static double Middle(LegBlueprint leg) => leg.Socket.Ring + (0.5 * leg.Socket.Rows);

    private static double Strength(LegBlueprint leg) => LegKinds.Of(leg.Archetype).Outline.Sprawling ? Sprawling : 1;
}
