using System;
using System.Collections.Generic;
using CreatureGen.Seeding;

namespace CreatureGen.Genetics.Populations;

/// <summary>Each parent is the best of some that are drawn; the best of a generation live on among their children.</summary>
/// <remarks>Source: D. E. Goldberg and K. Deb, "A comparative analysis of selection schemes used in genetic algorithms" (1991); elitism: K. A. De Jong (1975).</remarks>
public sealed class TournamentSelection : ISelection
{
    /// <summary>Draws for a second parent that is not the first.</summary>
    private const int Draws = 4;

    private readonly int size;
    private readonly int elites;

    /// <summary>Three in a tournament, four that live on.</summary>
    public TournamentSelection()
        : this(3, 4)
    {
    }

    /// <summary>Sets how hard it is to become a parent.</summary>
    /// <param name="size">Creatures of a tournament, at least 1; 1 is chance alone.</param>
    /// <param name="elites">Creatures that live on, at least 0; of a small population half at most.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public TournamentSelection(int size, int elites)
    {
        this.size = size >= 1 ? size : throw new ArgumentOutOfRangeException(nameof(size), size, "expected at least 1");
        this.elites = elites >= 0 ? elites : throw new ArgumentOutOfRangeException(nameof(elites), elites, "expected at least 0");
    }

    /// <inheritdoc/>
    public string Name => "tournament";

    /// <inheritdoc/>
    public Couple Choose(Generation generation, RandomStream random)
    {
        _ = generation ?? throw new ArgumentNullException(nameof(generation));
        Individual first = Ranking.Tournament(generation.Individuals, size, random);
        Individual second = first;
        for (int draw = 0; draw < Draws && second.Identity == first.Identity; draw++)
        {
            second = Ranking.Tournament(generation.Individuals, size, random);
        }

        return new Couple(first, second);
    }

    /// <inheritdoc/>
    public Generation Succeed(Generation generation, IReadOnlyList<Individual> children, int room)
    {
        _ = generation ?? throw new ArgumentNullException(nameof(generation));
        List<Individual> old = Ranking.ByScore(generation.Individuals);
        List<Individual> next = old.GetRange(0, Math.Min(Math.Min(elites, room / 2), old.Count));
        Ranking.Fill(next, Ranking.ByScore(children), room);
        Ranking.Fill(next, old, room);
        return new Generation(generation.Number + 1, Ranking.ByScore(next), Array.Empty<Individual>());
    }
}
