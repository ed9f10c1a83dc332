using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Sampling;

namespace CreatureGen;

/// <summary>The front door: from a seed to a finished creature in one call.</summary>
public static class CreatureGenerator
{
    /// <summary>The creature of a seed, of any kind.</summary>
    public static Creature Generate(ulong seed) => Generate(seed, CreatureOptions.Default);

    /// <summary>The creature of a seed within options.</summary>
    /// <exception cref="System.ArgumentException">The options are not valid, or no creature meets them; the message says why.</exception>
    public static Creature Generate(ulong seed, CreatureOptions options) => CreatureAssembler.Assemble(BlueprintSampler.Sample(seed, options));

    /// <summary>The creature of a blueprint.</summary>
    /// <exception cref="System.ArgumentException">The blueprint has problems; the message lists them all.</exception>
    public static Creature Build(CreatureBlueprint blueprint) => CreatureAssembler.Assemble(blueprint);
}
