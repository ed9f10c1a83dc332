using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Events;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Motion;
using Xunit;

namespace CreatureGen.Tests.Events;

public sealed class AngularEventDetectorTests
{
    private static readonly Skeleton arm = MovingPose.Chain(2, 1f, JointLimit.Free);

    private static AngularRule Rule => new("swing") { Joints = ["J1"], ThresholdPower = 3 };

    /// <summary>A quaternion and its negative are one rotation, and an angle and the same angle a full turn on are one angle.</summary>
    [Fact]
    public void A_turn_is_the_shorter_way_whatever_the_signs_and_full_turns_of_its_ends()
    {
        Quaternion from = AxisRotation.YawPitchRoll(3.1f, 0.1f, 0.2f);
        Quaternion to = AxisRotation.YawPitchRoll(-3.1f, 0.15f, 0.2f);
        foreach (AngularMeasure measure in Enum.GetValues<AngularMeasure>())
        {
            Vector3 turn = AngularCurve.Turn(from, to, measure);
            Assert.InRange(turn.Length(), 0.05f, 0.12f);
            Assert.True(Vec.Distance(turn, AngularCurve.Turn(from, new Quaternion(-to.X, -to.Y, -to.Z, -to.W), measure)) < 1e-4f, $"{measure}: {turn}");
        }
    }

    [Fact]
    public void A_swing_that_starts_and_stops_gives_two_moments_where_it_does()
    {
        // At rest, then 200°/s from 0.5 s to 1 s, then at rest: accelerations of 200 · 30 = 6000°/s² at both ends.
        Clip clip = Turning("Swing", ClipEnd.Stays, 46, t => Scalar.Radians(200) * Math.Clamp(t - 0.5, 0, 0.5));
        AngularFinding found = AngularEventDetector.Find(clip, arm, Rule);
        Assert.Equal([0.5f, 1f], found.Events.Select(e => MathF.Round(e.Time, 3)));
        Assert.All(found.Events, e => Assert.InRange(e.Strength, 5.99f, 6.01f));
        Assert.Equal((float)Scalar.Radians(200), found.Curves[0].Speeds[20], 4);
        Assert.Empty(AngularEventDetector.Find(clip, arm, Rule with { ThresholdPower = 3.8 }).Events);
        Assert.Equal(0.5f, Assert.Single(AngularEventDetector.Find(clip, arm, Rule with { Change = AngularChange.Quickening }).Events).Time, 3);
        Assert.Equal(1f, Assert.Single(AngularEventDetector.Find(clip, arm, Rule with { Change = AngularChange.Slowing }).Events).Time, 3);
    }

    [Fact]
    public void What_stops_away_from_its_rest_is_not_shut()
    {
        // Opened by 60° from 0.2 s to 0.5 s, shut again from 0.9 s to 1.2 s.
        Clip clip = Turning("Snap", ClipEnd.Stays, 46, t => Scalar.Radians(200) * (Math.Clamp(t - 0.2, 0, 0.3) - Math.Clamp(t - 0.9, 0, 0.3)));
        AngularRule rule = Rule with { Change = AngularChange.Slowing };
        Assert.Equal([0.5f, 1.2f], AngularEventDetector.Find(clip, arm, rule).Events.Select(e => MathF.Round(e.Time, 2)));
        Assert.Equal(1.2f, Assert.Single(AngularEventDetector.Find(clip, arm, rule with { NearRest = 0.3f }).Events).Time, 2);
        Assert.Throws<ArgumentException>(() => AngularEventDetector.Find(clip, arm, rule with { NearRest = 2f }));
    }

    [Fact]
    public void A_sweep_any_way_is_told_where_it_is_fastest_to_one_side_and_to_the_other()
    {
        Clip clip = Turning("Beat", ClipEnd.Loops, 61, t => 0.5 * Math.Sin(Math.PI * (t % 2)));
        AngularRule rule = Rule with { ThresholdPower = 1, ThresholdFraction = 0.6f, Sweep = AngularSweep.AnyWay };
        Assert.Equal([0f, 1f], AngularEventDetector.Find(clip, arm, rule).Events.Select(e => MathF.Round(e.Time, 2) % 2f).Order());
    }

    [Fact]
    public void A_loop_has_no_ends()
    {
        // The bone turns back at the seam: as a loop there is a moment there, as a clip that stays there is none.
        double Saw(double t) => Scalar.Radians(100) * (0.5 - Math.Abs(t - 0.5));
        Assert.Equal([0f, 0.5f], AngularEventDetector.Find(Turning("Saw", ClipEnd.Loops, 31, Saw), arm, Rule).Events.Select(e => MathF.Round(e.Time, 3)));
        Assert.Equal([0.5f], AngularEventDetector.Find(Turning("Saw", ClipEnd.Stays, 31, Saw), arm, Rule).Events.Select(e => MathF.Round(e.Time, 3)));
    }

