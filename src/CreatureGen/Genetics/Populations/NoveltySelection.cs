using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Genetics.Criteria;
using CreatureGen.Seeding;

namespace CreatureGen.Genetics.Populations;

/// <summary>
/// Who is least like all others and like what was there before lives on; the goal only says which few are kept beside them. Finds what a direct way does not come by.
/// </summary>
/// <remarks>Based on: J. Lehman and K. O. Stanley, "Abandoning objectives: evolution through the search for novelty alone" (2011).</remarks>
public sealed class NoveltySelection : ISelection
{
    private const int Neighbours = 15;
    private const int Elites = 2;

    /// <summary>Creatures that each generation adds to the archive.</summary>
    private const int Remembered = 4;

    /// <inheritdoc/>
    public string Name => "novelty";

    /// <inheritdoc/>
    public Couple Choose(Generation generation, RandomStream random)
    {
        _ = generation ?? throw new ArgumentNullException(nameof(generation));
        return new Couple(Ranking.Tournament(generation.Individuals, 1, random), Ranking.Tournament(generation.Individuals, 1, random));
    }

    /// <inheritdoc/>
    public Generation Succeed(Generation generation, IReadOnlyList<Individual> children, int room)
    {
        _ = generation ?? throw new ArgumentNullException(nameof(generation));
        var all = new List<Individual>();
        Ranking.Fill(all, generation.Individuals, int.MaxValue);
        Ranking.Fill(all, children, int.MaxValue);
        all = all.FindAll(one => one.Verdict != Verdict.Freak) is { Count: > 0 } sound ? sound : all;
        List<Individual> novel = Ranking.By(all, Novelties(all, generation.Archive));
        List<Individual> next = Ranking.ByScore(all).GetRange(0, Math.Min(Elites, Math.Min(room, all.Count)));
        Ranking.Fill(next, novel, room);
        var archive = new List<Individual>(generation.Archive);
        Ranking.Fill(archive, novel, generation.Archive.Count + Remembered);
        return new Generation(generation.Number + 1, Ranking.ByScore(next), archive);
    }

    /// <summary>How far each is from its nearest neighbours among all and in the archive.</summary>
    private static double[] Novelties(List<Individual> all, IReadOnlyList<Individual> archive)
    {
        var novelties = new double[all.Count];
        for (int i = 0; i < novelties.Length; i++)
        {
            ulong own = all[i].Identity;
            var others = new List<CreatureBlueprint>();
            foreach (Individual one in all)
            {
                Add(one);
            }

            foreach (Individual one in archive)
            {
                Add(one);
            }

            novelties[i] = DistinctnessCriterion.Sparseness(all[i].Blueprint, others, Neighbours);

            void Add(Individual one)
            {
                if (one.Identity != own)
                {
                    others.Add(one.Blueprint);
                }
            }
        }

        return novelties;
    }
}
