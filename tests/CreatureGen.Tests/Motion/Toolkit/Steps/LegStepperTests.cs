using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Tests.Motion;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Steps;

public sealed class LegStepperTests
{
    private static readonly Vector3[] places = [new(0.3f, 0f, 0.5f), new(-0.3f, 0f, 0.5f), new(0.3f, 0f, -0.5f), new(-0.3f, 0f, -0.5f)];
    private static readonly int[] diagonals = [0, 1, 1, 0];
    private static readonly LegStepSettings settings = new(0.2f, 0.15f);

    [Theory]
    [InlineData(30)]
    [InlineData(144)]
    public void Diagonal_feet_follow_a_body_by_turns_and_none_slides(int rate)
    {
        SteppingFoot[] feet = Array.ConvertAll(places, p => new SteppingFoot(p));
        int turn = -1;
        int[] steps = new int[4];
        float farthest = 0f;
        for (int i = 1; i <= 6 * rate; i++)
        {
            SteppingFoot[] before = (SteppingFoot[])feet.Clone();
            Vector3 body = new(0f, 0f, 0.8f * i / rate);
            Vector3[] homes = Array.ConvertAll(places, p => p + body);
            LegStepper.Update(feet, diagonals, homes, settings, FlatGround.Level, Vector3.UnitY, 1f / rate, ref turn);
            Assert.Single(feet.Select((f, k) => f.IsStepping ? diagonals[k] : turn).Distinct());
            for (int k = 0; k < 4; k++)
            {
                steps[k] += feet[k].IsStepping && !before[k].IsStepping ? 1 : 0;
                Assert.True(feet[k].IsStepping || before[k].IsStepping || feet[k].Position == before[k].Position);
                Assert.True(feet[k].IsStepping || feet[k].Position.Y == 0f);
                farthest = Math.Max(farthest, Vec.Distance(feet[k].Position, homes[k]));
            }
        }

        Assert.InRange(farthest, settings.Distance, 2.5f * settings.Distance);
        Assert.All(steps, n => Assert.InRange(n, steps.Min(), steps.Min() + 1));
        Assert.True(steps.Min() > 8);
    }

    [Fact]
    public void A_step_ends_beyond_its_home_and_is_highest_in_its_middle()
    {
        SteppingFoot[] feet = [new(Vector3.Zero)];
        int turn = -1;
        Vector3[] homes = [new(0f, 0f, 1f)];
        LegStepper.Update(feet, [0], homes, new LegStepSettings(0.5f, 1f, overshoot: 0.4f, lift: 0.3f), FlatGround.Level, Vector3.UnitY, 0f, ref turn);
        Assert.Equal(new Vector3(0f, 0f, 1.2f), feet[0].To);
        LegStepper.Update(feet, [0], homes, new LegStepSettings(0.5f, 1f, overshoot: 0.4f, lift: 0.3f), FlatGround.Level, Vector3.UnitY, 0.5f, ref turn);
        Assert.True(Vec.Distance(new Vector3(0f, 0.36f, 0.6f), feet[0].Position) < 1e-5f);
        LegStepper.Update(feet, [0], homes, new LegStepSettings(0.5f, 1f, overshoot: 0.4f, lift: 0.3f), FlatGround.Level, Vector3.UnitY, 0.6f, ref turn);
        Assert.Equal(feet[0].To, feet[0].Position);
        Assert.False(feet[0].IsStepping);
    }

    /// <summary>Or the feet that lag most would step again and again, and the others be dragged along.</summary>
    [Fact]
    public void After_one_group_it_is_anothers_turn_however_far_the_first_is_behind()
    {
        SteppingFoot[] feet = [new(Vector3.Zero), new(Vector3.Zero), new(Vector3.Zero)];
        int turn = 0;
        LegStepper.Update(feet, [0, 1, 2], [new Vector3(0f, 0f, 2f), new Vector3(0f, 0f, 0.5f), new Vector3(0f, 0f, 0.6f)], settings, FlatGround.Level, Vector3.UnitY, 0.01f, ref turn);
        Assert.Equal(2, turn);
        Assert.Equal([false, false, true], feet.Select(f => f.IsStepping));
    }

    [Fact]
    public void A_foot_near_its_home_rests_and_one_without_ground_does_not_step()
    {
        SteppingFoot[] feet = [new(Vector3.Zero)];
        int turn = -1;
        LegStepper.Update(feet, [0], [new Vector3(0.19f, 0f, 0f)], settings, FlatGround.Level, Vector3.UnitY, 0.1f, ref turn);
        Assert.False(feet[0].IsStepping);
        LegStepper.Update(feet, [0], [new Vector3(0.3f, 50f, 0f)], settings, FlatGround.Level, Vector3.UnitY, 0.1f, ref turn);
        Assert.False(feet[0].IsStepping);
    }

