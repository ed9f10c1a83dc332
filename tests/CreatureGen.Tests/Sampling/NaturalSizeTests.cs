using System;
using System.Linq;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Parents;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class NaturalSizeTests
{
    [Fact]
    public void Every_species_has_a_torso_of_some_length_and_together_they_reach_from_the_smallest_to_the_greatest()
    {
        Assert.All(SpeciesCatalogue.All, species => Assert.True(
            species.TorsoLength.Min >= NaturalSize.Smallest && species.TorsoLength.Max <= NaturalSize.Greatest && species.TorsoLength.Max >= 1.2 * species.TorsoLength.Min,
            $"{species.Body} {species.TorsoLength}"));
        Assert.Equal(NaturalSize.Smallest, SpeciesCatalogue.All.Min(species => species.TorsoLength.Min));
        Assert.Equal(NaturalSize.Greatest, SpeciesCatalogue.All.Max(species => species.TorsoLength.Max));
    }

    [Fact]
    public void Who_is_larger_in_life_is_larger_in_a_game()
    {
        string[] bodies = ["ant", "frog", "rabbit", "lion", "rhino"];
        (double Least, double Greatest)[] sizes = Array.ConvertAll(bodies, body => Range(SpeciesSubject.Only(body, RequestedKind.Walking)));
        for (int i = 1; i < bodies.Length; i++)
        {
            Assert.True(sizes[i - 1].Greatest < sizes[i].Least, FormattableString.Invariant($"{bodies[i - 1]} {sizes[i - 1]}, {bodies[i]} {sizes[i]}"));
        }
    }

    [Fact]
    public void An_ant_is_smaller_than_a_bear_whatever_the_seed()
    {
        for (ulong seed = 0; seed < 24; seed++)
        {
            double ant = BlueprintSampler.Sample(seed, SpeciesSubject.Only("ant", RequestedKind.Walking)).Scale;
            double bear = BlueprintSampler.Sample(seed, SpeciesSubject.Only("bear", RequestedKind.Walking)).Scale;
            Assert.True(1.2 * ant < bear, FormattableString.Invariant($"seed {seed}: ant {ant}, bear {bear}"));
        }
    }

    [Fact]
    public void The_smallest_are_no_smaller_than_can_be_seen_beside_the_others()
    {
        double[] sizes = Enumerable.Range(0, 60).Select(seed => BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default).Scale).OrderBy(size => size).ToArray();
        Assert.True(sizes[0] > 0.6 * sizes[30], FormattableString.Invariant($"{sizes[0]} of {sizes[30]}"));
    }

    [Fact]
    public void Sizes_lie_within_what_is_asked_for_and_fill_most_of_it()
    {
        (double least, double greatest) = Range(CreatureOptions.Default, 60);
        Assert.InRange(least, 0.5, 1);
        Assert.InRange(greatest, 1.5, 2);
        (least, greatest) = Range(CreatureOptions.Default with { MinScale = 0.05, MaxScale = 20 }, 60);
        Assert.InRange(least, 0.05, 1);
        Assert.InRange(greatest, 5, 20);
        Assert.Equal((0.7, 0.7), Range(CreatureOptions.Default with { MinScale = 0.7, MaxScale = 0.7 }));
    }

    [Fact]
    public void A_mix_is_between_its_parents_and_strangeness_loosens_it()
    {
        var pure = new Parentage(SpeciesCatalogue.Find("rhino"), SpeciesCatalogue.Find("rabbit"), SpeciesCatalogue.Find("ant"));
        (double From, double To) rhino = NaturalSize.RangeOf(pure, 0);
        (double From, double To) mixed = NaturalSize.RangeOf(pure with { Torso = (0.5, 0.3, 0.2) }, 0);
        (double From, double To) strange = NaturalSize.RangeOf(pure with { Torso = (0.5, 0.3, 0.2) }, 1);
        Assert.True(mixed.To < rhino.From);
        Assert.True(mixed.From > NaturalSize.PlaceOf(SpeciesCatalogue.Find("ant").TorsoLength.Max));
        Assert.Equal(mixed.From - NaturalSize.Loosened, strange.From, 1e-12);
        Assert.Equal(mixed.To + NaturalSize.Loosened, strange.To, 1e-12);
        Assert.Equal(1, NaturalSize.RangeOf(pure, 1).To);
    }

    private static (double Least, double Greatest) Range(CreatureOptions options, int seeds = 24)
    {
        double[] sizes = Enumerable.Range(0, seeds).Select(seed => BlueprintSampler.Sample((ulong)seed, options).Scale).ToArray();
        return (sizes.Min(), sizes.Max());
    }
}
