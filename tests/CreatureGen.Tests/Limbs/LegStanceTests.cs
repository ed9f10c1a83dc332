using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Limbs;

/// <summary>Legs as they are seen from the front, and as they are carried in the air.</summary>
public sealed class LegStanceTests
{
    private const ulong First = 14010001;
    private const int Count = 60;

    /// <summary>Mean distance of the feet of four-legged bodies from the sagittal plane in those of their hips (1.00 where they stand straight down).</summary>
    private const double FourLegged = 0.94;

    /// <summary>Mean distance of the feet of bipeds from the sagittal plane in heights of their hips (.29 where their toes point straight ahead).</summary>
    private const double Bipeds = 0.275;

    [Fact]
    public void Feet_of_four_legs_stand_in_under_the_body()
    {
        List<double> four = Ratios(hip => hip.X, LimbArchetype.UnguligradeFore, LimbArchetype.UnguligradeHind, LimbArchetype.DigitigradeFore, LimbArchetype.DigitigradeHind, LimbArchetype.Column);
        Assert.InRange(four.Count, 10, 8 * Count);
        Assert.True(four.Average() < FourLegged, FormattableString.Invariant($"{four.Average():0.00} of the hips' distance, {four.Count} legs"));
    }

    [Fact]
    public void Feet_of_bipeds_stand_near_each_other()
    {
        List<double> two = Ratios(hip => hip.Y, LimbArchetype.Theropod, LimbArchetype.Bird);
        Assert.InRange(two.Count, 5, 8 * Count);
        Assert.True(two.Average() < Bipeds, FormattableString.Invariant($"{two.Average():0.00} of the hips' height, {two.Count} legs"));
    }

    [Fact]
    public void Legs_of_an_insect_that_hovers_are_drawn_up_and_trail()
    {
        int legs = 0;
        for (ulong seed = 13900007; legs < 12; seed++)
        {
            CreatureBlueprint flier = BlueprintSampler.Sample(seed, LocomotionKind.Flying);
            if (!flier.Legs.Any(leg => leg.Archetype == LimbArchetype.Insect && leg.Stance == LegStance.Hanging))
            {
                continue;
            }

            Creature creature = CreatureGenerator.Build(flier);
            foreach (LimbChain leg in creature.Limbs.Where(limb => limb.Archetype == LimbArchetype.Insect && limb.Side == Side.Left))
            {
                Vector3 At(int joint) => creature.Skeleton.ModelPositions[leg.Joints[joint]];
                Assert.True(At(2).Y > At(1).Y, $"{seed}: a knee below its hip");
                Assert.True(At(4).Z < At(2).Z && At(2).X - At(4).X < 0.5f * (At(2).X - At(1).X), $"{seed}: a shank that hangs straight down or under the body");
                legs++;
            }
        }
    }

    private static List<double> Ratios(Func<Vector3, float> unit, params LimbArchetype[] archetypes)
    {
        var ratios = new List<double>();
        for (ulong seed = First; seed < First + Count; seed++)
        {
            CreatureBlueprint walker = BlueprintSampler.Sample(seed, LocomotionKind.Walking);
            if (!walker.Legs.Any(leg => Array.IndexOf(archetypes, leg.Archetype) >= 0))
            {
                continue;
            }

            Creature creature = CreatureGenerator.Build(walker);
            ratios.AddRange(creature.Limbs
                .Where(limb => limb.Stands && limb.Side == Side.Left && Array.IndexOf(archetypes, limb.Archetype!.Value) >= 0)
                .Select(limb => (double)limb.Contact.X / unit(creature.Skeleton.ModelPositions[limb.Joints[1]])));
        }

        return ratios;
    }
}
