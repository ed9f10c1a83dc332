using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;

namespace CreatureGen.Sampling.Placement;

/// <summary>Where each plan carries its legs and arms. Rings and segments are those of the anatomy that all bodies share; <see cref="StationRing"/> has their names.</summary>
internal static class SocketSets
{
    /// <summary>First ring of a row of many legs.</summary>
    public const int RowFirstRing = 25;

    /// <summary>Last ring of a row of many legs.</summary>
    public const int RowLastRing = StationRing.Pelvis;

    /// <summary>The places of a walking plan.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The plan is one of a flier or a swimmer.</exception>
    public static SocketSet Of(BodyPlan plan) => plan switch
    {
        BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar => Quadruped(plan),
        BodyPlan.Upright => Upright(LimbArchetype.PlantigradeHind),
        BodyPlan.Sprawling => Sprawling(),
        BodyPlan.Theropod => Theropod(),
        BodyPlan.Hexapod => Hexapod(),
        BodyPlan.ManyLegged => ManyLegged(),
        BodyPlan.Legless => Legless(),
        BodyPlan.Centaur => Centaur(BodyPlan.Digitigrade),
        _ => throw new ArgumentOutOfRangeException(nameof(plan), plan, "expected the plan of a walker"),
    };

    /// <summary>Two girdles: hind 41, fore 27; rarely arms at 23, and then forelegs at 30.</summary>
    public static SocketSet Quadruped(BodyPlan plan)
    {
        (LimbArchetype hind, LimbArchetype fore, double hindGirth, double foreGirth, double min) = plan switch
        {
            BodyPlan.Digitigrade => (LimbArchetype.DigitigradeHind, LimbArchetype.DigitigradeFore, 0.78, 0.52, 0.38),
            BodyPlan.Unguligrade => (LimbArchetype.UnguligradeHind, LimbArchetype.UnguligradeFore, 0.78, 0.52, 0.45),
            BodyPlan.Plantigrade => (LimbArchetype.PlantigradeHind, LimbArchetype.PlantigradeFore, 0.78, 0.52, 0.30),
            BodyPlan.Columnar => (LimbArchetype.Column, LimbArchetype.Column, 0.78 * 1.1, 0.52 * 1.15, 0.36),
            _ => throw new ArgumentOutOfRangeException(nameof(plan), plan, "expected the plan of a quadruped"),
        };
        LimbSocket rear = Under(41, 10.6, hind, hindGirth);
        LimbSocket front = Under(27, 10.9, fore, foreGirth);
        var arms = new ArmAnatomy(List(Arm(23, 9.5, 0.42)), List(front with { Ring = 30 }, rear), 0.04, 0.6, 0.45);
        return new SocketSet(plan, List(front, rear), 2, arms, new StanceLimits(MinimumLength: min, MaximumRaise: 0.45, RearwardShear: -0.12, ForwardShear: 0.12, MaximumPitchDegrees: 4, MaximumFootGrowth: 1.3, LowerPlan: BodyPlan.Sprawling, FewerPlan: BodyPlan.Theropod));
    }

    /// <summary>A quadruped that always has arms: arms at 23, forelegs at 30, hind legs at 41.</summary>
    /// <param name="legs">The plan whose legs it walks on.</param>
    public static SocketSet Centaur(BodyPlan legs)
    {
        SocketSet lower = Quadruped(legs);
        ArmAnatomy arms = lower.Arms! with { OddsNear = 1, OddsFar = 1 };
        return lower with { Plan = BodyPlan.Centaur, Legs = arms.Legs, Arms = arms };
    }

