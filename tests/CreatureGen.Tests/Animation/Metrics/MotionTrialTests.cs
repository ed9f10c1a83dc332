using System;
using System.Linq;
using CreatureGen.Animation;
using CreatureGen.Animation.Grounds;
using CreatureGen.Animation.Metrics;
using CreatureGen.Creatures;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Animation.Metrics;

public sealed class MotionTrialTests
{
    [Fact]
    public void Every_movement_but_standing_is_tried_on_each_ground_at_each_rate()
    {
        var profile = new MotionProfile(Walkers.Any(22));
        MotionTrial[] trials = MotionTrial.Of(profile).ToArray();
        Assert.Equal(6 * profile.Gaits!.Speeds.Count, trials.Length);
        Assert.Equal(trials.Length, trials.Select(trial => (trial.Movement.Name, trial.Relief, trial.Hertz)).Distinct().Count());
        Assert.DoesNotContain(trials, trial => trial.Movement.Name == "Idle");
    }

    [Theory]
    [InlineData(GroundRelief.Flat)]
    [InlineData(GroundRelief.Rough)]
    public void A_trial_gives_the_same_figures_whenever_it_is_run(GroundRelief relief)
    {
        var profile = new MotionProfile(Walkers.Any(22));
        var trial = new MotionTrial(Movement.Of(profile)[1], relief, 60f);
        Assert.Equal(trial.Run(profile), trial.Run(new MotionProfile(Walkers.Any(22))));
    }

    [Theory]
    [InlineData(RequestedKind.Flying, 1, "Fly")]
    [InlineData(RequestedKind.Swimming, 4, "Swim")]
    [InlineData(RequestedKind.Walking, 7, "Slither")]
    public void What_goes_on_no_feet_has_no_figures_of_feet(RequestedKind kind, ulong seed, string name)
    {
        var profile = new MotionProfile(Of(kind, seed));
        foreach (MotionTrial trial in MotionTrial.Of(profile).Where(trial => trial.Movement.Name == name && trial.Hertz == 30f))
        {
            MotionReport report = trial.Run(profile);
            Assert.True(report.Frames > 10);
            Assert.True(report.FastestJoint > 0f && float.IsFinite(report.PoseJump));
            Assert.Equal([null, null, null, null, null], new[] { report.Slip, report.Penetration, report.Clearance, report.StanceResidual, report.Bob });
            Assert.Null(report.LeastSupport);
        }
    }

    [Fact]
    public void Rates_out_of_range_and_no_profile_are_refused()
    {
        var profile = new MotionProfile(Walkers.Any(22));
        Movement walk = Movement.Of(profile)[1];
        Assert.Throws<ArgumentNullException>(() => new MotionTrial(walk, GroundRelief.Flat, 60f).Run(null!));
        Assert.Contains("Hertz", Assert.ThrowsAny<ArgumentException>(() => new MotionTrial(walk, GroundRelief.Flat, float.NaN).Run(profile)).Message, StringComparison.Ordinal);
        Assert.Contains("Hertz", Assert.ThrowsAny<ArgumentException>(() => new MotionTrial(walk, GroundRelief.Flat, 1f).Run(profile)).Message, StringComparison.Ordinal);
        Assert.ThrowsAny<ArgumentException>(() => walk.At(float.NaN));
    }

    private static Creature Of(RequestedKind kind, ulong seed) => CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });

    [Theory]
    [InlineData(287, "Crawl", GroundRelief.Rough)]
    [InlineData(143, "Trot", GroundRelief.Rough)]
    [InlineData(222, "Trot", GroundRelief.Rough)]
    [InlineData(37, "Canter", GroundRelief.Flat)]
    public void Short_trunks_folded_legs_and_stretched_legs_do_not_make_the_pose_jump(int seed, string gait, GroundRelief relief)
    {
        var profile = new MotionProfile(Walkers.Any((ulong)seed));
        MotionTrial trial = MotionTrial.Of(profile).Single(t => t.Movement.GaitName == gait && t.Relief == relief && t.Hertz == 144f);
        MotionReport report = trial.Run(profile);
        Assert.True(report.PoseJump <= 3f, $"{seed} {gait}: the pose jumps by {report.PoseJump} times its usual change");
    }

    [Theory]
    [InlineData(105)]
    [InlineData(245)]
    [InlineData(287)]
    public void Mantises_whose_four_legs_stand_close_together_do_not_stand_on_their_heads_on_hills(int seed)
    {
        var profile = new MotionProfile(Walkers.Any((ulong)seed));
        MotionTrial trial = MotionTrial.Of(profile).Single(t => t.Movement.GaitName == "Crawl" && t.Relief == GroundRelief.Rough && t.Hertz == 144f);
        MotionReport report = trial.Run(profile);
        Assert.True(report.LimitExcess < 0.2f, $"{seed}: a joint is {report.LimitExcess} rad beyond its limits");
        Assert.True(report.PoseJump < 4f, $"{seed}: the pose jumps by {report.PoseJump} times its usual change");
    }
}
