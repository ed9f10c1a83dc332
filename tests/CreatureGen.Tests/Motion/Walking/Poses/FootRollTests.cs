using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Poses;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Poses;

public sealed class FootRollTests
{
    [Fact]
    public void Toes_of_a_flat_foot_leave_the_ground_without_a_jerk()
    {
        const float Step = 0.002f;
        float rate = 0f;
        for (float pitch = 0f; pitch < 1.3f; pitch += Step)
        {
            float next = (FootRoll.ToePitch(pitch + Step) - FootRoll.ToePitch(pitch)) / Step;
            Assert.InRange(next - rate, -0.005f, 0.005f);
            rate = next;
        }

        Assert.Equal(0.8f, rate, 0.001f);
        Assert.Equal(0f, FootRoll.ToePitch(0.3f));
    }

    [Fact]
    public void A_foot_has_rolled_down_in_the_update_in_which_it_comes_down_and_in_no_other()
    {
        LegRig leg = new MotionProfile(StrokeSubject.Of(BodyPlan.Plantigrade)[0]).Legs!.Legs[0];
        var gait = new GaitNumbers(Duty: 0.65f, Lift: 1f, ForceDip: 0f, Activity: 1f, Roll: 0.5f, Cycle: 0.8f, Swing: 0.28f, Step: 0.01f);
        Assert.NotEqual(0f, leg.Traits.Strike);
        var home = new Foothold { Position = leg.Home, Heading = Quaternion.Identity, Normal = Vector3.UnitY };
        var foot = new Foot { Plan = new FootPlan { Phase = FootPhase.Stance, Stance = 0.5f, From = home, To = home } };
        Assert.Equal(0f, RolledDown());
        foot.Plan.Phase = FootPhase.Swing;
        foot.Plan.Swing = 0.9f;
        Assert.Equal(0f, RolledDown());
        foot.Plan.Phase = FootPhase.Stance;
        Assert.Equal(-0.5f * leg.Traits.Strike, RolledDown(), 1e-6f);
        Assert.Equal(0f, RolledDown());

        float RolledDown()
        {
            FootPoser.Pose(leg, ref foot, new SwingClearance(), RootPlace.Identity, gait, 0f, out _);
            return foot.Path.RolledDown;
        }
    }

    [Theory]
    [InlineData(0.1f)]
    [InlineData(0.5f)]
    [InlineData(1f)]
    public void A_foot_that_steps_takes_on_its_load_from_none_and_gives_all_of_it_up_however_slowly_it_goes(float activity)
    {
        LegRig leg = new MotionProfile(StrokeSubject.Of(BodyPlan.Unguligrade)[0]).Legs!.Legs[0];
        var gait = new GaitNumbers(Duty: 0.65f, Lift: 1f, ForceDip: 0.2f, activity, Roll: 1f, Cycle: 0.8f, Swing: 0.28f, Step: 0.01f);
        float LoadAt(float stance) => FootRoll.At(new Foot { Plan = new FootPlan { Phase = FootPhase.Stance, Stance = stance } }, leg, gait).Load;
        Assert.Equal(0f, LoadAt(0f), 1e-4f);
        Assert.Equal(0f, LoadAt(1f), 1e-4f);
        Assert.True(LoadAt(0.5f) > 0.5f);
    }

    [Theory]
    [InlineData(BodyPlan.Plantigrade)]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Unguligrade)]
    public void A_heel_begins_to_rise_earlier_the_shorter_the_stance_and_is_up_as_it_ends(BodyPlan plan)
    {
        foreach (LegRig leg in new MotionProfile(StrokeSubject.Of(plan)[0]).Legs!.Legs)
        {
            float first = 1f;
            float last = 0f;
            foreach (float duty in new[] { 0.35f, 0.45f, 0.55f, 0.65f, 0.8f })
            {
                float begins = 0.2f;
                while (FootRoll.Pitch(Standing(begins), leg, duty, 1f, 1f - duty) <= 0f)
                {
                    begins += 0.005f;
                }

                Assert.True(begins >= last, $"duty {duty}: {begins} after {last}");
                Assert.InRange(begins, 0.495f, 0.63f);
                Assert.Equal(leg.Traits.ToeOff * leg.RollFraction, FootRoll.Pitch(Standing(1f), leg, duty, 1f, 1f - duty), 1e-5f);
                first = Math.Min(first, begins);
                last = begins;
            }

            Assert.True(first < last - 0.03f, $"{first} to {last}");
        }
    }

    /// <summary>Short swings whirled feet level before they came down: their ankles were 74 rad/s fast.</summary>
    [Theory]
    [InlineData(BodyPlan.Plantigrade)]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Unguligrade)]
    public void A_foot_is_pitched_less_in_short_swings_so_that_it_turns_level_no_faster_than_it_rolls_and_as_it_is_built_in_long_ones(BodyPlan plan)
    {
        const float Step = 0.01f;
        foreach (LegRig leg in new MotionProfile(StrokeSubject.Of(plan)[0]).Legs!.Legs)
        {
            foreach (float swing in new[] { 0.06f, 0.08f, 0.12f, 0.3f })
            {
                float PitchAt(float progress) => FootRoll.Pitch(new Foot { Plan = new FootPlan { Phase = FootPhase.Swing, Swing = progress } }, leg, 0.6f, 2.5f * swing, swing);
                for (float progress = 0.3f; progress < 0.99f; progress += Step)
                {
                    Assert.InRange(Math.Abs(PitchAt(progress + Step) - PitchAt(progress)) / (Step * swing), 0f, 20.1f);
                }

                Assert.True(swing < 0.3f || Math.Abs(PitchAt(0.3f) - (leg.Traits.SwingPitch * leg.RollFraction)) < 1e-4f);
            }
        }
    }

    private static Foot Standing(float progress) => new() { Plan = new FootPlan { Phase = FootPhase.Stance, Stance = progress } };
}
