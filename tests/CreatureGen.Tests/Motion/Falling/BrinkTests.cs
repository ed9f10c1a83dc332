using System;
using System.Linq;
using CreatureGen.Motion;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>Walkers before holes without a bottom.</summary>
public sealed class BrinkTests
{
    private const float Frame = 1f / 60f;

    /// <summary>Leg lengths from where it starts to the hole.</summary>
    private const float Ahead = 9f;

    /// <summary>All of them ran into it and fell for good.</summary>
    [Theory]
    [InlineData(520, 5)]
    [InlineData(14020030, 30, Explicit = true)]
    public void A_runner_stops_before_a_hole_that_it_cannot_cross_and_goes_back(ulong first, int count)
    {
        foreach (MotionProfile profile in FreeFallTests.Lot(first, count))
        {
            float leg = profile.LegLength;
            var hole = new Holed(0f, point => point.Z > Ahead * leg);
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, hole);
            float foremost = Enumerable.Range(0, animator.FootCount).Max(foot => animator.Foot(foot).Place.Z);
            Go(profile.Gaits!.TopSpeed, 900);
            float tip = (animator.Root.Position.Z + foremost) / leg;
            Assert.True(animator.Speed < 0.02f * MathF.Sqrt(9.81f * leg) || tip < Ahead - 1f, FormattableString.Invariant($"{profile.Subject.Seed} {profile.Subject.Plan} goes on at {animator.Speed} m/s"));
            Assert.True(tip < Ahead + 0.15f, FormattableString.Invariant($"{profile.Subject.Seed} {profile.Subject.Plan}: {tip - Ahead} legs over the brink"));
            float before = animator.Root.Position.Z;
            Go(-profile.Gaits.TopSpeed, 120);
            Assert.True(animator.Root.Position.Z < before - (0.2f * leg), FormattableString.Invariant($"{profile.Subject.Seed} {profile.Subject.Plan} does not go back"));

            void Go(float speed, int frames)
            {
                for (int i = 0; i < frames; i++)
                {
                    animator.Update(Frame, new MotionInput(speed), hole);
                    Assert.True(animator.State == BodyState.Supported, FormattableString.Invariant($"{profile.Subject.Seed} {profile.Subject.Plan}: {animator.State}"));
                }
            }
        }
    }

    [Fact]
    public void A_hole_of_half_a_leg_length_is_crossed_at_a_run()
    {
        foreach (MotionProfile profile in FreeFallTests.Lot(520, 5))
        {
            float leg = profile.LegLength;
            var hole = new Holed(0f, point => point.Z > Ahead * leg && point.Z < (Ahead + 0.5f) * leg);
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, hole);
            for (int i = 0; i < 1500 && animator.Root.Position.Z < (Ahead + 3f) * leg; i++)
            {
                animator.Update(Frame, new MotionInput(profile.Gaits!.TopSpeed), hole);
                Assert.Equal(BodyState.Supported, animator.State);
            }

            Assert.True(animator.Root.Position.Z >= (Ahead + 3f) * leg, FormattableString.Invariant($"{profile.Subject.Seed} {profile.Subject.Plan} stays at {animator.Root.Position.Z / leg}"));
        }
    }

    [Fact]
    public void Lower_ground_is_no_hole()
    {
        MotionProfile profile = FreeFallTests.Lot(520, 1).Single();
        float leg = profile.LegLength;
        var edge = new Cliff(3f * leg, 20f * leg);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, edge);
        bool fell = false;
        for (int i = 0; i < 900 && !fell; i++)
        {
            animator.Update(Frame, new MotionInput(profile.Gaits!.Speeds[0].Comfortable), edge);
            fell = animator.State == BodyState.Falling;
        }

        Assert.True(fell);
    }
}
