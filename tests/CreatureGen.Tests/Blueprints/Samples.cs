using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;

namespace CreatureGen.Tests.Blueprints;

/// <summary>Blueprints to test with.</summary>
internal static class Samples
{
    /// <summary>A small valid creature with something in every list.</summary>
    public static CreatureBlueprint Small => CreatureFields.Creature.Neutral with
    {
        Seed = 18446744073709551615,
        Kind = LocomotionKind.Flying,
        Plan = BodyPlan.Flapping,
        Scale = 1.25,
        Head = HeadFields.Head.Neutral with
        {
            Bumps = new ValueList<HeadBump>(new[] { new HeadBump(9.2, 4.2, 1.6, 1.3, 0.1), new HeadBump(8.4, 1, 1.5, 1.6, -0.05) }),
            Mouth = new MouthBlueprint(8, 0.1, -0.25, 0.14, TongueStyle.Forked),
        },
        Tail = new TailBlueprint(TailStyle.Fork, 0.29, 1.5),
        Legs = new ValueList<LegBlueprint>(new[]
        {
            LimbFields.Leg.Neutral with { Archetype = LimbArchetype.Arm, Stance = LegStance.Hanging },
            LimbFields.Leg.Neutral with { Socket = new SocketBlueprint(39, 8, 4, 4), Thickness = 1.0 / 3 },
        }),
        Wings = new ValueList<WingBlueprint>(new[] { LimbFields.Wing.Neutral }),
        InsectWings = new ValueList<InsectWingBlueprint>(new[] { LimbFields.InsectWing.Neutral }),
        Fins = new ValueList<FinBlueprint>(new[] { LimbFields.Fin.Neutral with { Socket = new SocketBlueprint(32, 31, 8, 2) } }),
        Ears = new ValueList<EarBlueprint>(new[] { LimbFields.Ear.Neutral }),
        Features = new ValueList<FeatureBlueprint>(new[] { LimbFields.Feature.Neutral }),
        Manes = new ValueList<ManeBlueprint>(new[] { NeckFields.Mane.Neutral }),
        Frills = new ValueList<FrillBlueprint>(new[] { NeckFields.Frill.Neutral }),
    };

    /// <summary>Creatures of all kinds, as the sampler draws them.</summary>
    public static IEnumerable<CreatureBlueprint> Drawn(int seedsPerKind)
    {
        foreach (LocomotionKind kind in Enum.GetValues<LocomotionKind>())
        {
            for (ulong seed = 1; seed <= (ulong)seedsPerKind; seed++)
            {
                yield return BlueprintSampler.Sample(seed, kind);
            }
        }
    }
}