    [Theory]
    [InlineData(30, 0.6f)]
    [InlineData(144, 0.6f)]
    [InlineData(60, 0.4f)]
    public void In_a_gait_feet_come_down_when_their_phases_say_stand_still_and_are_under_their_homes_in_mid_stance(int rate, float duty)
    {
        var gait = new StepGait(duty, 0.8f);
        float[] lags = [0f, 0.5f, 0.5f, 0f];
        Vector3 velocity = new(0.1f, 0f, 0.9f);
        SteppingFoot[] feet = Array.ConvertAll(places, p => new SteppingFoot(p));
        var least = new LegStepSettings(0.01f, 1f);
        for (int i = 1; i <= 5 * rate; i++)
        {
            float time = i / (float)rate;
            SteppingFoot[] before = (SteppingFoot[])feet.Clone();
            Vector3[] homes = Array.ConvertAll(places, p => p + (velocity * time));
            LegStepper.UpdateInGait(feet, lags, time / gait.Seconds, gait, homes, velocity, least, FlatGround.Level, Vector3.UnitY);
            for (int k = 0; k < 4 && time > 2f * gait.Seconds; k++)
            {
                float place = ((time / gait.Seconds) - lags[k]) % 1f;
                Assert.Equal(place >= duty, feet[k].IsStepping);
                Assert.True(feet[k].IsStepping || before[k].IsStepping || feet[k].Position == before[k].Position);

                // Where it stands is ahead of its home by what the body has still to go until the middle of its stance.
                Assert.True(feet[k].IsStepping || Vec.Distance(feet[k].Position, homes[k] + (velocity * (((0.5f * duty) - place) * gait.Seconds))) < 0.01f);
            }
        }
    }

    [Fact]
    public void In_a_gait_feet_of_a_body_that_stands_stay_down_and_what_does_not_fit_is_refused()
    {
        SteppingFoot[] feet = Array.ConvertAll(places, p => new SteppingFoot(p));
        var gait = new StepGait(0.6f, 0.8f);
        for (int i = 0; i < 60; i++)
        {
            LegStepper.UpdateInGait(feet, [0f, 0.5f, 0.5f, 0f], i / 48f, gait, places, Vector3.Zero, settings, FlatGround.Level, Vector3.UnitY);
        }

        Assert.Equal(places, feet.Select(foot => foot.Position));
        float[] lags = [0f, 0.5f, 0.5f, 0f];
        Assert.Equal(0, MovingPose.Allocated(() => LegStepper.UpdateInGait(feet, lags, 0.7f, gait, places, Vector3.UnitZ, settings, FlatGround.Level, Vector3.UnitY)));
        Assert.Contains("1 lags and 4 homes", Assert.Throws<ArgumentException>(() => LegStepper.UpdateInGait(feet, [0f], 0f, gait, places, Vector3.Zero, settings, FlatGround.Level, Vector3.UnitY)).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => LegStepper.UpdateInGait(feet, lags, 0f, default, places, Vector3.Zero, settings, FlatGround.Level, Vector3.UnitY));
        Assert.Throws<ArgumentException>(() => LegStepper.UpdateInGait(feet, lags, float.NaN, gait, places, Vector3.Zero, settings, FlatGround.Level, Vector3.UnitY));
        Assert.Throws<ArgumentOutOfRangeException>(() => new StepGait(1f, 1f));
        Assert.Throws<ArgumentOutOfRangeException>(() => new StepGait(0.5f, 0f));
    }

    [Fact]
    public void Stepping_allocates_nothing_and_refuses_what_does_not_fit()
    {
        SteppingFoot[] feet = Array.ConvertAll(places, p => new SteppingFoot(p));
        int turn = -1;
        Assert.Equal(0, MovingPose.Allocated(() => LegStepper.Update(feet, diagonals, places, settings, FlatGround.Level, Vector3.UnitY, 0.01f, ref turn)));
        Assert.Contains("expected one of each for 4 feet", Assert.Throws<ArgumentException>(() => LegStepper.Update(feet, [0], places, settings, FlatGround.Level, Vector3.UnitY, 0.01f, ref turn)).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => LegStepper.Update(feet, diagonals, places, default, FlatGround.Level, Vector3.UnitY, 0.01f, ref turn));
        Assert.Throws<ArgumentOutOfRangeException>(() => new LegStepSettings(0f, 1f));
        Assert.Throws<ArgumentOutOfRangeException>(() => new LegStepSettings(1f, float.NaN));
    }
}
