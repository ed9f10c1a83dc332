using System;
using System.Collections.Generic;
using CreatureGen.Creatures;
using CreatureGen.Inspection;

namespace CreatureGen.Console;

/// <summary>The checks that creatures are put to.</summary>
/// <param name="Names">Names of the invariants, in the order of reports.</param>
/// <param name="Inspect">What a creature breaks.</param>
/// <param name="CountCrossings">How often the surface of a creature crosses itself.</param>
internal sealed record CreatureChecks(
    IReadOnlyList<string> Names,
    Func<Creature, IReadOnlyList<InvariantViolation>> Inspect,
    Func<Creature, SurfaceCrossings> CountCrossings)
{
    /// <summary>Those of the library.</summary>
    public static CreatureChecks OfLibrary { get; } = new(CreatureInspection.Invariants, CreatureInspection.Inspect, CreatureInspection.CountCrossings);
}
