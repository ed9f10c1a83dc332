using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
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

    /// <summary>
    /// The creature of a blueprint wherever it comes from, edited, crossed or read: it keeps everything that the library promises of creatures, or there is none. The look costs about a fifth of the time;
    /// <see cref="CreatureAssembler.Assemble(CreatureBlueprint)"/> builds without it.
    /// </summary>
    /// <exception cref="UnsoundCreatureException">The creature that it gives does not stand, balance or close; the message says all that is broken, and <see cref="Repairs.BlueprintRepair"/> may mend it.</exception>
    /// <exception cref="System.ArgumentException">The blueprint has problems; the message lists them all.</exception>
    public static Creature Build(CreatureBlueprint blueprint)
    {
        Creature creature = CreatureAssembler.Assemble(blueprint);
        IReadOnlyList<InvariantViolation> violations = CreatureInspection.Inspect(creature);
        return violations.Count == 0 ? creature : throw new UnsoundCreatureException(violations, nameof(blueprint));
    }
}
