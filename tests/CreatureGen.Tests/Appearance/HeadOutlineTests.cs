using System;
using System.Linq;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Appearance;

public sealed class HeadOutlineTests
{
    private const int Count = 60;

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void Heads_of_walkers_stand_out_against_their_bodies_from_ahead(double strangeness)
    {
        double[] seen = Enumerable.Range(15030001, Count)
            .Select(seed => HeadOutline.Seen(CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = strangeness })))
            .Order()
            .ToArray();
        Assert.True(seen.Average() > 0.82 && seen[Count / 10] > 0.62, FormattableString.Invariant($"{seen.Average():0.000} of the outlines, {seen[Count / 10]:0.000} of the tenth worst"));
    }
}
