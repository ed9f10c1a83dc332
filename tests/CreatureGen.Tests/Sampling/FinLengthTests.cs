using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Placement;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class FinLengthTests
{
    /// <summary>Longest flipper of a turtle, metres at scale 1, and how much longer those of a strange one grow.</summary>
    private const double Longest = 0.75 * 1.15;

    /// <summary>Deepest pair, metres at scale 1.</summary>
    private const double Deepest = 0.4201;

    // Least and most that a pair hangs down for each unit that it stands out: a level one is an edge from the front and behind, a steep one a leg from the side.
    private const double Level = 0.3999;
    private const double Steep = 0.7501;

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void No_mixed_swimmer_rows_with_stilts(double strangeness)
    {
        FinBlueprint[] pairs = Pairs(strangeness);
        Assert.True(pairs.Length > 60);
        Assert.All(pairs, fin => Assert.InRange(fin.Length, 0, Longest));
    }

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void No_mixed_swimmer_holds_its_fins_level_or_like_legs(double strangeness) => Assert.All(Pairs(strangeness), fin => Assert.InRange(fin.Drop, Level, Steep));

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void No_mixed_swimmer_rows_with_slabs(double strangeness) =>
        Assert.All(Pairs(strangeness), fin => Assert.InRange(fin.Length * fin.Width, 0, Deepest));

    [Fact]
    public void A_plan_that_may_have_a_fin_on_its_back_has_one_on_a_mixed_body()
    {
        Assert.Equal(new CountRange(1, 1), FinAnatomy.Whale.WithDorsal().Dorsals);
        Assert.Same(FinAnatomy.Fish, FinAnatomy.Fish.WithDorsal());
        Assert.Same(FinAnatomy.Flipper, FinAnatomy.Flipper.WithDorsal());
    }

    /// <summary>Pairs of all but rays, whose small ones lie beside the tail in the plane of the disc.</summary>
    private static FinBlueprint[] Pairs(double strangeness) => Enumerable.Range(9990001, 72)
        .Select(seed => BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = strangeness }))
        .Where(creature => creature.Body.Disc.Sweep == 0)
        .SelectMany(creature => creature.Fins)
        .Where(fin => fin.Place == FinPlace.Pectoral)
        .ToArray();
}
