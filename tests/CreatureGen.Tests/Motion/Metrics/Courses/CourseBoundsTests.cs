using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;
using CreatureGen.Tests.Motion.Kept;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Metrics.Courses;

/// <summary>How bad the worst of some creatures is on their courses. The bounds are what is measured, rounded up: whoever mends a cause lowers them. On stairs, where toes and heels may be in risers, feet are deeper. Creatures have the sizes of their seeds, at which that was measured: what a player asks of another size comes at other moments of its strides.</summary>
public sealed class CourseBoundsTests
{
    private const float DegreesPerRadian = 57.29578f;

    [Fact]
    public void Walkers_are_no_worse_than_they_were() => Hold(RequestedKind.Walking, Thoroughness.IsExhaustive ? [1, 2, 4, 5] : [1], 0f, new Bounds(Degrees: 0.094f, RadiansPerSecond: 50f, Gs: 1.5f, Depth: 0.0465f, Riser: 0.14f, Slip: 0.022f, Lag: 0.252f, Lost: 0, Spread: 0.004f));

    /// <summary>Four mixed ones, as seeds 11 to 14 gave them then.</summary>
    [Fact(Explicit = true)]
    public void Strange_walkers_are_no_worse_than_they_were() => Hold(KeptCreatures.AtSizeOfSeed, [11, 12, 13, 14], new Bounds(Degrees: 0.094f, RadiansPerSecond: 55f, Gs: 2f, Depth: 0.0125f, Riser: 0.11f, Slip: 0.02f, Lag: 0.275f, Lost: 0, Spread: 0.01f));

    /// <summary>Two frogs and a cat that were among the worst of 300, as they were then (<see cref="KeptCreatures"/>); the wings of 9920168, which grow otherwise since, are a twentieth shorter: what it weighs decides at which moment it comes to rest.</summary>
    [Fact(Explicit = true)]
    public void Leapers_are_no_worse_than_they_were() => Hold(KeptCreatures.AtSizeOfSeed, [9920168, 9920193, 9920015], new Bounds(Degrees: 0.094f, RadiansPerSecond: 58.5f, Gs: 1.5f, Depth: 0.048f, Riser: 0.145f, Slip: 0.052f, Lag: 0.334f, Lost: 0, Spread: 0.001f));

    [Fact]
    public void Fliers_are_no_worse_than_they_were() => Hold(RequestedKind.Flying, Thoroughness.IsExhaustive ? [1, 7] : [1], 0f, new Bounds(Degrees: 0.094f, RadiansPerSecond: 57f, Gs: 5.6f, Depth: 0.0005f, Riser: 0.075f, Slip: 0.005f, Lag: 0.245f, Lost: 0, Spread: 0.01f));

    /// <summary>Three that were among the worst of 300 as they came down, as they were then.</summary>
    [Fact(Explicit = true)]
    public void Landing_fliers_are_no_worse_than_they_were() => Hold(KeptCreatures.AtSizeOfSeed, [9920014, 9920059, 9920269], new Bounds(Degrees: 0.094f, RadiansPerSecond: 58.5f, Gs: 10f, Depth: 0.004f, Riser: 0.1f, Slip: 0.02f, Lag: 0.286f, Lost: 0, Spread: 0.01f));

    [Fact]
    public void Swimmers_are_no_worse_than_they_were() => Hold(RequestedKind.Swimming, [1, 6], 0f, new Bounds(Degrees: 0.001f, RadiansPerSecond: 4.15f, Gs: 0.8f, Depth: 0f, Riser: 0f, Slip: 0f, Lag: 0f, Lost: 0, Spread: 0f));

