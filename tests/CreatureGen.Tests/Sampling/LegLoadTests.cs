using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Shapes;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class LegLoadTests
{
    /// <summary>Thinnest shank under a mixed trunk on an insect's legs, relative to the edge of a cube as large as its share of the trunk: what the most that legs get thicker by leaves of the .085 asked for (.042 with less, .027 with none).</summary>
    private const double Insects = 0.054;

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    public void Insects_of_stout_bodies_do_not_stand_on_wires(RequestedKind kind)
    {
        int legs = 0;
        for (ulong seed = 9990001; seed <= 9990060; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            foreach (LegBlueprint leg in creature.Legs)
            {
                if (leg.Stance == LegStance.Standing && leg.Archetype == LimbArchetype.Insect)
                {
                    double share = Math.Cbrt(StanceSampler.Volume(shape) / (2 * creature.Legs.Count));
                    double shank = LegKinds.Of(leg.Archetype).Outline.ShankRadius() * leg.Thickness * leg.Stoutness * leg.Slimness;
                    Assert.True(shank / share >= Insects, FormattableString.Invariant($"{seed}: {shank / share:0.000}"));
                    legs++;
                }
            }
        }

        Assert.InRange(legs, 10, 1000);
    }

    [Fact]
    public void Legs_of_insects_that_hang_in_the_air_are_as_thick_as_those_that_stand()
    {
        int legs = 0;
        for (ulong seed = 11030001; seed <= 11030600; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying });
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            foreach (LegBlueprint leg in creature.Legs)
            {
                if (leg.Stance == LegStance.Hanging && leg.Archetype == LimbArchetype.Insect)
                {
                    double share = Math.Cbrt(StanceSampler.Volume(shape) / (2 * creature.Legs.Count));
                    double shank = LegKinds.Of(leg.Archetype).Outline.ShankRadius() * leg.Thickness * leg.Stoutness * leg.Slimness;
                    Assert.True(shank / share >= Insects, FormattableString.Invariant($"{seed}: {shank / share:0.000}"));
                    legs++;
                }
            }
        }

        Assert.NotEqual(0, legs);
    }

    [Fact]
    public void Legs_of_animals_are_as_thick_as_their_species_has_them()
    {
        for (ulong seed = 9990001; seed <= 9990020; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 0 });
            Assert.All(creature.Legs, leg => Assert.True(leg.Archetype != LimbArchetype.Insect || leg.Slimness == 1));
        }
    }
}
