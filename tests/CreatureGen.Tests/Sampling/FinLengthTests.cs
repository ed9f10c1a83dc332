using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Fins;
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

    /// <summary>Most that a pair hangs down for each unit that it is swept back, with room for the last digit; what counts is the sweep of its axis, but for those under the belly, which keep off the flank.</summary>
    private const double SteepestFall = 0.3501;

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
    public void No_mixed_swimmer_holds_its_fins_like_legs(double strangeness) =>
        Assert.All(Pairs(strangeness), fin => Assert.InRange(fin.Drop, 0, SteepestFall * (fin.Socket.Segment < 11 ? FlankFin.AxisSweep(fin.Style) : 1) * fin.Sweep));

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

    private static FinBlueprint[] Pairs(double strangeness) => Enumerable.Range(9990001, 72)
        .SelectMany(seed => BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = strangeness }).Fins)
        .Where(fin => fin.Place == FinPlace.Pectoral)
        .ToArray();
}
