using System;
using System.Collections.Generic;
using System.Text.Json;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Text;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Working;

/// <summary>Which creature did what, on what ground, at how many updates per second.</summary>
internal sealed record RunName(LocomotionKind Kind, ulong Seed, string Gait, GroundRelief Ground, float Hertz)
{
    /// <summary>In words.</summary>
    public override string ToString() => FormattableString.Invariant($"{WordList<LocomotionKind>.Instance[Kind]} {Seed} {Gait} {WordList<GroundRelief>.Instance[Ground]} {Hertz} Hz");
}

/// <summary>What came of measuring one trial.</summary>
/// <param name="Name">Which.</param>
/// <param name="Plan">How the creature carries its body.</param>
/// <param name="Speed">Metres per second that were asked for.</param>
/// <param name="LegLength">Metres; null for a creature without legs to stand on.</param>
/// <param name="WorstJoint">The joint that is farthest beyond its limits; null for none.</param>
/// <param name="Report">The figures.</param>
internal sealed record MeasuredRun(RunName Name, BodyPlan Plan, float Speed, float? LegLength, string? WorstJoint, MotionReport Report) : IMeasuredRun<MeasuredRun>
{
    /// <inheritdoc/>
    public static IReadOnlyList<Measure<MeasuredRun>> Measures => MotionMeasure.All;

    /// <inheritdoc/>
    public static IReadOnlyList<MeasureColumn<MeasuredRun>> Columns => MotionMeasure.Columns;

    /// <inheritdoc/>
    public MeasureRow Row => new(Name.Kind, Name.Gait, WordList<GroundRelief>.Instance[Name.Ground]);

    /// <summary>Measures all that a creature does.</summary>
    /// <exception cref="InvalidOperationException">Its motion failed.</exception>
    public static IReadOnlyList<MeasuredRun> AllOf(ulong seed, CreatureOptions options)
    {
        CreatureBlueprint blueprint = Growing.Sample(seed, options);
        Creature creature = CreatureAssembler.Assemble(blueprint);
        var profile = new MotionProfile(creature);
        var runs = new List<MeasuredRun>();
        foreach (MotionTrial trial in MotionTrial.Of(profile))
        {
            runs.Add(Of(trial, profile));
        }

        return runs;
    }

    /// <inheritdoc/>
    public void WriteName(Utf8JsonWriter json)
    {
        json.WriteString("kind", WordList<LocomotionKind>.Instance[Name.Kind]);
        json.WriteString("seed", SeedText.Of(Name.Seed));
        json.WriteString("gait", Name.Gait);
        json.WriteString("ground", WordList<GroundRelief>.Instance[Name.Ground]);
        json.WriteNumber("hertz", Name.Hertz);
    }

    /// <inheritdoc/>
    public void WriteFacts(Utf8JsonWriter json)
    {
        json.WriteString("plan", WordList<BodyPlan>.Instance[Plan]);
        json.WriteNumber("speedMetresPerSecond", Speed);
        JsonText.WriteNumber(json, "legLengthMetres", LegLength);
        json.WriteString("limitExcessMaxJoint", WorstJoint);
        json.WriteNumber("frames", Report.Frames);
        json.WriteNumber("seconds", Report.Seconds);
    }

    /// <inheritdoc/>
    public override string ToString() => Name.ToString();

    private static MeasuredRun Of(MotionTrial trial, MotionProfile profile)
    {
        CreatureBlueprint blueprint = profile.Subject.Creature!.Blueprint;
        var name = new RunName(blueprint.Kind, blueprint.Seed, trial.Movement.GaitName, trial.Relief, trial.Hertz);
        try
        {
            MotionReport report = trial.Run(profile);
            string? joint = report.WorstJoint < 0 ? null : profile.Subject.Skeleton.Joints[report.WorstJoint].Name;
            return new MeasuredRun(name, blueprint.Plan, trial.Movement.Input.Speed, profile.LegLength > 0f ? profile.LegLength : null, joint, report);
        }
        catch (ArgumentException problem)
        {
            // Nothing that a trial is made of comes from outside.
            throw new InvalidOperationException($"{name}: {problem.Message}", problem);
        }
    }
}