    /// <summary>Hips at 40, arms high on the flank at 26.</summary>
    /// <param name="legs">Built form of the legs: plantigrade or digitigrade hind legs.</param>
    public static SocketSet Upright(LimbArchetype legs)
    {
        IReadOnlyList<LimbSocket> hips = List(Under(40, 9.6, legs, 0.85));
        return new SocketSet(
            BodyPlan.Upright,
            hips,
            1,
            new ArmAnatomy(List(Arm(26, 8.8, 0.55)), hips, 0.9, 1, 0.72),
            new StanceLimits(MinimumLength: 0.30, MaximumRaise: 0.45, RearwardShear: -0.05, ForwardShear: 0.5, MaximumPitchDegrees: 10, MaximumFootGrowth: 1.6, LowerPlan: BodyPlan.Sprawling, FewerPlan: BodyPlan.Legless));
    }

    /// <summary>Legs out to the sides at 41 and 27.</summary>
    public static SocketSet Sprawling() => new(
        BodyPlan.Sprawling,
        List(Splayed(ring: 27, segment: 9.6, archetype: LimbArchetype.Sprawl, girth: 0.56, reach: 0.27, azimuth: 0.10, bounds: SocketBounds.Limb), Splayed(ring: 41, segment: 9.6, archetype: LimbArchetype.Sprawl, girth: 0.62, reach: 0.27, azimuth: -0.12, bounds: SocketBounds.Limb)),
        2,
        null,
        new StanceLimits(MinimumLength: 0.10, MaximumRaise: 0.30, RearwardShear: -0.2, ForwardShear: 0.2, MaximumPitchDegrees: 3, MaximumFootGrowth: 1.3, LowerPlan: BodyPlan.ManyLegged, FewerPlan: BodyPlan.Theropod));

    /// <summary>One pair at the widest of the rings 34 to 41; mostly small arms at 26.</summary>
    public static SocketSet Theropod()
    {
        var hips = new List<LimbSocket>();
        for (int ring = 34; ring <= 41; ring++)
        {
            hips.Add(Under(ring, 11.3, LimbArchetype.Theropod, 0.66));
        }

        return new SocketSet(
            BodyPlan.Theropod,
            hips,
            1,
            new ArmAnatomy(List(Arm(26, 10.2, 0.40)), hips, 0.85, 1, 0.40),
            new StanceLimits(MinimumLength: 0.28, MaximumRaise: 0.45, RearwardShear: -0.05, ForwardShear: 0.5, MaximumPitchDegrees: 22, MaximumFootGrowth: 1.6, LowerPlan: BodyPlan.Sprawling, FewerPlan: BodyPlan.Legless));
    }

    /// <summary>Three fanned pairs at 24, 28 and 32; sometimes arms at 22 and legs at 26, 30 and 33.</summary>
    public static SocketSet Hexapod() => new(
        BodyPlan.Hexapod,
        List(Insect(24, 10, 0.55), Insect(28, 10, 0), Insect(32, 10, -0.55)),
        3,
        new ArmAnatomy(List(Arm(22, 9.5, 0.40) with { Bounds = SocketBounds.Short }), List(Insect(26, 10, 0.5), Insect(30, 10, 0), Insect(33, 10, -0.55)), 0.28, 0.6, 0.42),
        new StanceLimits(MinimumLength: 0.12, MaximumRaise: 0.30, RearwardShear: -0.3, ForwardShear: 0.3, MaximumPitchDegrees: 3, MaximumFootGrowth: 2, LowerPlan: BodyPlan.Legless, FewerPlan: BodyPlan.Sprawling));

    /// <summary>Short legs at any ring from 25 to 42, fanned from front to rear.</summary>
    public static SocketSet ManyLegged()
    {
        var row = new List<LimbSocket>();
        for (int ring = RowFirstRing; ring <= RowLastRing; ring++)
        {
            double azimuth = 0.15 - (0.30 * (ring - RowFirstRing) / (RowLastRing - RowFirstRing));
            row.Add(Splayed(ring, 10, LimbArchetype.Sprawl, 0.52, 0.10, azimuth, SocketBounds.Short));
        }

        return new SocketSet(BodyPlan.ManyLegged, row, 3, null, new StanceLimits(MinimumLength: 0.05, MaximumRaise: 0.20, RearwardShear: -0.3, ForwardShear: 0.3, MaximumPitchDegrees: 3, MaximumFootGrowth: 1.3, LowerPlan: BodyPlan.Legless, FewerPlan: BodyPlan.Sprawling));
    }

