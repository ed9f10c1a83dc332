using System;
using System.Linq;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Metrics;

public sealed class MotionTrialTests
{
    [Fact]
    public void Every_movement_but_standing_is_tried_on_each_ground_at_each_rate()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
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
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        var trial = new MotionTrial(Movement.Of(profile)[1], relief, 60f);
        Assert.Equal(trial.Run(profile), trial.Run(new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking))));
    }

    [Theory]
    [InlineData(RequestedKind.Flying, "raptor", "Fly")]
    [InlineData(RequestedKind.Swimming, "fish", "Swim")]
    [InlineData(RequestedKind.Walking, "cobra", "Slither")]
    public void What_goes_on_no_feet_has_no_figures_of_feet(RequestedKind kind, string body, string name)
    {
        var profile = new MotionProfile(SpeciesSubject.Of(body, kind));
        foreach (MotionTrial trial in MotionTrial.Of(profile).Where(trial => trial.Movement.Name == name && trial.Hertz == 30f))
        {
            MotionReport report = trial.Run(profile);
            Assert.True(report.Frames > 10);
            Assert.True(report.FastestJoint > 0f && float.IsFinite(report.PoseJump));
            Assert.Equal([null, null, null, null, null], new[] { report.Slip, report.Penetration, report.Clearance, report.StanceResidual, report.Bob });
            Assert.Null(report.MinSupport);
        }
    }

    [Theory]
    [InlineData(125UL, "Crawl", 144f)]
    [InlineData(117UL, "Canter", 144f)]
    [InlineData(257UL, "Canter", 60f)]
    public void On_hills_the_body_rises_over_folded_legs_though_others_are_stretched(ulong seed, string gait, float hertz)
    {
        var profile = new MotionProfile(Walkers.Any(seed));
        Movement movement = Movement.Of(profile).First(m => m.GaitName == gait);
        MotionReport report = new MotionTrial(movement, GroundRelief.Rough, hertz).Run(profile);
        Assert.True(report.LimitViolations == 0, $"{profile.Subject.Skeleton.Joints[Math.Max(report.WorstJoint, 0)].Name} beyond its limits by {report.LimitExcess}");
    }

    [Fact]
    public void Rates_out_of_range_and_no_profile_are_refused()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        Movement walk = Movement.Of(profile)[1];
        Assert.Throws<ArgumentNullException>(() => new MotionTrial(walk, GroundRelief.Flat, 60f).Run(null!));
        Assert.Contains("Hertz", Assert.ThrowsAny<ArgumentException>(() => new MotionTrial(walk, GroundRelief.Flat, float.NaN).Run(profile)).Message, StringComparison.Ordinal);
        Assert.Contains("Hertz", Assert.ThrowsAny<ArgumentException>(() => new MotionTrial(walk, GroundRelief.Flat, 1f).Run(profile)).Message, StringComparison.Ordinal);
        Assert.ThrowsAny<ArgumentException>(() => walk.At(float.NaN));
    }

    [Theory]
    [InlineData("mantis", "Crawl", GroundRelief.Rough)]
    [InlineData("bovine", "Trot", GroundRelief.Rough, Explicit = true)]
    [InlineData("canine", "Trot", GroundRelief.Rough, Explicit = true)]
    [InlineData("hyena", "Canter", GroundRelief.Flat)]
    public void Short_trunks_folded_legs_and_stretched_legs_do_not_make_the_pose_jump(string body, string gait, GroundRelief relief)
    {
        for (ulong seed = 0; seed < 4; seed++)
        {
            var profile = new MotionProfile(SpeciesSubject.Of(body, RequestedKind.Walking, seed));
            foreach (MotionTrial trial in MotionTrial.Of(profile).Where(t => t.Movement.GaitName == gait && t.Relief == relief && t.Hertz == 144f))
            {
                MotionReport report = trial.Run(profile);
                Assert.True(report.PoseJump <= 3f, $"{body} {seed} {gait}: the pose jumps by {report.PoseJump} times its usual change");
            }
        }
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Mantises_whose_four_legs_stand_close_together_do_not_stand_on_their_heads_on_hills(int seed)
    {
        var profile = new MotionProfile(SpeciesSubject.Of("mantis", RequestedKind.Walking, (ulong)seed));
        MotionTrial trial = MotionTrial.Of(profile).Single(t => t.Movement.GaitName == "Crawl" && t.Relief == GroundRelief.Rough && t.Hertz == 144f);
        MotionReport report = trial.Run(profile);
        Assert.True(report.LimitExcess < 0.25f, $"{seed}: a joint is {report.LimitExcess} rad beyond its limits");
        Assert.True(report.PoseJump < 4f, $"{seed}: the pose jumps by {report.PoseJump} times its usual change");
    }
}