    [Fact]
    public void Offsets_go_around_in_loops_and_stop_at_the_ends_of_others()
    {
        Clip loop = Turning("Saw", ClipEnd.Loops, 31, t => Scalar.Radians(100) * (0.5 - Math.Abs(t - 0.5)));
        Assert.Equal([0.4f, 0.9f], AngularEventDetector.Find(loop, arm, Rule with { Offset = -0.1f }).Events.Select(e => MathF.Round(e.Time, 3)));
        Clip once = Turning("Swing", ClipEnd.Stays, 46, t => Scalar.Radians(200) * Math.Clamp(t - 0.5, 0, 0.5));
        Assert.Equal([0f, 0.3f], AngularEventDetector.Find(once, arm, Rule with { Offset = -0.7f }).Events.Select(e => MathF.Round(e.Time, 3)));
    }

    [Fact]
    public void Euler_angles_see_a_turn_that_is_none_near_gimbal_lock_and_quaternions_do_not()
    {
        // An even turn of 60°/s about a slanted axis that passes straight up: nothing accelerates.
        Vector3 axis = Vector3.Normalize(new Vector3(1f, 0.05f, 0f));
        Clip clip = Turning("Over", ClipEnd.Stays, 91, t => Scalar.Radians(60) * t, axis);
        AngularRule rule = Rule with { ThresholdPower = 2 };
        Assert.Empty(AngularEventDetector.Find(clip, arm, rule).Events);
        Assert.NotEmpty(AngularEventDetector.Find(clip, arm, rule with { Measure = AngularMeasure.Euler }).Events);
    }

    [Fact]
    public void The_stream_finds_what_the_clip_has_and_says_how_late_it_is()
    {
        Clip clip = Turning("Swing", ClipEnd.Stays, 46, t => Scalar.Radians(200) * Math.Clamp(t - 0.5, 0, 0.5));
        var stream = new AngularEventStream(arm, Rule);
        var pose = new MovingPose(arm);
        var moments = new List<double>();
        for (int frame = 0; frame <= 90; frame++)
        {
            clip.Sample(frame / 60f, pose.Local);
            ForwardKinematics.LocalToModel(arm, pose.Local, pose.Model);
            stream.Update(pose.Local, pose.Model, 1f / 60f);
            foreach (AngularMoment moment in stream.Found)
            {
                Assert.InRange(moment.SecondsAgo, 0f, 0.05f);
                Assert.Equal(1, moment.Joint);
                moments.Add((frame / 60.0) - moment.SecondsAgo);
            }
        }

        Assert.Equal(2, moments.Count);
        Assert.InRange(moments[0], 0.48, 0.52);
        Assert.InRange(moments[1], 0.98, 1.02);
    }

