using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Creatures;
using CreatureGen.Motion;
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
internal sealed record MeasuredRun(RunName Name, BodyPlan Plan, float Speed, float? LegLength, string? WorstJoint, MotionReport Report)
{
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

    private static MeasuredRun Of(MotionTrial trial, MotionProfile profile)
    {
        CreatureBlueprint blueprint = profile.Creature.Blueprint;
        var name = new RunName(blueprint.Kind, blueprint.Seed, trial.Movement.GaitName, trial.Relief, trial.Hertz);
        try
        {
            MotionReport report = trial.Run(profile);
            string? joint = report.WorstJoint < 0 ? null : profile.Creature.Skeleton.Joints[report.WorstJoint].Name;
            return new MeasuredRun(name, blueprint.Plan, trial.Movement.Input.Speed, profile.LegLength > 0f ? profile.LegLength : null, joint, report);
        }
        catch (ArgumentException problem)
        {
            // Nothing that a trial is made of comes from outside.
            throw new InvalidOperationException($"{name}: {problem.Message}", problem);
        }
    }
}
