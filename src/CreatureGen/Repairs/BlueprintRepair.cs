using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;

namespace CreatureGen.Repairs;

/// <summary>
/// Changes a blueprint as little as it finds necessary until its creature keeps all promises: first what needs no building (fields out of range, parts that do not fit together),
/// then, by building and inspecting, how it stands, how it balances, and what tears its surface.
/// </summary>
/// <remarks>The same blueprint is always repaired in the same way. What is sound is left as it is, to the last digit.</remarks>
public static class BlueprintRepair
{
    /// <summary>Creatures that are built at most.</summary>
    public const int MaxRounds = 24;

    /// <summary>Rounds of raising and shifting; a creature that does not stand after them is too extreme.</summary>
    private const int StanceRounds = 10;

    /// <summary>Round from which on fliers and swimmers do without standing.</summary>
    private const int HangingRound = MaxRounds - 4;

    /// <summary>Repairs a blueprint.</summary>
    /// <exception cref="ArgumentNullException">The blueprint is null.</exception>
    public static RepairReport Repair(CreatureBlueprint blueprint)
    {
        var log = new RepairLog(blueprint ?? throw new ArgumentNullException(nameof(blueprint)));
        if (BlueprintValidator.Validate(blueprint).Count > 0)
        {
            PartRemedies.Apply(log);
        }

        Creature creature = CreatureAssembler.Assemble(log.Blueprint);
        IReadOnlyList<InvariantViolation> violations = CreatureInspection.Inspect(creature);
        for (int round = 0; round < MaxRounds && violations.Count > 0 && Treat(log, creature, violations, round); round++)
        {
            creature = CreatureAssembler.Assemble(log.Blueprint);
            violations = CreatureInspection.Inspect(creature);
        }

        return new RepairReport(log.Blueprint, creature, log.Changes, violations);
    }

    /// <summary>Treats the surface and the stance in turns, since each may be the cause of the other. False if nothing is left to try.</summary>
    private static bool Treat(RepairLog log, Creature creature, IReadOnlyList<InvariantViolation> violations, int round)
    {
        InvariantViolation? torn = null;
        InvariantViolation? stance = null;
        foreach (InvariantViolation violation in violations)
        {
            bool stands = violation.Invariant is CreatureInspection.Grounded or CreatureInspection.Balanced;
            torn ??= stands ? null : violation;
            stance ??= stands ? violation : null;
        }

        bool surfaceFirst = stance is null || (torn != null && round % 2 == 0);
        return surfaceFirst
            ? SurfaceRemedy.Apply(log, torn!, round) || (stance != null && Stand(log, creature, stance, round))
            : Stand(log, creature, stance!, round) || (torn != null && SurfaceRemedy.Apply(log, torn, round));
    }

    private static bool Stand(RepairLog log, Creature creature, InvariantViolation violation, int round)
    {
        if (log.Blueprint.Plan == BodyPlan.Legless && violation.Invariant == CreatureInspection.Grounded && SurfaceRemedy.Apply(log, violation, round))
        {
            // What lies on the ground cannot be raised off it: what sticks out below goes.
            return true;
        }

        if (round >= HangingRound && HangingRemedy.Apply(log))
        {
            return true;
        }

        bool plainer = round >= StanceRounds && round % 2 == 0 && log.Blueprint.Plan != BodyPlan.Legless;
        return (plainer && PlainRemedy.Apply(log, violation))
            || (violation.Invariant == CreatureInspection.Grounded ? GroundRemedy.Apply(log, creature, round) : BalanceRemedy.Apply(log, creature, round))
            || PlainRemedy.Apply(log, violation);
    }
}
