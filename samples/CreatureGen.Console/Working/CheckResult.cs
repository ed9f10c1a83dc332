using System.Collections.Generic;
using CreatureGen.Creatures;
using CreatureGen.Inspection;

namespace CreatureGen.Console.Working;

/// <summary>What the checks say of a creature.</summary>
/// <param name="Names">Names of all invariants that were checked.</param>
/// <param name="Violations">What is broken; empty for a good creature.</param>
/// <param name="Crossings">How often the surface crosses itself.</param>
internal sealed record CheckResult(IReadOnlyList<string> Names, IReadOnlyList<InvariantViolation> Violations, SurfaceCrossings Crossings)
{
    /// <summary>Checks a creature.</summary>
    public static CheckResult Of(Creature creature, CreatureChecks checks) => new(checks.Names, checks.Inspect(creature), checks.CountCrossings(creature));
}
