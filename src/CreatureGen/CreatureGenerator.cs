using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Sampling;

namespace CreatureGen;

/// <summary>The front door: from a seed to a finished creature in one call.</summary>
public static class CreatureGenerator
{
    /// <summary>The creature of a seed, of any kind.</summary>
    public static Creature Generate(ulong seed) => CreatureAssembler.Assemble(BlueprintSampler.Sample(seed, null));

    /// <summary>The creature of a blueprint.</summary>
    /// <exception cref="System.ArgumentException">The blueprint has problems; the message lists them all.</exception>
    public static Creature Build(CreatureBlueprint blueprint) => CreatureAssembler.Assemble(blueprint);
}
