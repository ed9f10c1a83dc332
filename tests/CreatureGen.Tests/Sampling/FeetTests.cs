using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class FeetTests
{
    [Fact]
    public void Only_toes_of_legs_that_are_held_out_to_the_side_end_in_discs()
    {
        int discs = 0;
        for (ulong seed = 10774001; seed <= 10774300; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 1 });
            bool disc = creature.Legs.Any(leg => leg.Foot == FootStyle.Sucker);
            bool under = creature.Plan is BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar or BodyPlan.Centaur;
            Assert.False(disc && under, FormattableString.Invariant($"{seed}"));
            discs += disc ? 1 : 0;
        }

        Assert.NotEqual(0, discs);
    }

    [Fact]
    public void Toes_of_mixed_creatures_end_in_claws()
    {
        for (ulong seed = 11030001; seed <= 11030300; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            bool paws = creature.Plan is BodyPlan.Digitigrade or BodyPlan.Plantigrade;
            Assert.All(creature.Legs, leg => Assert.True(!paws || leg.ClawLength > 0.5, FormattableString.Invariant($"{seed}")));
        }
    }
}
