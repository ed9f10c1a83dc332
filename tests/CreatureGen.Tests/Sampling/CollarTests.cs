using System;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class CollarTests
{
    /// <summary>Least tilt of a collar in the water, radians (.3 of a fan on land).</summary>
    private const double LaidBack = 0.65;

    private static readonly Lazy<CreatureBlueprint[]> collared = new(() => Enumerable.Range(11200001, 1200)
        .Select(seed => BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = 1 }))
        .Where(creature => creature.Frills.Count > 0)
        .ToArray());

    [Fact]
    public void No_body_with_the_edge_of_a_ray_wears_a_collar_that_this_would_cut_through()
    {
        Assert.InRange(collared.Value.Length, 10, 400);
        Assert.DoesNotContain(collared.Value, creature => SpeciesCatalogue.Find(creature.Body.Blend.First).Disc.Sweep != 0);
    }

    [Fact]
    public void Collars_are_laid_back_in_the_water() =>
        Assert.All(collared.Value, creature => Assert.All(creature.Frills, frill => Assert.True(frill.Tilt > LaidBack, FormattableString.Invariant($"{creature.Seed}: {frill.Tilt:0.00}"))));
}