    /// <summary>Heads that turned as soon as another turn was asked for were 75 to 144 rad/s fast in these, though no joint of their necks was.</summary>
    [Theory]
    [InlineData(RequestedKind.Walking, 10743000UL, 6)]
    [InlineData(RequestedKind.Flying, 10743000UL, 3)]
    public void Heads_and_legs_go_along_with_whatever_keys_are_pressed(RequestedKind kind, ulong first, int count)
    {
        for (ulong seed = first; seed < first + (ulong)count; seed++)
        {
            var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }));
            CourseReport report = MotionCourse.Of(profile).Single(course => course.Script.Name == "keys").Run(profile);
            Assert.InRange(report.HeadSpeed!.Value, 0.1f, 20f);
            Assert.True(report.JointSpeed < 75f, $"{kind} {seed}: {profile.Subject.Skeleton.Joints[report.JointSpeedJoint].Name} turns by {report.JointSpeed} rad/s");
            Assert.True(report.LimitExcess * DegreesPerRadian < 0.1f, $"{kind} {seed}: {report.LimitExcess} rad beyond limits");
        }
    }

    /// <summary>
    /// Knees that were folded as far as they go flew open for a frame down stairs (142 rad/s); the foot of a leg that its hip takes off its way came down through the ground and was lifted out of it as it stood (115, and a foot dragged by .106 of its leg in a turn);
    /// large feet that roll in short steps came down in the last hundredth of a second (74).
    /// </summary>
    [Theory]
    [InlineData(RequestedKind.Flying, 15100091UL, "runner", 65f, 0.02f)]
    [InlineData(RequestedKind.Flying, 15100071UL, "straight", 65f, 0.01f)]
    [InlineData(RequestedKind.Flying, 15100071UL, "keys", 65f, 0.08f)]
    [InlineData(RequestedKind.Walking, 19000046UL, "keys", 65f, 0.01f)]
    public void Legs_at_the_end_of_what_their_joints_do_neither_fling_nor_drag_their_feet(RequestedKind kind, ulong seed, string script, float radiansPerSecond, float slip) =>
        Hold(kind, seed, script, 1, radiansPerSecond, slip);

    /// <summary>
    /// Feet that pass under their hips whirled about them (83 and 366 rad/s); one that had just left the ground as its gait took its swing back was thrown to where it was to come down (116);
    /// the ankle of one that the body carries, whose ball did not go along, jumped as its joint came to its end (72); feet of short swings were whirled level before they came down (71);
    /// one in the air waited for a clock that all but stood as its body braked to go back, aimed at places farther and farther behind, and was hurled from there at the next command (122);
    /// what was left of that kind, in the air (77) and on the ground (109 and 71), legs lag behind.
    /// </summary>
    [Theory]
    [InlineData(RequestedKind.Walking, 19000006UL, "keys", 1, 60f)]
    [InlineData(RequestedKind.Walking, 20000028UL, "keys", 0.6, 60f)]
    [InlineData(RequestedKind.Flying, 20000049UL, "random", 0.6, 60f)]
    [InlineData(RequestedKind.Walking, 20000047UL, "keys", 0.6, 60f)]
    [InlineData(RequestedKind.Walking, 20000031UL, "straight", 0.6, 60f)]
    [InlineData(RequestedKind.Walking, 22400017UL, "keys", 0.6, 60f)]
    [InlineData(RequestedKind.Walking, 23110103UL, "keys", 0.6, 58.5f)]
    [InlineData(RequestedKind.Walking, 19000048UL, "spin", 1, 58.5f)]
    [InlineData(RequestedKind.Flying, 22400008UL, "straight", 0.6, 58.5f)]
    public void No_joint_is_whirled_by_a_foot_in_the_air(RequestedKind kind, ulong seed, string script, double strangeness, float radiansPerSecond) => Hold(kind, seed, script, strangeness, radiansPerSecond, 0.02f);

    /// <summary>
    /// Toes of which all but the root hung over an edge, and those that were raised to a step that they did not reach, stood on air, and what else touched was dragged as they rolled (.022 and .027).
    /// Ankles at their end were followed by half, so that flat feet crept and sank down stairs (.012 and .009); long toes rolled over a tip that was in the air on hills (.007).
    /// </summary>
    [Theory]
    [InlineData(20000106UL, "runner", 0.005f)]
    [InlineData(20000103UL, "runner", 0.005f)]
    [InlineData(24352043UL, "runner", 0.0075f)]
    [InlineData(24352052UL, "runner", 0.005f)]
    public void What_stands_of_a_foot_is_not_dragged_as_that_turns_or_rolls(ulong seed, string script, float slip) => Hold(RequestedKind.Walking, seed, script, CreatureOptions.Default.Strangeness, 60f, slip);

    /// <summary>
    /// On hills feet on an edge of their sole were laid half way and dragged by the rest (.021), hips came to their end in the last moments of a stance (.015 and .027), and feet of pillars were turned along with the body (.017).
    /// </summary>
    [Theory]
    [InlineData(22400018UL, 0.01f)]
    [InlineData(22400033UL, 0.005f)]
    [InlineData(22400014UL, 0.015f)]
    [InlineData(22400005UL, 0.01f)]
    public void Neither_ankles_nor_hips_at_their_end_drag_feet_on_hills(ulong seed, float slip) => Hold(RequestedKind.Walking, seed, "mixed", CreatureOptions.Default.Strangeness, 60f, slip);

    /// <summary>The root of these was on the ground under the middle of their feet, which stand two treads ahead of the hips (.418, .318 and .295), or are thrown up from tread to tread (.290).</summary>
    [Theory]
    [InlineData(RequestedKind.Walking, 23100107UL)]
    [InlineData(RequestedKind.Walking, 23100063UL)]
    [InlineData(RequestedKind.Walking, 23100101UL)]
    [InlineData(RequestedKind.Walking, 23100066UL)]
    public void The_root_of_a_runner_on_stairs_is_on_the_ground_under_its_hips(RequestedKind kind, ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }));
        CourseReport report = MotionCourse.Of(profile).Single(course => course.Ground == CourseGround.Stairs).Run(profile);
        Assert.InRange(report.RootLag!.Value, 0.05f, 0.25f);
    }

    /// <summary>
    /// Feet of claws were turned about the middle of their soles with their legs (.007), toes of a grasshopper were not in the outline on which its feet roll (.023), hips of a bird came to their end between two decisions (.056),
    /// a sprawler came to rest on stairs on a foot that its leg did not reach (.031), and feet of fliers that legs on the ground did not reach down to were drawn along the ground as these came nearer (.011 and .006);
    /// those that had come to rest under a body on many legs were dragged for seconds by one that crept on, more slowly than counts as going (.100), and those of a bird that rested on stairs behind its hips, where their soles had room, as it stood up (.121);
    /// the ankle of a centaur in the sharpest turn of its gallop came up faster than its foot was laid anew (.023).
    /// </summary>
    [Theory]
    [InlineData(RequestedKind.Walking, 24810052UL, "keys", 0.02f)]
    [InlineData(RequestedKind.Flying, 24780046UL, "runner", 0.01f)]
    [InlineData(RequestedKind.Flying, 24552057UL, "keys", 0.005f)]
    [InlineData(RequestedKind.Flying, 24710029UL, "spin", 0.003f)]
    [InlineData(RequestedKind.Walking, 24700080UL, "straight", 0.01f)]
    [InlineData(RequestedKind.Walking, 23151019UL, "keys", 0.005f)]
    [InlineData(RequestedKind.Walking, 23151004UL, "straight", 0.01f)]
    [InlineData(RequestedKind.Flying, 22400038UL, "keys", 0.01f)]
    [InlineData(RequestedKind.Walking, 22400028UL, "runner", 0.025f)]
    public void Feet_stay_where_they_stand_as_their_legs_go_over_them(RequestedKind kind, ulong seed, string script, float slip) => Hold(kind, seed, script, CreatureOptions.Default.Strangeness, 65f, slip);

    /// <summary>The bones of a back that rises are twisted by its bends to a side (1.012 degrees beyond their limits).</summary>
    [Fact]
    public void A_back_that_rises_is_not_twisted_beyond_its_limits_in_a_turn()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(24800047, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CourseReport report = MotionCourse.Of(profile).Single(course => course.Script.Name == "keys").Run(profile);
        Assert.InRange(report.LimitExcess * DegreesPerRadian, 0f, 0.1f);
    }

    /// <summary>
    /// A foot that had set off under a body that went came down .037 of a leg from its home as that stood still, and stayed there, at one rate of three;
    /// what a turned foot rolled down in the update in which it came down was missing from where it stood (.0105).
    /// </summary>
    [Theory(Explicit = true)]
    [InlineData(23153321)]
    [InlineData(24810078)]
    public void Feet_come_to_rest_in_the_same_places_at_every_frame_rate(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        foreach ((MotionCourse course, CourseReport report) in MotionCourse.RunAll(profile))
        {
            Assert.False(report.RestingFootSpread > 0.01f, $"{course.Rate}: {report.RestingFootSpread} leg lengths apart");
        }
    }

    private static void Hold(RequestedKind kind, ulong seed, string script, double strangeness, float radiansPerSecond, float slip)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind, Strangeness = strangeness }));
        CourseReport report = MotionCourse.Of(profile).First(course => course.Script.Name == script).Run(profile);
        Assert.True(report.JointSpeed < radiansPerSecond, $"{profile.Subject.Skeleton.Joints[report.JointSpeedJoint].Name} turns by {report.JointSpeed} rad/s");
        Assert.True(report.StanceSlip < slip, $"slips by {report.StanceSlip} leg lengths");
    }

    private static void Hold(RequestedKind kind, ulong[] seeds, float strangeness, Bounds bounds) =>
        Hold(seed => CreatureGenerator.Generate(seed, SizeOfSeed.In(CreatureOptions.Default with { Kind = kind, Strangeness = strangeness }, seed)), seeds, bounds);

    private static void Hold(Func<ulong, Creature> grow, ulong[] seeds, Bounds bounds)
    {
        var broken = new List<string>();
        foreach (ulong seed in seeds)
        {
            Creature creature = grow(seed);
            var profile = new MotionProfile(creature);
            foreach ((MotionCourse Course, CourseReport Report) run in MotionCourse.RunAll(profile).Where(run => run.Course.Script.Name != "keys"))
            {
                CourseReport report = run.Report;
                string name = FormattableString.Invariant($"{creature.Blueprint.Kind} {seed} {run.Course.Script} {run.Course.Ground} {run.Course.Rate}");
                Check(name, "degrees beyond limits", report.LimitExcess * DegreesPerRadian, bounds.Degrees);
                Check(name, "rad/s of a joint", report.JointSpeed, bounds.RadiansPerSecond);
                Check(name, "g", report.LinearAcceleration / StandardGravity.Acceleration, bounds.Gs);
                Check(name, "legs in the ground", report.Penetration, run.Course.Ground == CourseGround.Stairs ? bounds.Riser : bounds.Depth);
                Check(name, "legs of slip", report.StanceSlip, bounds.Slip);
                Check(name, "legs of lag", report.RootLag, bounds.Lag);
                Check(name, "times without ground", report.LostGround, bounds.Lost);
                Check(name, "legs from rate to rate", report.RestingFootSpread, bounds.Spread);
            }
        }

        Assert.True(broken.Count == 0, string.Join(Environment.NewLine, broken));

        void Check(string name, string what, float? value, float bound)
        {
            if (value > bound)
            {
                broken.Add(FormattableString.Invariant($"{name}: {value} {what}, at most {bound} before"));
            }
        }
    }

    private readonly record struct Bounds(float Degrees, float RadiansPerSecond, float Gs, float Depth, float Riser, float Slip, float Lag, int Lost, float Spread);
}
