using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class FinLengthTests
{
    /// <summary>Longest flipper of a turtle, metres at scale 1, and how much longer those of a strange one grow.</summary>
    private const double Longest = 0.75 * 1.15;

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void No_mixed_swimmer_rows_with_stilts(double strangeness)
    {
        FinBlueprint[] pairs = Enumerable.Range(9990001, 60)
            .SelectMany(seed => BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = strangeness }).Fins)
            .Where(fin => fin.Place == FinPlace.Pectoral)
            .ToArray();
        Assert.True(pairs.Length > 60);
        Assert.All(pairs, fin => Assert.InRange(fin.Length, 0, Longest));
    }
}
