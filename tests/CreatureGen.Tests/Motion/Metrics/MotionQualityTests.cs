using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Metrics;

public class MotionQualityTests
{
    [Theory]
    [InlineData(30f, 1000, 3)]
    [InlineData(60f, 2000, 3)]
    [InlineData(144f, 3000, 3)]
    [InlineData(30f, 1000, 100, Explicit = true)]
    [InlineData(60f, 2000, 100, Explicit = true)]
    [InlineData(144f, 3000, 100, Explicit = true)]
    public void Feet_of_any_walker_stay_where_they_stand_and_clear_the_ground_in_all_its_gaits(float rate, int firstSeed, int seeds)
    {
        int stances = 0;
        foreach ((MotionReport report, string name) in Record(firstSeed, seeds, rate, GroundRelief.Flat))
        {
            // In leg lengths.
            Assert.True(report.Slip <= 0.001f, $"{name}: slip {report.Slip}");
            Assert.True(report.LockDrift <= 0.002f, $"{name}: foot off its place by {report.LockDrift}");
            Assert.Equal(0f, report.SkatingFraction);
            Assert.True(report.MeanPenetration <= 0.001f, $"{name}: sunk {report.MeanPenetration}");
            Assert.True(report.Penetration <= 0.02f, $"{name}: sunk {report.Penetration}");
            Assert.True(report.Float <= 0.005f, $"{name}: floats {report.Float}");
            Assert.True(report.Clearance >= 0.02f, $"{name}: clearance {report.Clearance}");
            Assert.True(report.LimitViolations == 0, $"{name}: {report.LimitViolations} joints beyond their limits, by up to {report.LimitExcess} rad");
            Assert.True(report.PoseJump <= 3f, $"{name}: the pose jumps by {report.PoseJump}");
            stances++;
        }

        Assert.True(stances > 3 * seeds / 2);
    }

    [Fact(Explicit = true)]
    public void Walks_keep_feet_down_as_animals_do()
    {
        foreach ((MotionReport report, string name) in Record(5000, Thoroughness.Of(40), 60f, GroundRelief.Flat))
        {
            string gait = name.Split(' ')[1];
            int min = gait switch { "Walk" or "Crawl" or "Amble" => 2, "BipedWalk" => 1, "Wave" or "Tripod" => 3, _ => 0 };
            Assert.True(report.MinSupport >= min, $"{name}: {report.MinSupport} feet down");
        }
    }

    [Theory]
    [InlineData(30f, 7000, 3)]
    [InlineData(60f, 7100, 3)]
    [InlineData(144f, 7200, 3)]
    [InlineData(30f, 7000, 100, Explicit = true)]
    [InlineData(60f, 7100, 100, Explicit = true)]
    [InlineData(144f, 7200, 100, Explicit = true)]
    public void On_hills_feet_neither_slide_nor_sink_and_legs_keep_to_their_limits(float rate, int firstSeed, int seeds)
    {
        var sunk = new List<float>();
        var beyond = new List<string>();
        var low = new List<string>();
        foreach ((MotionReport report, string name) in Record(firstSeed, seeds, rate, GroundRelief.Rough))
        {
            Assert.True(report.Slip <= 0.01f, $"{name}: slip {report.Slip}");
            Assert.True(report.PoseJump <= 3f, $"{name}: the pose jumps by {report.PoseJump}");
            Assert.True((report.StanceResidual ?? 0f) <= 0.04f, $"{name}: short by {report.StanceResidual}");
            if (report.StanceResidual > 0.03f)
            {
                beyond.Add($"{name} short by {report.StanceResidual}");
            }

            sunk.Add(report.MeanPenetration ?? 0f);
            if (report.LimitViolations > 0)
            {
                beyond.Add($"{name} by {report.LimitExcess}");
            }

            if (report.Clearance < 0.02f)
            {
                low.Add($"{name} at {report.Clearance}");
            }
        }

        // Frogs' forelegs between a hill and a hollow, toes longer than half the leg, and legs of sprawlers whose feet stay as they were set down.
        Assert.True(beyond.Count <= sunk.Count / 50, string.Join(", ", beyond));
        Assert.True(low.Count <= Math.Max(1, sunk.Count / 100), string.Join(", ", low));
        sunk.Sort();
        Assert.True(sunk[sunk.Count / 2] < 0.002f, $"median {sunk[sunk.Count / 2]}");
    }

    [Theory]
    [InlineData(RequestedKind.Flying, 30f, 1000, 3)]
    [InlineData(RequestedKind.Flying, 60f, 2000, 3)]
    [InlineData(RequestedKind.Flying, 144f, 3000, 3)]
    [InlineData(RequestedKind.Swimming, 30f, 1000, 3)]
    [InlineData(RequestedKind.Swimming, 60f, 2000, 3)]
    [InlineData(RequestedKind.Swimming, 144f, 3000, 3)]
    [InlineData(RequestedKind.Flying, 30f, 1000, 100, Explicit = true)]
    [InlineData(RequestedKind.Flying, 60f, 2000, 100, Explicit = true)]
    [InlineData(RequestedKind.Flying, 144f, 3000, 100, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 30f, 1000, 100, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 60f, 2000, 100, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 144f, 3000, 100, Explicit = true)]
    public void No_joint_of_a_flier_or_swimmer_goes_beyond_its_limits(RequestedKind kind, float rate, int firstSeed, int seeds)
    {
        for (int seed = firstSeed; seed < firstSeed + seeds; seed++)
        {
            var profile = new MotionProfile(CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = kind, Strangeness = 0 }));
            foreach (MotionTrial trial in MotionTrial.Of(profile).Where(trial => trial.Hertz == rate && trial.Relief == GroundRelief.Flat && trial.Movement.Gait == null))
            {
                MotionReport report = trial.Run(profile);
                Assert.True(report.LimitViolations == 0, $"{kind} {seed} {trial.Movement.GaitName}: {profile.Subject.Skeleton.Joints[Math.Max(report.WorstJoint, 0)].Name} beyond its limits by up to {report.LimitExcess} rad");
            }
        }
    }

    private static IEnumerable<(MotionReport Report, string Name)> Record(int firstSeed, int seeds, float rate, GroundRelief relief)
    {
        for (int seed = firstSeed; seed < firstSeed + seeds; seed++)
        {
            Creature creature = Walkers.Any((ulong)seed);
            var profile = new MotionProfile(creature);
            if (profile.Gaits == null)
            {
                continue;
            }

            foreach (MotionTrial trial in MotionTrial.Of(profile).Where(trial => trial.Hertz == rate && trial.Relief == relief))
            {
                yield return (trial.Run(profile), $"{seed} {trial.Movement.GaitName} {creature.Blueprint.Plan}");
            }
        }
    }
}
