using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class SwimmersWithoutRoomTests
{
    /// <summary>Legs of one parent and fins of another ask for the same cells; a body whose legs left no room for flippers swims by its body.</summary>
    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void However_strange_a_swimmer_is_it_has_the_fins_that_its_plan_needs(double strangeness)
    {
        CreatureOptions options = CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = strangeness };
        ulong[] wrong = Enumerable.Range(7000000, 400).Select(seed => (ulong)seed).Where(seed => BlueprintValidator.Validate(BlueprintSampler.Sample(seed, options)).Count > 0).ToArray();
        Assert.Empty(wrong);
    }
}
