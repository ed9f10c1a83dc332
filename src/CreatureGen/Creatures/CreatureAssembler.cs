using System;
using CreatureGen.Blueprints;

namespace CreatureGen.Creatures;

/// <summary>Builds creatures from blueprints: runs the stages in order and nothing else. The same blueprint gives the same creature, bit for bit.</summary>
public static class CreatureAssembler
{
    /// <summary>Builds a creature.</summary>
    /// <exception cref="ArgumentException">The blueprint has problems; the message lists them all.</exception>
    public static Creature Assemble(CreatureBlueprint blueprint) => Assemble(blueprint, null);

    /// <summary>Builds a creature and tells an observer after each stage.</summary>
    /// <exception cref="ArgumentException">The blueprint has problems; the message lists them all.</exception>
    public static Creature Assemble(CreatureBlueprint blueprint, IAssemblyObserver? observer) => throw new NotImplementedException();
}
