using System;
using System.Collections;
using System.Collections.Generic;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Arguments;

/// <summary>One creature that was asked for.</summary>
/// <param name="Seed">The seed of its species.</param>
/// <param name="Individual">Which individual of the species; null for the species' type.</param>
internal readonly record struct Specimen(ulong Seed, ulong? Individual)
{
    /// <summary>What its files are called after: the seed, and after a dash the individual.</summary>
    public string Name => Individual is ulong individual ? SeedText.Of(Seed) + "-" + SeedText.Of(individual) : SeedText.Of(Seed);

    /// <summary>The options that make it.</summary>
    public CreatureOptions Of(CreatureOptions options) => options with { Individual = Individual };
}

/// <summary>Creatures in the order in which they were asked for: of each seed all individuals. They are counted off, never stored.</summary>
/// <param name="seeds">The seeds.</param>
/// <param name="individuals">The individuals of each; null for the types alone.</param>
internal sealed class SpecimenList(SeedList seeds, SeedList? individuals) : IEnumerable<Specimen>
{
    /// <summary>The seeds.</summary>
    public SeedList Seeds => seeds;

    /// <summary>The individuals of each; null for the types alone.</summary>
    public SeedList? Individuals => individuals;

    /// <summary>Number of creatures, or the greatest number that there is when there are more.</summary>
    public UInt128 Count
    {
        get
        {
            UInt128 each = individuals?.Count ?? UInt128.One;
            return seeds.Count > UInt128.MaxValue / each ? UInt128.MaxValue : seeds.Count * each;
        }
    }

    /// <inheritdoc/>
    public IEnumerator<Specimen> GetEnumerator()
    {
        foreach (ulong seed in seeds)
        {
            if (individuals is null)
            {
                yield return new Specimen(seed, null);
                continue;
            }

            foreach (ulong individual in individuals)
            {
                yield return new Specimen(seed, individual);
            }
        }
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
}
