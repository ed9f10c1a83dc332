using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Text;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Rigging;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Working;

/// <summary>What came of measuring a creature on one course.</summary>
/// <param name="Kind">How the creature moves.</param>
/// <param name="Plan">How it carries its body.</param>
/// <param name="Seed">Its seed.</param>
/// <param name="LegLength">Metres; null for a creature without legs to stand on.</param>
/// <param name="Course">The course.</param>
/// <param name="LimitExcessJoint">The joint that is farthest beyond its limits; null for none.</param>
/// <param name="JointSpeedJoint">The fastest joint; null for none.</param>
/// <param name="Report">The figures.</param>
internal sealed record MeasuredCourse(LocomotionKind Kind, BodyPlan Plan, ulong Seed, float? LegLength, MotionCourse Course, string? LimitExcessJoint, string? JointSpeedJoint, CourseReport Report) : IMeasuredRun<MeasuredCourse>
{
    /// <inheritdoc/>
    public static IReadOnlyList<Measure<MeasuredCourse>> Measures => CourseMeasure.All;

    /// <inheritdoc/>
    public static IReadOnlyList<MeasureColumn<MeasuredCourse>> Columns => CourseMeasure.Columns;

    /// <inheritdoc/>
    public MeasureRow Row => new(Kind, FormattableString.Invariant($"{Course.Script} {Course.Rate}"), Ground);

    private string Ground => WordList<CourseGround>.Instance[Course.Ground];

    /// <summary>Measures a creature on all courses.</summary>
    /// <exception cref="InvalidOperationException">Its motion failed.</exception>
    public static IReadOnlyList<MeasuredCourse> AllOf(ulong seed, CreatureOptions options) =>
        Growing.Measure(seed, options, profile => MotionCourse.RunAll(profile).Select(run => Of(profile, run)));

    /// <summary>Measures a creature on the courses on one ground.</summary>
    /// <exception cref="InvalidOperationException">Its motion failed.</exception>
    public static IReadOnlyList<MeasuredCourse> AllOn(CourseGround ground, ulong seed, CreatureOptions options) =>
        Growing.Measure(seed, options, profile => MotionCourse.On(profile, ground).Select(course => Of(profile, (course, course.Run(profile)))));

    /// <inheritdoc/>
    public void WriteName(Utf8JsonWriter json)
    {
        json.WriteString("kind", WordList<LocomotionKind>.Instance[Kind]);
        json.WriteString("seed", SeedText.Of(Seed));
        json.WriteString("script", Course.Script.Name);
        json.WriteString("ground", Ground);
        if (Course.Rate.Hertz is float hertz)
        {
            json.WriteNumber("hertz", hertz);
        }
        else
        {
            json.WriteString("hertz", Course.Rate.ToString());
        }
    }

    /// <inheritdoc/>
    public void WriteFacts(Utf8JsonWriter json)
    {
        json.WriteString("plan", WordList<BodyPlan>.Instance[Plan]);
        JsonText.WriteNumber(json, "legLengthMetres", LegLength);
        json.WriteNumber("frames", Report.Frames);
        json.WriteNumber("seconds", Report.Seconds);
        json.WriteString("limitExcessMaxJoint", LimitExcessJoint);
        json.WriteString("jointSpeedMaxJoint", JointSpeedJoint);
        JsonText.WriteNumber(json, "stances", Report.Stances);
    }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant($"{WordList<LocomotionKind>.Instance[Kind]} {Seed} {WordList<BodyPlan>.Instance[Plan]} {Course.Script} {Ground} {Course.Rate} Hz");

    private static MeasuredCourse Of(MotionProfile profile, (MotionCourse Course, CourseReport Report) run)
    {
        CreatureBlueprint blueprint = profile.Subject.Creature!.Blueprint;
        return new MeasuredCourse(
            blueprint.Kind,
            blueprint.Plan,
            blueprint.Seed,
            profile.LegLength > 0f ? profile.LegLength : null,
            run.Course,
            Growing.JointName(profile, run.Report.LimitExcessJoint),
            Growing.JointName(profile, run.Report.JointSpeedJoint),
            run.Report);
    }
}
