using System;
using System.Collections.Generic;

namespace CreatureGen.Genetics.Populations;

/// <summary>A population at one time. Immutable.</summary>
public sealed class Generation
{
    /// <summary>Puts a population together.</summary>
    /// <param name="number">0 for the founders.</param>
    /// <param name="individuals">At least one.</param>
    /// <param name="archive">Creatures that are remembered without being part of it; only some ways of selection have any.</param>
    public Generation(int number, IReadOnlyList<Individual> individuals, IReadOnlyList<Individual> archive)
    {
        _ = individuals ?? throw new ArgumentNullException(nameof(individuals));
        if (individuals.Count == 0)
        {
            throw new ArgumentException("the population is empty; expected at least one creature", nameof(individuals));
        }

        Number = number >= 0 ? number : throw new ArgumentOutOfRangeException(nameof(number), number, "expected 0 or more");
        Individuals = individuals;
        Archive = archive ?? throw new ArgumentNullException(nameof(archive));
    }

    /// <summary>0 for the founders.</summary>
    public int Number { get; }

    /// <summary>Who lives, the best first; those that do equally well in the order in which they came.</summary>
    public IReadOnlyList<Individual> Individuals { get; }

    /// <summary>Who is remembered.</summary>
    public IReadOnlyList<Individual> Archive { get; }

    /// <summary>The one that does best.</summary>
    public Individual Best => Individuals[0];

    /// <summary>The score in the middle of all that were judged, the lower one of two; 0 if none was.</summary>
    public double Median
    {
        get
        {
            var scores = new List<double>();
            foreach (Individual one in Individuals)
            {
                if (one.Verdict == Verdict.Judged)
                {
                    scores.Add(one.Score);
                }
            }

            scores.Sort();
            return scores.Count == 0 ? 0 : scores[(scores.Count - 1) / 2];
        }
    }
}
