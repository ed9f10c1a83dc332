using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Pace;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Pace;

public sealed class GaitClockTests
{
    private const float Gravity = 9.81f;

    /// <summary>Creatures of broad and of narrow build turn on the spot in steps of one size, or in smaller ones where a leg does not reach so far.</summary>
    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Upright)]
    [InlineData(BodyPlan.Sprawling)]
    public void A_cycle_on_the_spot_turns_the_body_by_no_more_than_26_degrees(BodyPlan plan)
    {
        foreach (LeggedBody body in Bodies(plan))
        {
            foreach (float turn in new[] { 0.1f, 0.4f, -0.9f })
            {
                var clock = new GaitClock(body, GaitLibrary.Walk);
                clock.Slide(0.01f, RootVelocity.At(0f, 0f, turn), Gravity, 0f, 0f);
                Assert.True(clock.Frequency >= System.Math.Abs(turn) / 0.45f - 1e-4f, $"{clock.Frequency} cycles per second at {turn} rad/s");
            }
        }
    }

    /// <summary>What was left of the faster gait all but stopped the clock of who braked hard: a foot in the air waited, and its place was predicted metres away.</summary>
    [Theory]
    [InlineData(BodyPlan.Unguligrade)]
    [InlineData(BodyPlan.Theropod)]
    public void Who_brakes_hard_into_another_gait_steps_on_as_its_speed_goes_through_nothing(BodyPlan plan)
    {
        foreach (LeggedBody body in Bodies(plan))
        {
            RootVelocity velocity = RootVelocity.At(0f, 0f, 0f);
            velocity.Ask(0f, 0f, 1f);
            GaitClock clock = Going(body, GaitLibrary.TransverseGallop, (float)System.Math.Sqrt(6f * Gravity * body.LegLength), 0f, 0f);
            clock.Change(GaitLibrary.Walk, Gravity, Lead.Left);
            clock.Slide(0.002f, velocity, Gravity, 1f, 0f);
            Assert.True(clock.Cycle < 13f * System.Math.Sqrt(body.LegLength / Gravity), $"{clock.Cycle} s on legs of {body.LegLength} m");
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Plantigrade)]
    public void Steps_are_shorter_down_steep_slopes_than_on_level_ground(BodyPlan plan)
    {
        foreach (LeggedBody body in Bodies(plan))
        {
            float speed = 1.2f * (float)System.Math.Sqrt(Gravity * body.LegLength);
            Assert.InRange(Going(body, GaitLibrary.Trot, speed, 0f, 0f).Length, 0.99f, 1f);
            Assert.InRange(Going(body, GaitLibrary.Trot, speed, 0f, -0.4f).Length, 0.2f, 0.9f);
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Theropod)]
    public void Up_and_down_stairs_nobody_is_quicker_than_who_runs_up_them_with_all_his_might(BodyPlan plan)
    {
        foreach (LeggedBody body in Bodies(plan))
        {
            float unit = (float)System.Math.Sqrt(Gravity * body.LegLength);
            foreach (float slope in new[] { 0.36f, -0.36f })
            {
                float speed = Going(body, GaitLibrary.Trot, unit, 0f, slope).OnSlope(3f * unit, Gravity);
                Assert.InRange(System.Math.Abs(slope) * speed / unit, 0.05f, 0.601f);
            }

            Assert.Equal(3f * unit, Going(body, GaitLibrary.Trot, unit, 0f, 0f).OnSlope(3f * unit, Gravity));
        }
    }

    /// <summary>One of 242 kg trotted down stairs at 7.4 steps a second: the trot's rate on the level at a speed at which it gallops there was held for quick enough.</summary>
    [Theory]
    [InlineData(BodyPlan.Hexapod)]
    [InlineData(BodyPlan.Unguligrade)]
    public void Whoever_is_asked_to_hurry_down_stairs_goes_so_slowly_that_its_steps_are_no_quicker_than_its_mass_lets_them(BodyPlan plan)
    {
        foreach (LeggedBody body in Bodies(plan))
        {
            float unit = Gravity * body.LegLength;
            GaitClock clock = Going(body, GaitLibrary.Trot, 0.5f * (float)System.Math.Sqrt(unit), 0f, -0.36f);
            float speed = clock.OnSlope(2f * (float)System.Math.Sqrt(unit), Gravity);
            float level = Going(body, GaitLibrary.Trot, speed, 0f, 0f).FrequencyOf(GaitLibrary.Trot, speed * speed / unit, Gravity);
            Assert.True(clock.FrequencyOf(GaitLibrary.Trot, speed * speed / unit, Gravity) <= 1.05f * System.Math.Max(level, GaitSet.QuickestOf(body.Mass)), $"{clock.FrequencyOf(GaitLibrary.Trot, speed * speed / unit, Gravity)} at {speed} m/s");
        }
    }

    /// <summary>Feet roll and fold less in short steps: they would do so from one update to the next.</summary>
    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Upright)]
    public void Where_a_gait_changes_in_a_turn_steps_come_to_their_length_little_by_little(BodyPlan plan)
    {
        const float Step = 1f / 480f;
        foreach (LeggedBody body in Bodies(plan))
        {
            float speed = 0.3f * (float)System.Math.Sqrt(Gravity * body.LegLength);
            GaitClock clock = Going(body, GaitLibrary.Walk, speed, 2.5f, 0f);
            clock.Change(GaitLibrary.Trot, Gravity, Lead.Left);
            RootVelocity velocity = RootVelocity.At(2f * speed, 0f, 2.5f);
            for (int i = 0; i < 480; i++)
            {
                float before = clock.Length;
                clock.Slide(Step, velocity, Gravity, 1f, 0f);
                Assert.InRange(System.Math.Abs(clock.Length - before), 0f, 10f * Step);
            }
        }
    }

    /// <summary>Steps are those of the speed that the body will have, and what differs between two gaits was that of the speed that it has: the clock of who sped up into another gait jumped. Bounce and sway go by the square of the tempo, and feet pitch by it: a ball turned at 67 rad/s.</summary>
    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Unguligrade)]
    public void Where_who_speeds_up_changes_its_gait_its_steps_take_another_tempo_little_by_little(BodyPlan plan)
    {
        const float Step = 1f / 480f;
        foreach (LeggedBody body in Bodies(plan))
        {
            float unit = (float)System.Math.Sqrt(Gravity * body.LegLength);
            RootVelocity velocity = RootVelocity.At(0.8f * unit, 0f, 0f);
            velocity.Bounds = VelocityBounds.Of(body, MotionSettings.Default);
            velocity.Ask(3f * unit, 0f, 0f);
            var clock = new GaitClock(body, GaitLibrary.Trot);
            clock.Slide(0f, velocity, Gravity, 1f, 0f);
            Assert.True(velocity.SpeedAfter(0.25f) > 0.9f * unit, "it does not speed up");
            clock.Change(GaitLibrary.Canter, Gravity, Lead.Left);
            for (int i = 0; i < 24; i++)
            {
                float before = clock.Frequency;
                velocity.Advance(Step, out _);
                clock.Slide(Step, velocity, Gravity, 1f, 0f);
                Assert.InRange(System.Math.Abs(clock.Frequency - before), 0f, 0.02f * before);
            }
        }
    }

    private static GaitClock Going(LeggedBody body, Gait gait, float speed, float turn, float rise)
    {
        var clock = new GaitClock(body, gait);
        for (int i = 0; i < 200; i++)
        {
            clock.Slide(0.01f, RootVelocity.At(speed, 0f, turn), Gravity, 1f, rise);
        }

        return clock;
    }

    private static IEnumerable<LeggedBody> Bodies(BodyPlan plan) => StrokeSubject.Of(plan).Select(creature => LeggedBody.Of(new MotionSubject(creature))!);
}
