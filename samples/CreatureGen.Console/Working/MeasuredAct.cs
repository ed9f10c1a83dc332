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
using CreatureGen.Sampling;

namespace CreatureGen.Console.Working;

/// <summary>What came of measuring an act of a creature.</summary>
/// <param name="Kind">How the creature moves.</param>
/// <param name="Plan">How it carries its body.</param>
/// <param name="Seed">Its seed.</param>
/// <param name="Ability">The act.</param>
/// <param name="LimitExcessJoint">The joint that is farthest beyond its limits; null for none.</param>
/// <param name="JointSpeedJoint">The fastest joint; null for none.</param>
/// <param name="PenetrationJoint">The joint that carries the skin that is deepest in the ground; null for none.</param>
/// <param name="Report">The figures.</param>
internal sealed record MeasuredAct(LocomotionKind Kind, BodyPlan Plan, ulong Seed, ActAbility Ability, string? LimitExcessJoint, string? JointSpeedJoint, string? PenetrationJoint, ActReport Report) : IMeasuredRun<MeasuredAct>
{
    /// <inheritdoc/>
    public static IReadOnlyList<Measure<MeasuredAct>> Measures => ActMeasure.All;

    /// <inheritdoc/>
    public static IReadOnlyList<MeasureColumn<MeasuredAct>> Columns => ActMeasure.Columns;

    /// <inheritdoc/>
    public MeasureRow Row => new(Kind, Name, "flat");

    private string Name => MovementArguments.Hyphenated(Ability.Act.Name);

    /// <summary>Measures all that a creature can do.</summary>
    /// <exception cref="InvalidOperationException">Its motion failed.</exception>
    public static IReadOnlyList<MeasuredAct> AllOf(ulong seed, CreatureOptions options) =>
        Growing.Measure(seed, options, profile => ActTrial.Of(profile).Select(trial => Of(profile, trial)));

    /// <inheritdoc/>
    public void WriteName(Utf8JsonWriter json)
    {
        json.WriteString("kind", WordList<LocomotionKind>.Instance[Kind]);
        json.WriteString("seed", SeedText.Of(Seed));
        json.WriteString("act", Name);
    }

    /// <inheritdoc/>
    public void WriteFacts(Utf8JsonWriter json)
    {
        json.WriteString("plan", WordList<BodyPlan>.Instance[Plan]);
        json.WriteNumber("gain", Ability.Gain);
        json.WriteNumber("seconds", Report.Seconds);
        json.WriteString("limitExcessMaxJoint", LimitExcessJoint);
        json.WriteString("jointSpeedMaxJoint", JointSpeedJoint);
        json.WriteString("penetrationMaxJoint", PenetrationJoint);
    }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant($"{WordList<LocomotionKind>.Instance[Kind]} {Seed} {WordList<BodyPlan>.Instance[Plan]} {Name}");

    private static MeasuredAct Of(MotionProfile profile, ActTrial trial)
    {
        CreatureBlueprint blueprint = profile.Subject.Creature!.Blueprint;
        ActReport report = trial.Run(profile);
        return new MeasuredAct(blueprint.Kind, blueprint.Plan, blueprint.Seed, trial.Ability, Growing.JointName(profile, report.LimitExcessJoint), Growing.JointName(profile, report.JointSpeedJoint), Growing.JointName(profile, report.PenetrationJoint), report);
    }
}
