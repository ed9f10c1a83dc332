using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class PaddlingLegsTests
{
    private static readonly TailStyle[] driving = { TailStyle.Fork, TailStyle.Fan, TailStyle.Fluke, TailStyle.Lunate, TailStyle.Heterocercal, TailStyle.Truncate, TailStyle.Veil };

    private const int Seeds = 400;

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void No_hind_legs_of_a_swimmer_hang_in_the_way_of_a_tail_fin_that_drives_it(double strangeness)
    {
        CreatureBlueprint[] legged = Driven(CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = strangeness });
        Assert.InRange(legged.Length, 10, 200);
        Assert.DoesNotContain(legged, creature => creature.Legs.Any(leg => leg.Socket.Ring > BodyGrid.AnchorRing));
    }

    [Theory]
    [InlineData(0.6, 0.02, 0.1)]
    [InlineData(1, 0.05, 0.2)]
    public void Few_swimmers_that_a_tail_fin_drives_have_hands_for_the_fins_beside_it(double strangeness, double least, double most)
    {
        CreatureBlueprint[] driven = Enumerable.Range(10710001, Seeds)
            .Select(seed => BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = strangeness }))
            .Where(creature => driving.Contains(creature.Tail.Style))
            .ToArray();
        Assert.InRange(driven.Count(creature => creature.Legs.Count > 0) / (double)driven.Length, least, most);
    }

    [Fact]
    public void No_paired_fins_grow_under_legs_that_are_laid_back_over_them_or_in_a_bunch_with_those_of_what_winds()
    {
        CreatureBlueprint[] legged = Enumerable.Range(10710001, 400)
            .Select(seed => BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming }))
            .Where(creature => creature.Legs.Count > 0)
            .ToArray();
        Assert.InRange(legged.Length, 20, 400);
        Assert.DoesNotContain(legged, creature => creature.Fins.Any(fin => fin.Place == FinPlace.Pectoral
            && creature.Legs.Any(leg => (creature.Plan == BodyPlan.Eel || fin.Socket.Ring > leg.Socket.Ring) && Math.Abs(fin.Socket.Ring - leg.Socket.Ring) < 10)));
    }

    [Fact]
    public void Forelegs_alone_are_shorter_than_those_of_one_on_four()
    {
        CreatureOptions swimming = CreatureOptions.Default with { Kind = RequestedKind.Swimming };
        Assert.True(Mean(swimming) < 0.9 * Mean(swimming with { MinLegPairs = 2 }));

        static double Mean(CreatureOptions options) => Driven(options).Average(creature => creature.Legs[0].Length / creature.Legs[0].Thickness);
    }

    [Fact]
    public void Who_asks_for_two_pairs_of_legs_gets_the_hind_ones_as_well()
    {
        CreatureBlueprint[] legged = Driven(CreatureOptions.Default with { Kind = RequestedKind.Swimming, MinLegPairs = 2 });
        Assert.NotEmpty(legged);
        Assert.All(legged, creature => Assert.True(creature.Legs.Count >= 2));
    }

    /// <summary>Swimmers with legs and a tail fin to swim by.</summary>
    private static CreatureBlueprint[] Driven(CreatureOptions options) => Enumerable.Range(10710001, Seeds)
        .Select(seed => BlueprintSampler.Sample((ulong)seed, options))
        .Where(creature => creature.Legs.Count > 0 && driving.Contains(creature.Tail.Style))
        .ToArray();
}
