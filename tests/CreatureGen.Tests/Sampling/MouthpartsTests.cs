using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class MouthpartsTests
{
    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    public void Heads_of_insects_on_strange_creatures_have_jaws_and_a_lip(RequestedKind kind)
    {
        int heads = 0;
        for (ulong seed = 11030001; seed <= 11030300; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
            if (SpeciesCatalogue.Find(creature.Body.Blend.Face).Class == AnimalClass.Arthropod)
            {
                Assert.True(creature.Features.Any(part => part.Kind == FeatureKind.Mandible), FormattableString.Invariant($"{seed}"));
                Assert.Contains(creature.Head.Bumps, bump => bump is { Ring: 1.4, Segment: 0, Amount: < -0.1 });
                heads++;
            }
        }

        Assert.NotEqual(0, heads);
    }

    [Fact]
    public void Moths_keep_their_heads_as_animals()
    {
        CreatureOptions moths = CreatureOptions.Default with { Kind = RequestedKind.Flying, Strangeness = 0, BaseBodies = new ValueList<BaseBodyWeight>([new BaseBodyWeight("moth", 1000)]) };
        int heads = 0;
        for (ulong seed = 1; seed <= 60; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, moths);
            bool moth = creature.Body.Blend.Face == "moth";
            Assert.False(moth && creature.Features.Any(part => part.Kind == FeatureKind.Mandible), FormattableString.Invariant($"{seed}"));
            heads += moth ? 1 : 0;
        }

        Assert.NotEqual(0, heads);
    }
}
