using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class ForkSamplerTests
{
    private const ulong First = 9_700_000;

    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(0.6, 0.001, 0.03)]
    [InlineData(1, 0.02, 0.08)]
    public void Two_heads_are_rare_and_less_so_with_strangeness(double strangeness, double least, double most)
    {
        int count = Thoroughness.Of(1500);
        CreatureOptions options = CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = strangeness };
        int forked = Enumerable.Range(0, count).AsParallel().Count(i => BlueprintSampler.Sample(First + (ulong)i, options).Fork != null);
        Assert.InRange((double)forked / count, least, most);
    }

    [Fact]
    public void All_individuals_of_a_species_with_two_heads_have_two()
    {
        CreatureOptions options = CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 1 };
        ulong seed = First;
        while (BlueprintSampler.Sample(seed, options).Fork == null)
        {
            seed++;
        }

        for (ulong individual = 1; individual <= 4; individual++)
        {
            CreatureBlueprint one = BlueprintSampler.Sample(seed, options with { Individual = individual });
            Assert.NotNull(one.Fork);
            Assert.Empty(CreatureInspection.Inspect(CreatureAssembler.Assemble(one)));
        }
    }
}
