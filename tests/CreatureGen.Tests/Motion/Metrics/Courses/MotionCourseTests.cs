using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Metrics.Courses;

public sealed class MotionCourseTests
{
    [Fact(Explicit = true)]
    public void A_course_gives_the_same_figures_whenever_it_is_run()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        foreach (CourseGround ground in Enum.GetValues<CourseGround>())
        {
            var course = new MotionCourse(CourseScripts.Mixed(profile, 3f), ground, CourseRate.Uneven);
            CourseReport report = course.Run(profile);
            Assert.Equal(report, course.Run(new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking))));
            Assert.True(report.Frames > 30 && report.Stances > 3);
        }
    }

    [Fact]
    public void One_who_stands_still_on_the_flat_does_not_slip_sink_lag_or_hurry()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        CourseReport report = new MotionCourse(new CourseScript("stand", [new CourseCommand(2f, default)]), CourseGround.Flat, CourseRate.Of(60f)).Run(profile);
        Assert.Equal(120, report.Frames);
        Assert.Equal(2f, report.Seconds, 1e-4f);
        Assert.Equal(0f, report.LimitExcess, 1e-4f);
        Assert.Equal(4, report.Stances);
        Assert.Equal([4f, 4f, 0f], new[] { report.MinSupport!.Value, report.MeanSupport!.Value, report.LongestFlight!.Value });
        Assert.InRange(report.StanceSlip!.Value, 0f, 1e-3f);
        Assert.Equal([0f, 0f, 0f], new[] { report.LinearAcceleration, report.RootLag!.Value, report.LostGround!.Value });
        Assert.InRange(report.JointSpeed, 0f, 5f);
    }

    [Theory]
    [InlineData(RequestedKind.Swimming, "fish")]
    [InlineData(RequestedKind.Walking, "cobra")]
    public void What_goes_on_no_feet_has_no_figures_of_feet(RequestedKind kind, string body)
    {
        var profile = new MotionProfile(SpeciesSubject.Of(body, kind));
        Assert.All(MotionCourse.Of(profile), course => Assert.Equal(CourseGround.Flat, course.Ground));
        CourseReport report = new MotionCourse(CourseScripts.Random(profile, 3f, 2f), CourseGround.Flat, CourseRate.Of(60f)).Run(profile);
        Assert.Equal([null, null, null, null, null, null], new[] { report.StanceSlip, report.Penetration, report.Clearance, report.RootLag, report.LostGround, report.MeanSupport });
        Assert.True(report.JointSpeed > 0.1f && report.LinearAcceleration > 0.1f);
    }

    [Fact]
    public void Every_creature_is_measured_on_each_ground_and_at_every_rate()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        IReadOnlyList<MotionCourse> courses = MotionCourse.Of(profile);
        Assert.Equal([CourseGround.Flat, CourseGround.Rough, CourseGround.Stairs, CourseGround.Lift], courses.Select(course => course.Ground).Distinct().Order());
        Assert.Equal(["144", "30", "480", "60", "uneven"], courses.Where(course => course.Ground == CourseGround.Flat).Select(course => course.Rate.ToString()).Distinct().Order(StringComparer.Ordinal));
        Assert.Equal(courses.Count, courses.Select(course => (course.Script.Name, course.Ground, course.Rate)).Distinct().Count());
    }

    [Theory]
    [InlineData(CourseGround.Water)]
    [InlineData(CourseGround.Stones, Explicit = true)]
    [InlineData(CourseGround.Slope, Explicit = true)]
    public void A_creature_is_measured_on_a_ground_that_is_asked_for(CourseGround ground)
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        IReadOnlyList<MotionCourse> courses = MotionCourse.On(profile, ground);
        Assert.Equal(2, courses.Count);
        Assert.All(courses, course => Assert.Equal(ground, course.Ground));
        Assert.True(courses[1].Run(profile).Stances > 10);
        Assert.Empty(MotionCourse.On(new MotionProfile(SpeciesSubject.Of("fish", RequestedKind.Swimming)), ground));
    }

    [Fact]
    public void A_ground_that_there_is_not_is_refused()
    {
        var profile = new MotionProfile(SpeciesSubject.Of("feline", RequestedKind.Walking));
        Assert.Throws<ArgumentOutOfRangeException>(() => MotionCourse.On(profile, (CourseGround)99));
        Assert.Throws<ArgumentNullException>(() => MotionCourse.On(null!, CourseGround.Water));
    }

    [Fact]
    public void No_profile_is_refused()
    {
        var script = new CourseScript("stand", [new CourseCommand(1f, default)]);
        Assert.Throws<ArgumentNullException>(() => new MotionCourse(script, CourseGround.Flat, CourseRate.Of(60f)).Run(null!));
        Assert.Throws<ArgumentNullException>(() => MotionCourse.RunAll(null!));
        Assert.Throws<ArgumentNullException>(() => CourseScripts.Spin(null!));
    }
}
