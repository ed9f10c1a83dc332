using System;
using System.Collections.Concurrent;
using CreatureGen.Creatures;
using CreatureGen.Sampling;

namespace CreatureGen.Tests.Creatures;

/// <summary>Creatures that several tests look at, grown once: nobody can change one. There is room for so many; what is asked for later is grown each time.</summary>
internal static class GrownCreatures
{
    private const int Room = 160;

    private static readonly ConcurrentDictionary<(ulong Seed, CreatureOptions Options), Lazy<Creature>> grown = new();

    /// <summary>The creature of a seed.</summary>
    public static Creature Of(ulong seed, CreatureOptions options)
    {
        (ulong, CreatureOptions) key = (seed, options);
        return grown.TryGetValue(key, out Lazy<Creature>? known) ? known.Value
            : grown.Count < Room ? grown.GetOrAdd(key, asked => new Lazy<Creature>(() => CreatureGenerator.Generate(asked.Seed, asked.Options))).Value
            : CreatureGenerator.Generate(seed, options);
    }
}
