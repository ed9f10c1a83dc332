using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Repairs;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Inspection;

/// <summary>What comes out of this door is sound, whatever went in.</summary>
public sealed class BlueprintDoorTests
{
    private static readonly CreatureBlueprint Animal = BlueprintSampler.Sample(42, LocomotionKind.Walking);

    private static CreatureBlueprint Sunk => Animal with { Body = Animal.Body with { Elevation = 0.2 * Animal.Body.Elevation } };

    [Fact]
    public void A_sound_creature_is_the_one_that_is_built_without_a_look()
    {
        Creature sound = CreatureGenerator.Build(Animal);
        Assert.True(CreatureAssembler.Assemble(Animal).Mesh.Positions.SequenceEqual(sound.Mesh.Positions));
    }

    [Fact]
    public void A_creature_in_the_ground_is_refused_with_all_that_is_broken()
    {
        Assert.Empty(BlueprintValidator.Validate(Sunk));
        var refusal = Assert.Throws<UnsoundCreatureException>("blueprint", () => CreatureGenerator.Build(Sunk));
        Assert.Equal(CreatureInspection.Inspect(CreatureAssembler.Assemble(Sunk)), refusal.Violations);
        Assert.All(refusal.Violations, v => Assert.Contains(v.Detail, refusal.Message, StringComparison.Ordinal));
        Assert.Contains("BlueprintRepair", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void What_was_refused_and_repaired_is_let_in() => CreatureGenerator.Build(BlueprintRepair.Repair(Sunk).Blueprint);

    [Fact]
    public void A_blueprint_with_problems_is_refused_as_always() =>
        Assert.IsNotType<UnsoundCreatureException>(Assert.ThrowsAny<ArgumentException>(() => CreatureGenerator.Build(Animal with { Scale = 1e9 })));

    [Theory]
    [InlineData(EyeStyle.Round, 0.26)]
    [InlineData(EyeStyle.Slit, -0.1)]
    public void Lids_of_a_single_eye_are_level_whatever_roll_is_asked_for(EyeStyle style, double roll)
    {
        CreatureBlueprint cyclops = Animal with { Head = Animal.Head with { Eyes = Animal.Head.Eyes with { Style = style, Segment = 0, LidTilt = roll } } };
        Assert.DoesNotContain(CreatureInspection.Inspect(CreatureAssembler.Assemble(cyclops)), violation => violation.Invariant == "mirrored");
        Assert.True(CreatureAssembler.Assemble(cyclops with { Head = cyclops.Head with { Eyes = cyclops.Head.Eyes with { LidTilt = 0 } } }).Mesh.Positions.SequenceEqual(CreatureAssembler.Assemble(cyclops).Mesh.Positions));
    }
}
