using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Seeding;

namespace CreatureGen.Motion.Metrics;

/// <summary>A creature under the commands of a player, measured from its first step on: starts, stops, turns, changes of gait, on any ground and at any frame rate. The same course gives the same figures.</summary>
/// <param name="Script">What is asked.</param>
/// <param name="Ground">What it goes over.</param>
/// <param name="Rate">How long its updates are.</param>
public sealed record MotionCourse(CourseScript Script, CourseGround Ground, CourseRate Rate)
{
    private const float RandomSeconds = 12f;
    private const float UnevenSeconds = 36f;
    private const float FineRate = 480f;

    private static readonly float[] coarseRates = { 30f, 60f, 144f };

    /// <summary>
    /// The courses that every creature is measured on: on the flat random commands at 480 Hz, the same at 30, 60 and 144 Hz, longer at an uneven rate, turns on the spot, random speeds straight ahead, keys that are held and let go;
    /// those that go on legs also over hills, up and down stairs at a run, and on a lift.
    /// </summary>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static IReadOnlyList<MotionCourse> Of(MotionProfile profile)
    {
        CourseScript random = CourseScripts.Random(profile, RandomSeconds, 2.5f);
        var courses = new List<MotionCourse> { new(random, CourseGround.Flat, CourseRate.Of(FineRate)) };
        courses.AddRange(coarseRates.Select(hertz => new MotionCourse(random, CourseGround.Flat, CourseRate.Of(hertz))));
        courses.Add(new MotionCourse(CourseScripts.Random(profile, UnevenSeconds, 2f), CourseGround.Flat, CourseRate.Uneven));
        courses.Add(new MotionCourse(CourseScripts.Spin(profile), CourseGround.Flat, CourseRate.Of(FineRate)));
        courses.Add(new MotionCourse(CourseScripts.Random(profile, RandomSeconds, 0f), CourseGround.Flat, CourseRate.Of(FineRate)));
        courses.Add(new MotionCourse(CourseScripts.Keys(profile, RandomSeconds), CourseGround.Flat, CourseRate.Of(FineRate)));
        if (profile.Legs != null)
        {
            courses.Add(new MotionCourse(CourseScripts.Mixed(profile, RandomSeconds), CourseGround.Rough, CourseRate.Of(60f)));
            courses.Add(new MotionCourse(CourseScripts.Runner(profile, RandomSeconds), CourseGround.Stairs, CourseRate.Of(60f)));
            courses.Add(new MotionCourse(CourseScripts.Mixed(profile, RandomSeconds), CourseGround.Lift, CourseRate.Of(60f)));
        }

        return courses;
    }

    /// <summary>The courses on one ground, of all that there are: changing speeds and turns, and runs straight ahead, at 60 Hz. What has no legs to walk on has them on the flat only.</summary>
    /// <param name="profile">The creature's.</param>
    /// <param name="ground">What it goes over.</param>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The ground is none of them.</exception>
    public static IReadOnlyList<MotionCourse> On(MotionProfile profile, CourseGround ground)
    {
        if (profile == null)
        {
            throw new ArgumentNullException(nameof(profile));
        }

        if (ground < CourseGround.Flat || ground > CourseGround.Pipe)
        {
            throw new ArgumentOutOfRangeException(nameof(ground), ground, "expected a ground of courses");
        }

        return profile.Legs == null && ground != CourseGround.Flat ? Array.Empty<MotionCourse>() : new[]
        {
            new MotionCourse(CourseScripts.Mixed(profile, RandomSeconds), ground, CourseRate.Of(60f)),
            new MotionCourse(CourseScripts.Runner(profile, RandomSeconds), ground, CourseRate.Of(60f)),
        };
    }

    /// <summary>Runs all courses of a creature. Of one script at several rates, those below the finest know how far from where they stood then the resting feet ended.</summary>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static IReadOnlyList<(MotionCourse Course, CourseReport Report)> RunAll(MotionProfile profile)
    {
        var runs = new List<(MotionCourse Course, CourseReport Report)>();
        var finest = new Dictionary<(CourseScript, CourseGround), RestingPlace>();
        foreach (MotionCourse course in Of(profile))
        {
            CourseRecorder recorder = course.Record(profile);
            CourseReport report = recorder.Report();
            RestingPlace rest = recorder.Rest();
            report = finest.TryGetValue((course.Script, course.Ground), out RestingPlace? fine)
                ? report with { RestingFootSpread = rest.FootSpread(fine), RestingRootSpread = rest.RootSpread(fine) }
                : report;
            finest.TryAdd((course.Script, course.Ground), rest);
            runs.Add((course, report));
        }

        return runs;
    }

    /// <summary>Runs the course.</summary>
    /// <param name="profile">The creature's.</param>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public CourseReport Run(MotionProfile profile) => Record(profile).Report();

    private CourseRecorder Record(MotionProfile profile)
    {
        if (profile == null)
        {
            throw new ArgumentNullException(nameof(profile));
        }

        var simulation = new CourseSimulation(profile, Script, Ground, Rate);
        var recorder = new CourseRecorder(simulation.Animator, simulation.Surface);
        foreach (float seconds in simulation.Updates())
        {
            recorder.Record(seconds);
        }

        return recorder;
    }
}
