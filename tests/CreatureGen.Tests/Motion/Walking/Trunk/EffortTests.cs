using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Trunk;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Trunk;

public sealed class EffortTests
{
    [Fact]
    public void A_body_at_steady_speed_shows_none()
    {
        Assert.Equal(default, Effort.Of(Body(1), 0f, 0f));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(5)]
    public void It_crouches_and_leans_into_a_start_and_sits_back_in_braking(ulong seed)
    {
        LeggedBody body = Body(seed);
        Effort starts = Effort.Of(body, 0.4f, 0f);
        Effort brakes = Effort.Of(body, -0.4f, 0f);
        Assert.True(starts.HindDrop > 0f && starts.ForeDrop > starts.HindDrop && starts.Shift > 0f && starts.Lean > 0f && starts.Neck > 0f && starts.Tuck > 0f);
        Assert.True(brakes.HindDrop > 0f && brakes.ForeDrop < 0f && brakes.Shift < 0f && brakes.Lean < 0f && brakes.Neck < 0f && brakes.Tuck > starts.Tuck);
        Assert.InRange(brakes.HindDrop, starts.HindDrop, 0.15f * body.LegLength);
    }

    [Fact]
    public void More_than_half_of_gravity_shows_no_more()
    {
        Assert.Equal(Effort.Of(Body(1), 0.5f, 0f), Effort.Of(Body(1), 5f, 0f));
        Assert.Equal(Effort.Of(Body(1), -0.5f, 0f), Effort.Of(Body(1), -5f, 0f));
    }

    [Fact]
    public void Who_brakes_uphill_or_starts_downhill_leaves_to_its_weight_what_that_does()
    {
        LeggedBody body = Body(1);
        Assert.Equal(Effort.Of(body, -0.25f, -0.25f), Effort.Of(body, -0.5f, 0.25f));
        Assert.Equal(Effort.Of(body, 0.25f, 0.25f), Effort.Of(body, 0.5f, -0.25f));
        Assert.Equal(default, Effort.Of(body, -0.3f, 0.4f));
        Assert.Equal(Effort.Of(body, 0.25f, 0.5f), Effort.Of(body, 0.75f, -0.5f));
    }

    [Fact]
    public void The_steeper_the_ground_the_less_is_shown_for_legs_that_climb_have_no_room_left()
    {
        LeggedBody body = Body(1);
        float level = Effort.Of(body, 0.4f, 0f).HindDrop;
        float slope = Effort.Of(body, 0.4f, 0.2f).HindDrop;
        Assert.InRange(slope, 0.6f * level, 0.8f * level);
        Assert.InRange(Effort.Of(body, 0.4f, 0.36f).HindDrop, 0.4f * level, 0.55f * level);
        Assert.Equal(0f, Effort.Of(body, 0.4f, 1f).HindDrop);
    }

    [Fact]
    public void The_front_of_who_flies_stays_up_for_its_wings()
    {
        LeggedBody body = Body(RequestedKind.Flying, 1);
        Effort starts = Effort.Of(body, 0.4f, 0f);
        Assert.True(starts.HindDrop > 0f && starts.ForeDrop < 0f && starts.Neck == 0f && starts.Tuck == 0f);
        Assert.True(Effort.Of(body, -0.4f, 0f).ForeDrop < 0f);
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Unguligrade)]
    [InlineData(BodyPlan.Plantigrade)]
    public void Chest_and_head_come_down_in_a_start_and_the_back_rises_to_the_front_in_braking(BodyPlan plan)
    {
        Creature creature = Walkers.Of(plan, 1);
        var profile = new MotionProfile(creature);
        float run = profile.Gaits!.Speeds[^1].Comfortable;
        var animator = new CreatureAnimator(profile);
        animator.Teleport(animator.Root, FlatGround.Level);
        float leg = LeggedBody.Of(profile.Subject)!.LegLength;
        Walkers.Run(animator, 1f, 60f, default, FlatGround.Level);
        float chest = Height(JointRole.Chest);
        float head = Height(JointRole.Head);
        Walkers.Run(animator, 0.35f, 60f, new MotionInput(run), FlatGround.Level);
        Assert.InRange(chest - Height(JointRole.Chest), 0.04f * leg, 0.3f * leg);
        Assert.True(head > Height(JointRole.Head) + (0.03f * leg));
        Walkers.Run(animator, 3f, 60f, new MotionInput(run), FlatGround.Level);
        float running = Slope(run);
        Walkers.Run(animator, 0.2f, 60f, default, FlatGround.Level);
        float braking = Slope(0f);
        Assert.True(braking > running + (0.025f * leg), $"{braking} m against {running} m, leg {leg} m");

        float Slope(float speed)
        {
            const int Moments = 24;
            float sum = 0f;
            for (int i = 0; i < Moments; i++)
            {
                Walkers.Run(animator, 1f / 60f, 60f, new MotionInput(speed), FlatGround.Level);
                sum += Height(JointRole.Chest) - Height(JointRole.Pelvis);
            }

            return sum / Moments;
        }

        float Height(JointRole role) => animator.ModelPose.Positions[creature.Skeleton.FirstOf(role)].Y;
    }

    private static LeggedBody Body(ulong seed) => Body(RequestedKind.Walking, seed);

    private static LeggedBody Body(RequestedKind kind, ulong seed) => LeggedBody.Of(new MotionSubject(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind })))!;
}
