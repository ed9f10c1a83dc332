using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
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

    /// <summary>At .85 of the first pair they hung beside the knees, and their arms seemed to grow from the hips.</summary>
    [Theory]
    [InlineData(24660031)]
    public void Hands_of_a_second_pair_of_arms_hang_above_the_knees(int seed)
    {
        Creature creature = CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        LimbChain[] arms = [.. creature.Limbs.Where(limb => limb.Kind == LimbKind.Arm && limb.Side == Side.Left)];
        LimbChain leg = creature.Limbs.First(limb => limb.Kind == LimbKind.Leg);
        Assert.Equal(2, arms.Length);
        float hand = Height(arms[1].Joints[^1]);
        float knee = Height(leg.Joints.First(joint => creature.Skeleton.Joints[joint].Role == JointRole.Knee));
        Assert.True(hand > knee, FormattableString.Invariant($"the hand hangs at {hand} m, the knee is at {knee} m"));

        float Height(int joint) => creature.Skeleton.ModelPositions[joint].Y;
    }
}
