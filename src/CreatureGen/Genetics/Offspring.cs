using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Repairs;

namespace CreatureGen.Genetics;

/// <summary>A child.</summary>
/// <param name="Creature">The child, sound.</param>
/// <param name="Repairs">What had to be changed until it was sound; empty for most.</param>
/// <param name="Attempts">How many children of these parents were tried before this one, this one included.</param>
public sealed record Offspring(Creature Creature, IReadOnlyList<RepairChange> Repairs, int Attempts)
{
    /// <summary>Its blueprint, with its lineage.</summary>
    public CreatureBlueprint Blueprint => Creature.Blueprint;
}
