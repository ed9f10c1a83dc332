using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class ArmsOfBipedsTests
{
    /// <summary>Without the rule both are bare: a pear on posts.</summary>
    [Theory]
    [InlineData(21100027, BodyPlan.Theropod)]
    [InlineData(21150004, BodyPlan.Upright)]
    public void Mixed_bodies_on_two_legs_without_wings_have_arms_where_there_is_room(int seed, BodyPlan plan)
    {
        CreatureBlueprint creature = BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        Assert.Equal(plan, creature.Plan);
        Assert.Empty(creature.Wings);
        Assert.Contains(creature.Legs, leg => leg.Archetype == LimbArchetype.Arm);
    }
}
