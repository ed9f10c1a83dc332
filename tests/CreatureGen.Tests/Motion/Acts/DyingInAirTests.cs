using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public class DyingInAirTests
{
    private const float Rate = 60f;

    /// <summary>It turned over where it hovered, and hung there belly up.</summary>
    [Theory]
    [InlineData(22300021UL)]
    [InlineData(22300022UL, Explicit = true)]
    public void What_is_always_in_the_air_falls_dead_and_takes_wing_again(ulong seed)
    {
        CreatureAnimator animator = Flier(seed);
        Assert.Equal(BodyBuild.Airborne, animator.Profile.Acts.Body.Build);
        Run(animator, 1f, default);
        float flew = Highest(animator);
        Die(animator);
        Run(animator, 4f, default);
        Assert.Equal(BodyState.Limp, animator.State);
        Assert.Equal("Die", animator.Act?.Name);
        Assert.InRange(Highest(animator) / flew, 0f, 0.5f);
        GetsUp(animator);
        Run(animator, 1f, default);
        Assert.InRange(Highest(animator) / flew, 0.8f, 1.25f);
    }

    /// <summary>It came down on its wings, landed on its feet, and died then.</summary>
    [Theory]
    [InlineData(22300000UL)]
    [InlineData(22300005UL, Explicit = true)]
    public void A_bird_that_dies_in_flight_falls_as_it_is_and_goes_on_on_its_feet(ulong seed)
    {
        CreatureAnimator animator = Flier(seed);
        Run(animator, 2f, new MotionInput(4f, Medium: MotionMedium.Air, ClimbRate: 1f));
        Assert.False(animator.StandsOnFeet);
        float before = Highest(animator);
        Die(animator);
        Run(animator, 0.25f, default);
        Assert.Equal(BodyState.Limp, animator.State);
        Run(animator, 4f, default);
        Assert.InRange(Highest(animator), 0f, before - animator.Profile.Legs!.LegLength);
        Assert.Equal("Die", animator.Act?.Name);
        GetsUp(animator);
        Assert.True(animator.StandsOnFeet);
    }

    [Fact]
    public void Who_dies_standing_does_not_go_limp_and_another_act_in_the_air_does_not_either()
    {
        CreatureAnimator standing = Flier(22300000);
        Die(standing);
        Run(standing, 1f, default);
        Assert.Equal(BodyState.Supported, standing.State);

        CreatureAnimator hovering = Flier(22300021);
        hovering.Perform("Sleep");
        Run(hovering, 1f, default);
        Assert.Equal(BodyState.Supported, hovering.State);
    }

    [Fact]
    public void A_fall_that_is_broken_off_leaves_a_body_limp_until_it_gets_up()
    {
        CreatureAnimator animator = Flier(22300021);
        Die(animator);
        Run(animator, 3f, default);
        animator.StopAct();
        animator.GoOn();
        Run(animator, 3f, default);
        Assert.Equal((BodyState.Limp, (Act?)null), (animator.State, animator.Act));
        Assert.True(animator.GetUp());
        Run(animator, 6f, default);
        Assert.Equal(BodyState.Supported, animator.State);
    }

    [Fact]
    public void A_fall_gives_the_same_bits_again_and_allocates_nothing_once_it_has_begun()
    {
        CreatureAnimator first = Flier(22300021);
        CreatureAnimator second = Flier(22300021);
        Fall(first);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Run(first, 2f, default);
        Assert.Equal(before, GC.GetAllocatedBytesForCurrentThread());
        Fall(second);
        Run(second, 2f, default);
        Assert.Equal(first.Root, second.Root);
        Assert.True(first.LocalPose.Rotations.SequenceEqual(second.LocalPose.Rotations));

        static void Fall(CreatureAnimator animator)
        {
            Die(animator);
            Run(animator, 0.5f, default);
        }
    }

    private static CreatureAnimator Flier(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying }));
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        return animator;
    }

    private static void Die(CreatureAnimator animator) => Assert.Equal(ActStatus.Started, animator.Perform("Die").Status);

    private static void GetsUp(CreatureAnimator animator)
    {
        animator.GoOn();
        Run(animator, 6f, default);
        Assert.Equal((BodyState.Supported, (Act?)null), (animator.State, animator.Act));
    }

    /// <summary>Height of the highest joint above the ground.</summary>
    private static float Highest(CreatureAnimator animator)
    {
        float highest = 0f;
        foreach (Vector3 joint in animator.ModelPose.Positions)
        {
            highest = Math.Max(highest, animator.Root.ToWorld(joint).Y);
        }

        return highest;
    }

    private static void Run(CreatureAnimator animator, float seconds, MotionInput input) => Walkers.Run(animator, seconds, Rate, input, FlatGround.Level);
}
