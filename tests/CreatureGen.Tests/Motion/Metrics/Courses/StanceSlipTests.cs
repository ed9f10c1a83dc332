using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;
using CreatureGen.Tests.Motion.Kept;
using Xunit;

namespace CreatureGen.Tests.Motion.Metrics.Courses;

/// <summary>Whole stances of creatures that a player drives over the flat: feet that their legs cannot keep in place any more are let go before they slide.</summary>
public sealed class StanceSlipTests
{
    private const float Rate = 120f;

    [Theory]
    [InlineData(7100000UL)]
    [InlineData(7100001UL, Explicit = true)]
    [InlineData(7100004UL, Explicit = true)]
    [InlineData(7100005UL, Explicit = true)]
    [InlineData(7100006UL, Explicit = true)]
    [InlineData(7100009UL, Explicit = true)]
    [InlineData(7100012UL, Explicit = true)]
    public void Feet_of_unseen_walkers_stay_where_they_stand_while_speeds_and_turns_change(ulong seed)
    {
        var profile = new MotionProfile(Walkers.Any(seed));
        var courses = new List<MotionCourse>
        {
            new(CourseScripts.Random(profile, 12f, 2.5f), CourseGround.Flat, CourseRate.Of(Rate)),
            new(CourseScripts.Spin(profile), CourseGround.Flat, CourseRate.Of(Rate)),
        };
        foreach (CourseReport report in courses.Select(course => course.Run(profile)))
        {
            Assert.True(report.StanceSlip99 <= 0.012f, $"{seed}: one stance of a hundred slips by {report.StanceSlip99}");
            Assert.True(report.StanceSlip <= 0.035f, $"{seed}: a stance slips by {report.StanceSlip}");
        }
    }

    /// <summary>Cats, whose round toes were taken for edges: each step slid by half a percent of a leg as it rolled off.</summary>
    [Theory]
    [InlineData(9920002UL)]
    [InlineData(9920037UL, Explicit = true)]
    public void Paws_roll_over_their_round_toes_without_sliding(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CourseReport report = new MotionCourse(CourseScripts.Random(profile, 12f, 0f), CourseGround.Flat, CourseRate.Of(480f)).Run(profile);
        Assert.True(report.StanceSlip99 <= 0.002f, $"{seed}: one stance of a hundred slips by {report.StanceSlip99}");
    }

    /// <summary>A dog-like runner that brakes: its hip came to its end between two decisions, far sooner than its leg lay flat, and dragged the foot by 2.3 % of a leg.</summary>
    [Fact]
    public void A_foot_of_who_brakes_is_let_go_before_its_hip_ends()
    {
        var profile = new MotionProfile(KeptCreatures.Of(10900030));
        CourseReport report = new MotionCourse(CourseScripts.Random(profile, 12f, 0f), CourseGround.Flat, CourseRate.Of(480f)).Run(profile);
        Assert.True(report.StanceSlip <= 0.015f, $"a stance slips by {report.StanceSlip}");
    }

    /// <summary>Toes of a hoofed runner that lay on the ground beside its ankle's limit, and went along with that at once as they left it: by 72 rad/s.</summary>
    [Fact]
    public void Toes_leave_the_ground_as_they_lay_on_it()
    {
        var profile = new MotionProfile(KeptCreatures.Of(10900035));
        CourseReport report = new MotionCourse(CourseScripts.Keys(profile, 12f), CourseGround.Flat, CourseRate.Of(480f)).Run(profile);
        Assert.True(report.JointSpeed < 60f, $"{profile.Subject.Skeleton.Joints[report.JointSpeedJoint].Name} turns by {report.JointSpeed} rad/s");
    }

    /// <summary>Theropods that took 4.8 and 3.3 steps a second as they turned on the spot; knees turned by 62 rad/s.</summary>
    [Theory]
    [InlineData(9920010UL)]
    [InlineData(9920016UL, Explicit = true)]
    public void Who_turns_on_the_spot_takes_no_quicker_steps_than_its_mass_lets_it(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CourseReport report = new MotionCourse(CourseScripts.Spin(profile), CourseGround.Flat, CourseRate.Of(480f)).Run(profile);
        Assert.True(report.JointSpeed < 55f, $"{seed}: {profile.Subject.Skeleton.Joints[report.JointSpeedJoint].Name} turns by {report.JointSpeed} rad/s");
        Assert.True(report.StanceSlip < 0.01f, $"{seed}: a stance slips by {report.StanceSlip}");
    }

    /// <summary>Insects in a bound, at the sizes that they are given: the hip of a fore leg that carries the body comes to its end between two decisions, and the foot would go with the body from there on. Before that was foreseen these slipped by 4 and 6 % of a leg.</summary>
    [Theory]
    [InlineData(9920023UL)]
    [InlineData(9920035UL, Explicit = true)]
    public void Feet_of_insects_that_bound_are_let_go_before_their_hips_end(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        var course = new MotionCourse(CourseScripts.Random(profile, 12f, 0f), CourseGround.Flat, CourseRate.Of(480f));
        CourseReport report = course.Run(profile);
        Assert.True(report.StanceSlip <= 0.025f, $"{seed}: a stance slips by {report.StanceSlip}");
    }

    /// <summary>Their ankles turned by 133 and 113 rad/s: fore feet folded to the body kept to the heading of their step, which the ankle of a shank that passes below its hip cannot.</summary>
    [Theory]
    [InlineData(9920009UL)]
    [InlineData(9920023UL, Explicit = true)]
    public void Feet_of_insects_that_bound_go_along_with_their_shanks_as_they_are_folded_to_the_body(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CourseReport report = new MotionCourse(CourseScripts.Random(profile, 12f, 2.5f), CourseGround.Flat, CourseRate.Of(480f)).Run(profile);
        Assert.True(report.JointSpeed < 60f, $"{seed}: {profile.Subject.Skeleton.Joints[report.JointSpeedJoint].Name} turns by {report.JointSpeed} rad/s");
    }

    /// <summary>A leg whose hip ends before its foot is where it was to come down: the foot was dragged there for a third of its stance, by 5.1 % of a leg.</summary>
    [Fact]
    public void A_foot_that_comes_down_short_of_its_place_stands_where_its_leg_has_brought_it()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(9920021, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        MotionCourse course = MotionCourse.Of(profile).Single(course => course.Ground == CourseGround.Lift);
        CourseReport report = course.Run(profile);
        Assert.True(report.StanceSlip < 0.005f, $"a stance slips by {report.StanceSlip}");
    }

    /// <summary>A theropod and a sprawler whose ankles do not lie down on slopes: on ground steeper than 4° their feet turned about their middle, whatever edge of them was down, and slipped by 4 % of a leg.</summary>
    [Theory]
    [InlineData(13800040UL)]
    [InlineData(13800273UL, Explicit = true)]
    public void Feet_that_their_ankles_turn_stay_where_they_stand_on_hills_too(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CourseReport report = MotionCourse.Of(profile).Single(course => course.Ground == CourseGround.Rough).Run(profile);
        Assert.True(report.StanceSlip < 0.015f, $"{seed}: a stance slips by {report.StanceSlip}");
    }
}
