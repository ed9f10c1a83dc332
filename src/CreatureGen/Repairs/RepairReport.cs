using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;

namespace CreatureGen.Repairs;

/// <summary>What came of a repair.</summary>
/// <param name="Blueprint">The blueprint now; the one that was given if nothing was wrong with it.</param>
/// <param name="Creature">The creature that it builds.</param>
/// <param name="Changes">What was changed and why, in the order of the repair; a field that was changed again and again is told once, with its first and last value.</param>
/// <param name="Violations">What is broken still; empty for a sound creature.</param>
public sealed record RepairReport(CreatureBlueprint Blueprint, Creature Creature, IReadOnlyList<RepairChange> Changes, IReadOnlyList<InvariantViolation> Violations)
{
    /// <summary>Whether the creature keeps all promises.</summary>
    public bool IsSound => Violations.Count == 0;
}
