using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Sampling;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

/// <summary>Pairs of legs that are asked for.</summary>
public sealed class LegPairTests
{
    public static IEnumerable<TheoryDataRow<int>> Numbers => Enumerable.Range(0, 17).Select(pairs => new TheoryDataRow<int>(pairs) { Explicit = pairs % 4 > 0 });

    [Theory]
    [MemberData(nameof(Numbers))]
    public void Every_seed_gives_a_sound_walker_with_any_number_of_pairs(int pairs)
    {
        for (ulong seed = 1; seed <= 4; seed++)
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample(seed, Asking(pairs, pairs));
            Assert.Equal(pairs, blueprint.Legs.Count);
            Assert.Empty(CreatureInspection.Inspect(CreatureAssembler.Assemble(blueprint)));
        }
    }

    [Fact]
    public void A_creature_whose_number_will_do_is_the_same_with_and_without_being_asked()
    {
        for (ulong seed = 0; seed < 400; seed++)
        {
            CreatureBlueprint own = BlueprintSampler.Sample(seed, LocomotionKind.Walking);
            Assert.Equal(own, BlueprintSampler.Sample(seed, Asking(own.Legs.Count, own.Legs.Count)));
        }
    }

    [Theory]
    [InlineData(1, 5, 5)]
    [InlineData(8, 10, 8)]
    [InlineData(5, 7, 6)]
    public void A_row_gives_the_number_of_pairs_that_is_nearest_to_its_own(int least, int most, int pairs)
    {
        var row = new LegRow(18, 51, 9.7, 0.35, -0.45);
        var preset = new LegPreset { Row = row, Sites = row.Sites(6) };
        Assert.Equal(pairs, preset.SitesWithin(least, most).Length);
    }

    [Fact]
    public void A_row_has_its_ends_where_they_are_and_sockets_that_share_no_cell()
    {
        var row = new LegRow(18, 51, 9.7, 0.35, -0.45);
        for (int pairs = LegRow.Fewest; pairs <= LegRow.Max; pairs++)
        {
            LegSite[] sites = row.Sites(pairs);
            Assert.Equal(pairs, sites.Length);
            Assert.Equal((18, 0.35), (sites[0].Ring, sites[0].Azimuth));
            Assert.Equal(51, sites[^1].Ring);
            Assert.Equal(-0.45, sites[^1].Azimuth, 1e-12);
            Assert.All(sites.Skip(1).Zip(sites), pair => Assert.True(pair.First.Ring - pair.Second.Ring >= 2));
        }
    }

    private static CreatureOptions Asking(int least, int most) => CreatureOptions.Default with { Kind = RequestedKind.Walking, MinLegPairs = least, MaxLegPairs = most };
}
