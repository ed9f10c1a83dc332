using System;
using CreatureGen.Motion;
using CreatureGen.Sampling;
using CreatureGen.Creatures;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

public sealed class SharpestTurnTests
{
    [Theory]
    [InlineData(7100001UL, 0f)]
    [InlineData(7100005UL, 0f)]
    [InlineData(7100005UL, 0.5f)]
    [InlineData(7100013UL, 0.3f)]
    public void A_walker_turns_as_sharply_as_it_tells_and_hardly_sharper(ulong seed, float fraction)
    {
        var profile = new MotionProfile(Walkers.Any(seed));
        float speed = fraction * profile.Gaits!.TopSpeed;
        var animator = new CreatureAnimator(profile);
        Walkers.Run(animator, 3f, 60f, new MotionInput(speed), FlatGround.Level);
        float sharpest = animator.SharpestTurn(speed)!.Value;
        Assert.InRange(Turned(animator, speed, sharpest), 0.95f * sharpest, 1.01f * sharpest);
        Assert.True(Turned(animator, speed, 3f * sharpest) < 1.1f * sharpest, $"{seed} turns by {Turned(animator, speed, 3f * sharpest)}, tells {sharpest}");
    }

    /// <summary>Their legs stand nearly straight, and were thought to reach no farther aside than a few hundredths of their length (.88 and .42 radians per second): a body comes down over legs that step wide.</summary>
    [Theory]
    [InlineData(24790014UL, 2f)]
    [InlineData(24790006UL, 0.7f)]
    public void Who_stands_on_straight_legs_turns_on_the_spot_as_far_as_its_hips_and_ankles_let_them_lean(ulong seed, float least)
    {
        var animator = new CreatureAnimator(new MotionProfile(Walkers.Any(seed)));
        Assert.True(animator.SharpestTurn(0f) >= least, $"{seed} turns by {animator.SharpestTurn(0f)}");
        Assert.True(Turned(animator, 0f, least) >= 0.95f * least, $"{seed} turns by {Turned(animator, 0f, least)}");
    }

    [Fact]
    public void What_has_no_legs_tells_none_and_speeds_that_are_no_numbers_are_refused()
    {
        var fish = new CreatureAnimator(CreatureGenerator.Generate(1, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = 0 }));
        Assert.Null(fish.SharpestTurn(0f));
        Assert.Throws<ArgumentOutOfRangeException>(() => fish.SharpestTurn(float.NaN));
    }

    /// <summary>Radians per second in the second after two.</summary>
    private static float Turned(CreatureAnimator animator, float speed, float asked)
    {
        var input = new MotionInput(speed, asked);
        Walkers.Run(animator, 2f, 60f, input, FlatGround.Level);
        double sum = 0;
        for (int i = 0; i < 60; i++)
        {
            RootPlace before = animator.Root;
            animator.Update(1f / 60f, input, FlatGround.Level);
            sum += 2 * Math.Asin(Math.Clamp((before.Rotation.W * animator.Root.Rotation.Y) - (before.Rotation.Y * animator.Root.Rotation.W), -1f, 1f));
        }

        return (float)Math.Abs(sum);
    }
}