    [Fact]
    public void A_stream_allocates_nothing()
    {
        var stream = new AngularEventStream(arm, Rule);
        var pose = new MovingPose(arm);
        Assert.Equal(0, MovingPose.Allocated(() => stream.Update(pose.Local, pose.Model, 0.01f), 100));
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade, "Trot")]
    [InlineData(BodyPlan.Sprawling, "SprawlTrot")]
    public void Every_foot_of_a_trot_is_heard_once_and_in_time(BodyPlan plan, string gait)
    {
        Creature creature = Subject(plan);
        Clip clip = ClipBaker.Bake(creature).First(c => c.Name == gait);
        ClipEvent[] steps = clip.Events.Where(e => e.Name == "footstep").ToArray();
        IReadOnlyList<ClipEvent> found = AngularEventDetector.Find(clip, creature.Skeleton, AngularRules.Footstep).Events;
        Assert.Equal(steps.Select(e => e.Joint).Order(), found.Select(e => e.Joint).Order());
        foreach (ClipEvent step in steps)
        {
            float apart = Math.Abs(found.Single(e => e.Joint == step.Joint).Time - step.Time);
            Assert.InRange(Math.Min(apart, clip.Duration - apart), 0f, 0.05f);
        }
    }

    [Fact]
    public void A_sweep_begins_once_a_stroke_where_it_has_its_even_speed_however_it_wavers()
    {
        // A bone along +Y swings ahead for 0.6 s, is carried back from 0.6 s to 1.6 s with a halt between, and stays; twice.
        double Angle(double t)
        {
            double within = t % 2.0;
            return within < 0.6 ? within / 0.6 * 0.6 : within < 1 ? 0.6 - (within - 0.6) * 0.75 : within < 1.2 ? 0.3 : within < 1.6 ? 0.3 - ((within - 1.2) * 0.75) : 0;
        }

        Clip clip = Turning("Stroke", ClipEnd.Loops, 121, Angle);
        AngularRule rule = Rule with { ThresholdPower = 0, Sweep = new AngularSweep(new Vector3(0f, 0f, -2f)) };
        AngularFinding found = AngularEventDetector.Find(clip, arm, rule);
        Assert.Equal([0.6f, 2.6f], found.Events.Select(e => MathF.Round(e.Time, 1)));
        Assert.All(found.Events, e => Assert.Equal("J1", e.Joint));
        Assert.True(found.Curves[0].Signal[5] < 0f && found.Curves[0].Signal[20] > 0f);
        Assert.Empty(AngularEventDetector.Find(clip, arm, rule with { ThresholdPower = 2 }).Events);

        var stream = new AngularEventStream(arm, rule);
        var pose = new MovingPose(arm);
        var live = new List<double>();
        for (int frame = 0; frame <= 360; frame++)
        {
            clip.Sample(ClipTime.Within(frame / 60f, clip.Duration, ClipEnd.Loops), pose.Local);
            ForwardKinematics.LocalToModel(arm, pose.Local, pose.Model);
            stream.Update(pose.Local, pose.Model, 1f / 60f);
            foreach (AngularMoment moment in stream.Found)
            {
                live.Add(Math.Round((frame / 60.0) - moment.SecondsAgo, 1));
            }
        }

        // The first stroke teaches.
        Assert.Equal([2.6, 4.6], live);
        Assert.Contains("without length", Assert.Throws<ArgumentException>(() => new AngularSweep(Vector3.Zero)).Message, StringComparison.Ordinal);
        Assert.Contains("fractions of 0 to 1", Assert.Throws<ArgumentException>(() => AngularEventDetector.Find(clip, arm, rule with { Sweep = new AngularSweep(Vector3.UnitX) { BeginsAt = float.NaN } })).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void What_a_rule_cannot_mean_is_told()
    {
        Clip clip = Turning("Swing", ClipEnd.Stays, 46, t => t);
        Refused("the joint \"Elbow\"; expected names", Rule with { Joints = ["Elbow"] });
        Refused("10^NaN degrees/s²; expected", Rule with { ThresholdPower = double.NaN });
        Refused("an interval of -1", Rule with { Interval = -1f });
        Refused("names no joint", Rule with { Joints = [] });
        Assert.Contains("expected the 4", Assert.Throws<ArgumentException>(() => AngularEventDetector.Find(clip, MovingPose.Chain(3, 1f, JointLimit.Free), Rule)).Message, StringComparison.Ordinal);

        void Refused(string message, AngularRule rule) =>
            Assert.Contains(message, Assert.Throws<ArgumentException>(() => AngularEventDetector.Find(clip, arm, rule)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Names_of_joints_may_have_stars()
    {
        Clip clip = Turning("Swing", ClipEnd.Stays, 46, t => t);
        Assert.Equal(["J0", "J1", "J2"], AngularEventDetector.Find(clip, arm, Rule with { Joints = ["J*"] }).Curves.Select(c => c.Joint));
        Assert.Equal(["J1"], AngularEventDetector.Find(clip, arm, Rule with { Joints = ["*1"] }).Curves.Select(c => c.Joint));
        Assert.Equal(["J0", "J2"], AngularEventDetector.Find(clip, arm, Rule with { Joints = ["J*"], Excluded = ["*1"] }).Curves.Select(c => c.Joint));
    }

    /// <summary>The middle joint of the arm turns about an axis, 30 frames a second.</summary>
    private static Clip Turning(string name, ClipEnd end, int frames, Func<double, double> angle, Vector3? axis = null)
    {
        var rotations = new Quaternion[frames * arm.Count];
        var positions = new Vector3[rotations.Length];
        for (int i = 0; i < rotations.Length; i++)
        {
            rotations[i] = i % arm.Count == 1 ? Rotation.FromAxisAngle(axis ?? Vector3.UnitX, angle(i / arm.Count / 30.0)) : Quaternion.Identity;
            positions[i] = arm.LocalPositions[i % arm.Count];
        }

        return new Clip(name, end, 30, 0f, arm.Count, rotations, positions);
    }

    private static Creature Subject(BodyPlan plan)
    {
        for (ulong seed = 20; ; seed++)
        {
            Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Strangeness = 0 });
            if (creature.Blueprint.Plan == plan)
            {
                return creature;
            }
        }
    }
}
