using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Gaits;

public class GaitTests
{
    [Fact]
    public void Waves_of_half_duty_on_six_legs_are_tripods()
    {
        var wave = new WavePhases(WaveDirection.Forward);
        float[] left = Enumerable.Range(0, 3).Select(row => wave.Lag(row, 3, Side.Left, 0.5f) % 1f).ToArray();
        float[] right = Enumerable.Range(0, 3).Select(row => wave.Lag(row, 3, Side.Right, 0.5f) % 1f).ToArray();
        Assert.Equal(new[] { 0f, 0.5f, 0f }, left);
        Assert.Equal(new[] { 0.5f, 0f, 0.5f }, right);
    }

    [Fact]
    public void Every_gait_of_the_library_is_sound()
    {
        foreach (System.Reflection.PropertyInfo property in typeof(GaitLibrary).GetProperties())
        {
            ((Gait)property.GetValue(null)!).ThrowIfInvalid();
        }
    }

    [Fact]
    public void Gaits_change_with_hysteresis()
    {
        GaitSet set = Dog();
        Assert.Equal(0, set.Choose(0, 0.30f));
        Assert.Equal(1, set.Choose(0, 0.40f));
        Assert.Equal(1, set.Choose(1, 0.30f));
        Assert.Equal(0, set.Choose(1, 0.20f));
    }

    [Fact]
    public void A_horse_goes_over_to_a_trot_at_the_speed_of_horses()
    {
        // Griffin et al. 2004: 1.6 to 2.3 m/s at hip heights of 0.7 to 1.4 m.
        var set = new GaitSet(new[] { new GaitStep(GaitLibrary.Walk, 0f, 0f), new GaitStep(GaitLibrary.Trot, 0.35f, 0.25f) }, 1.05f, 250f);
        Assert.InRange(set.Speeds[0].Fastest, 1.6f, 2.3f);
    }

    [Fact]
    public void Speeds_rise_from_gait_to_gait()
    {
        GaitSet set = Dog();
        for (int i = 1; i < set.Speeds.Count; i++)
        {
            Assert.True(set.Speeds[i].Slowest < set.Speeds[i - 1].Fastest);
            Assert.True(set.Speeds[i].Comfortable > set.Speeds[i - 1].Comfortable);
        }

        Assert.Equal(set.Speeds[set.Speeds.Count - 1].Fastest, set.TopSpeed);
    }

    [Fact]
    public void A_gait_that_makes_no_sense_is_refused_by_name()
    {
        Gait bad = GaitLibrary.Trot with { Lift = float.NaN };
        Assert.Contains("Lift", Assert.ThrowsAny<ArgumentException>(() => bad.ThrowIfInvalid()).Message);
        Assert.ThrowsAny<ArgumentException>(() => new ListedPhases(0f, 0.5f, 0.2f));
        Assert.ThrowsAny<ArgumentException>(() => new GaitSet(Array.Empty<GaitStep>(), 1f, 10f));
    }

    [Fact]
    public void Any_number_of_legs_can_walk_by_rule()
    {
        for (ulong seed = 1; seed <= 6; seed++)
        {
            var animator = new CreatureAnimator(Walkers.Of(BodyPlan.ManyLegged, seed));
            Assert.True(animator.FootCount >= 6);
            Walkers.Run(animator, 2f, 60f, new MotionInput(animator.Profile.Gaits!.Speeds[0].Comfortable), FlatGround.Level);
            Assert.InRange(Enumerable.Range(0, animator.FootCount).Count(i => animator.Foot(i).Phase == FootPhase.Stance), animator.FootCount / 2, animator.FootCount);
        }
    }

    [Fact]
    public void Of_more_than_two_pairs_those_between_come_down_evenly_between_the_rearmost_and_the_foremost()
    {
        var phases = new SpreadPhases(0.1f, 0f, 0.7f, 0.4f);
        Assert.Equal(0.1f, phases.Lag(0, 4, Side.Left, 0.5f));
        Assert.Equal(0.3f, phases.Lag(1, 4, Side.Left, 0.5f), 1e-6f);
        Assert.Equal(0.5f, phases.Lag(2, 4, Side.Left, 0.5f), 1e-6f);
        Assert.Equal(0.4f, phases.Lag(3, 4, Side.Right, 0.5f));
        Assert.Equal(0f, phases.Lag(0, 1, Side.Right, 0.5f));
        Assert.Contains("frontLeft", Assert.ThrowsAny<ArgumentException>(() => new SpreadPhases(0f, 0f, float.NaN, 0f)).Message);
    }

    [Fact(Explicit = true)]
    public void Mammals_and_winged_beasts_on_six_and_eight_legs_trot_and_the_lightest_footed_gallop()
    {
        var profiles = new List<MotionProfile>();
        foreach (RequestedKind kind in new[] { RequestedKind.Walking, RequestedKind.Flying })
        {
            for (ulong seed = 1; seed <= 40; seed++)
            {
                var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind, MinLegPairs = 3, MaxLegPairs = 4 }));
                if (profile.Legs is { Sprawls: false, Rows: > 2 })
                {
                    profiles.Add(profile);
                }
            }
        }

        Assert.True(profiles.Count > 30);
        Assert.True(profiles.Count(profile => profile.Gaits!.Speeds.Count > 1) > 0.6 * profiles.Count, "too many only walk");
        Assert.Contains(profiles, profile => profile.Gaits!.Speeds.Any(speed => speed.Gait == GaitLibrary.TransverseGallop || speed.Gait == GaitLibrary.RotaryGallop));
        Assert.All(profiles, profile => Assert.All(profile.Gaits!.Speeds, speed => Assert.True(speed.Gait.MaxRows >= profile.Legs!.Rows, speed.Gait.Name)));
    }

    [Fact]
    public void A_gait_is_entered_where_the_one_before_it_ends_unless_it_would_be_a_shuffle()
    {
        for (ulong seed = 1; seed <= 60; seed++)
        {
            var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
            for (int i = 1; i < (profile.Gaits?.Steps.Count ?? 0); i++)
            {
                float fastest = profile.Gaits!.Speeds[i - 1].Fastest;
                float reached = fastest * fastest / (MotionSettings.Default.Gravity * profile.LegLength);
                GaitStep step = profile.Gaits.Steps[i];
                Assert.InRange(step.Enter, 0f, Math.Max(reached, 0.25f * step.Gait.Comfortable) * 1.001f);
                Assert.InRange(step.Leave, 0f, 0.9f * step.Enter);
            }
        }
    }

    private static GaitSet Dog() => new MotionProfile(Walkers.Of(BodyPlan.Digitigrade, 5)).Gaits!;

    [Theory]
    [InlineData(2, 0.3f)]
    [InlineData(3, 0.42f)]
    public void In_a_leap_the_hind_pair_pushes_together_and_the_others_catch_together_after_a_flight(int rows, float duty)
    {
        LegPhases phases = GaitLibrary.Leap.Phases;
        float caught = phases.Lag(rows - 1, rows, Side.Left, duty);
        Assert.Equal(0f, phases.Lag(0, rows, Side.Left, duty));
        for (int row = 0; row < rows; row++)
        {
            Assert.Equal(phases.Lag(row, rows, Side.Left, duty), phases.Lag(row, rows, Side.Right, duty));
            Assert.Equal(row == 0 ? 0f : caught, phases.Lag(row, rows, Side.Left, duty));
        }

        Assert.True(caught > duty + 0.2f, "no flight between push and catch");
        Assert.True(caught + duty > 1f, "the catching legs leave before the hind legs are down");
    }
}
