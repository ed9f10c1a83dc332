using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

/// <summary>Fliers stand on the legs that the rules give them.</summary>
public sealed class FlierLegsTests
{
    [Fact]
    public void Fliers_stand_on_all_of_their_legs_or_let_all_of_them_hang()
    {
        int standing = 0;
        for (ulong seed = 20000; seed < 20400; seed++)
        {
            CreatureBlueprint flier = BlueprintSampler.Sample(seed, LocomotionKind.Flying);
            LegBlueprint[] legs = flier.Legs.Where(leg => leg.Archetype is not (LimbArchetype.Raptorial or LimbArchetype.Arm)).ToArray();
            Assert.True(legs.Select(leg => leg.Stance).Distinct().Count() <= 1, $"seed {seed}");
            standing += legs.Any(leg => leg.Stance == LegStance.Standing) ? 1 : 0;
        }

        Assert.InRange(standing, 360, 399);
    }

    [Fact]
    public void A_flier_that_stands_has_its_feet_on_the_ground_and_its_wings_above_them()
    {
        for (ulong seed = 21000; seed < 21080; seed++)
        {
            Creature creature = CreatureGenerator.Build(BlueprintSampler.Sample(seed, LocomotionKind.Flying));
            Assert.Empty(CreatureInspection.Inspect(creature));
            LimbChain[] feet = creature.Limbs.Where(limb => limb.Stands).ToArray();
            float wings = creature.Limbs.Where(limb => limb.Kind is LimbKind.Wing or LimbKind.InsectWing).Min(limb => creature.Skeleton.ModelPositions[limb.Joints[0]].Y);
            Assert.All(feet, foot => Assert.True(Math.Abs(foot.Contact.Y) < 1e-4f && wings > 0.5f * creature.Skeleton.ModelPositions[foot.Joints[1]].Y, $"seed {seed}"));
        }
    }

    [Fact]
    public void A_flying_insect_stands_on_as_many_legs_as_its_walking_sister()
    {
        int compared = 0;
        for (ulong seed = 22000; seed < 22400; seed++)
        {
            CreatureBlueprint flier = BlueprintSampler.Sample(seed, LocomotionKind.Flying);
            int legs = flier.Legs.Count(leg => leg.Stance == LegStance.Standing);
            if (flier.Body.Blend.First is "beetle" or "wasp" or "butterfly" or "dragonfly")
            {
                Assert.Equal(3, legs);
                compared++;
            }
            else if (flier.Body.Blend.First == "mantis")
            {
                Assert.Equal(2, legs);
                Assert.Contains(flier.Legs, leg => leg.Archetype == LimbArchetype.Raptorial);
                compared++;
            }
        }

        Assert.True(compared > 40);
    }
}
