using System;
using System.Collections.Generic;
using CreatureGen.Seeding;

namespace CreatureGen.Genetics.Populations;

/// <summary>MAP-Elites: the best creature of each niche lives, so that a population fills all the forms there can be instead of agreeing on one. It grows as niches are found.</summary>
/// <remarks>Based on: J.-B. Mouret and J. Clune, "Illuminating search spaces by mapping elites" (2015).</remarks>
public sealed class NicheSelection : ISelection
{
    /// <summary>Children by mutation alone. A child of two is between them; at the rim of all forms only mutation leads on.</summary>
    private const double Alone = 0.5;

    private readonly NicheGrid grid;

    /// <summary>Niches of size, legs and length.</summary>
    public NicheSelection()
        : this(NicheGrid.Default)
    {
    }

    /// <summary>Niches of one's own.</summary>
    public NicheSelection(NicheGrid grid) => this.grid = grid ?? throw new ArgumentNullException(nameof(grid));

    /// <inheritdoc/>
    public string Name => "niches";

    /// <inheritdoc/>
    public Couple Choose(Generation generation, RandomStream random)
    {
        _ = generation ?? throw new ArgumentNullException(nameof(generation));
        Individual first = Ranking.Tournament(generation.Individuals, 1, random);
        return new Couple(first, random.Chance(Alone) ? first : Ranking.Tournament(generation.Individuals, 1, random));
    }

    /// <inheritdoc/>
    public Generation Succeed(Generation generation, IReadOnlyList<Individual> children, int room)
    {
        _ = generation ?? throw new ArgumentNullException(nameof(generation));
        _ = children ?? throw new ArgumentNullException(nameof(children));
        var holders = new SortedDictionary<int, Individual>();
        foreach (Individual one in generation.Individuals)
        {
            Settle(holders, one);
        }

        foreach (Individual one in children)
        {
            Settle(holders, one);
        }

        return new Generation(generation.Number + 1, Ranking.ByScore(holders.Values), Array.Empty<Individual>());
    }

    private void Settle(SortedDictionary<int, Individual> holders, Individual one)
    {
        int niche = grid.Of(one.Measures);
        if (one.Verdict != Verdict.Freak && (!holders.TryGetValue(niche, out Individual? holder) || one.Score > holder.Score))
        {
            holders[niche] = one;
        }
    }
}
