using System;
using System.Collections.Generic;
using CreatureGen.Seeding;

namespace CreatureGen.Genetics.Populations;

/// <summary>Orders of creatures. What is equal keeps its order.</summary>
internal static class Ranking
{
    /// <summary>The creatures by their score, the best first.</summary>
    public static List<Individual> ByScore(IEnumerable<Individual> individuals)
    {
        var list = new List<Individual>(individuals);
        return By(list, list.ConvertAll(one => one.Score).ToArray());
    }

    /// <summary>The creatures by a number for each, the greatest first.</summary>
    public static List<Individual> By(IReadOnlyList<Individual> individuals, double[] merits)
    {
        var ranked = new List<Individual>(individuals.Count);
        foreach (int i in Order(merits))
        {
            ranked.Add(individuals[i]);
        }

        return ranked;
    }

    /// <summary>The places of numbers, the greatest first.</summary>
    public static int[] Order(double[] merits)
    {
        int[] order = new int[merits.Length];
        for (int i = 0; i < order.Length; i++)
        {
            order[i] = i;
        }

        Array.Sort(order, (a, b) => merits[a] != merits[b] ? merits[b].CompareTo(merits[a]) : a.CompareTo(b));
        return order;
    }

    /// <summary>The best of some that are drawn, of a list that is in order.</summary>
    public static Individual Tournament(IReadOnlyList<Individual> ranked, int size, RandomStream random)
    {
        int best = ranked.Count - 1;
        for (int i = 0; i < size; i++)
        {
            best = Math.Min(best, random.Integer(0, ranked.Count));
        }

        return ranked[best];
    }

    /// <summary>Adds to a list, in order, those of others that are not in it yet, up to a number.</summary>
    public static void Fill(List<Individual> list, IEnumerable<Individual> others, int room)
    {
        var known = new HashSet<ulong>();
        foreach (Individual one in list)
        {
            known.Add(one.Identity);
        }

        foreach (Individual one in others)
        {
            if (list.Count < room && known.Add(one.Identity))
            {
                list.Add(one);
            }
        }
    }
}