    /// <summary>No legs.</summary>
    public static SocketSet Legless() => new(BodyPlan.Legless, Array.Empty<LimbSocket>(), 0, null, new StanceLimits(MinimumLength: 0, MaximumRaise: 0, RearwardShear: 0, ForwardShear: 0, MaximumPitchDegrees: 0, MaximumFootGrowth: 1, LowerPlan: BodyPlan.Legless, FewerPlan: BodyPlan.Legless));

    /// <summary>One pair of a bird's legs at one of 34 to 41.</summary>
    public static IReadOnlyList<LimbSocket> BirdLegs()
    {
        var row = new List<LimbSocket>();
        for (int ring = 34; ring <= 41; ring++)
        {
            row.Add(Under(ring, 10, LimbArchetype.Theropod, 0.62));
        }

        return row;
    }

    /// <summary>Fore and hind legs of a winged quadruped, two pairs, hanging at 24 to 28 and 38 to 41.</summary>
    public static IReadOnlyList<LimbSocket> DragonLegs()
    {
        var row = new List<LimbSocket>();
        for (int ring = 24; ring <= 28; ring++)
        {
            row.Add(Under(ring, 11, LimbArchetype.DigitigradeFore, 0.45));
        }

        for (int ring = 38; ring <= 41; ring++)
        {
            row.Add(Under(ring, 10.8, LimbArchetype.DigitigradeHind, 0.60));
        }

        return row;
    }

    /// <summary>Three or four pairs of legs of a winged beast, anywhere along the trunk from 23 to 43: fore legs ahead of the belly, hind legs behind it.</summary>
    public static IReadOnlyList<LimbSocket> WingedBeastLegs()
    {
        const int First = 23;
        const int Belly = 34;
        const int Last = 43;
        var row = new List<LimbSocket>();
        for (int ring = First; ring <= Last; ring++)
        {
            row.Add(Under(ring, 10.9, ring < Belly ? LimbArchetype.DigitigradeFore : LimbArchetype.DigitigradeHind, 0.45 + (0.15 * (ring - First) / (Last - First))) with { Bounds = SocketBounds.Short });
        }

        return row;
    }

    /// <summary>Legs of a winged insect, hanging at any ring from 22 to 39: room for eight pairs.</summary>
    public static IReadOnlyList<LimbSocket> WingedInsectLegs()
    {
        const int First = 22;
        const int Last = 39;
        var row = new List<LimbSocket>();
        for (int ring = First; ring <= Last; ring++)
        {
            double azimuth = 0.45 - (1.15 * (ring - First) / (Last - First));
            row.Add(Insect(ring, 10.6, azimuth) with { Girth = 0.22 });
        }

        return row;
    }

    private static LimbSocket Under(int ring, double segment, LimbArchetype archetype, double girth) => new(ring, segment, archetype, girth, 0, 0, SocketBounds.Limb);

    private static LimbSocket Arm(int ring, double segment, double girth) => new(ring, segment, LimbArchetype.Arm, girth, 0, 0, SocketBounds.Limb);

    private static LimbSocket Splayed(int ring, double segment, LimbArchetype archetype, double girth, double reach, double azimuth, SocketBounds bounds) =>
        new(ring, segment, archetype, girth, reach, azimuth, bounds);

    private static LimbSocket Insect(int ring, double segment, double azimuth) => Splayed(ring, segment, LimbArchetype.Insect, 0.28, 0.35, azimuth, SocketBounds.Insect);

    private static IReadOnlyList<LimbSocket> List(params LimbSocket[] sockets) => sockets;
}
