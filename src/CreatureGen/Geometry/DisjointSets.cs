using System;

namespace CreatureGen.Geometry;

/// <summary>Disjoint sets of the numbers 0..n−1 in a caller's buffer.</summary>
/// <remarks>Based on: R. E. Tarjan and J. van Leeuwen 1984, "Worst-case analysis of set union algorithms" (path halving; the lower number leads).</remarks>
internal readonly ref struct DisjointSets
{
    private readonly Span<int> parents;

    /// <summary>Puts each number in a set of its own.</summary>
    public DisjointSets(Span<int> parents)
    {
        this.parents = parents;
        for (int i = 0; i < parents.Length; i++)
        {
            parents[i] = i;
        }
    }

    /// <summary>Joins two sets. One when they were two, zero when they were the same.</summary>
    public int Join(int a, int b)
    {
        a = Root(a);
        b = Root(b);
        if (a == b)
        {
            return 0;
        }

        parents[Math.Max(a, b)] = Math.Min(a, b);
        return 1;
    }

    /// <summary>Lets each number in the caller's buffer be the one that stands for its set: lower numbers lead, so that one pass upwards does it.</summary>
    public void Flatten()
    {
        for (int i = 0; i < parents.Length; i++)
        {
            parents[i] = parents[parents[i]];
        }
    }

    /// <summary>The number that stands for the set of another: equal for two numbers of one set.</summary>
    public int Root(int i)
    {
        while (parents[i] != i)
        {
            i = parents[i] = parents[parents[i]];
        }

        return i;
    }
}
