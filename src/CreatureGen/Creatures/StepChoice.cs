using System;
using System.Collections.Generic;
using CreatureGen.Geometry;

namespace CreatureGen.Creatures;

/// <summary>Says onto which of its neighbours a point is pulled at the least cost, and which vertices take the place of which when it is.</summary>
/// <param name="surface">The surface as it is reduced.</param>
/// <param name="cost">What steps cost.</param>
/// <param name="subject">What it is the surface of.</param>
internal sealed class StepChoice(CollapsingMesh surface, ReductionCost cost, ReductionSubject subject)
{
    private readonly float[] costs = new float[64];
    private readonly float[] shapes = new float[64];
    private readonly int[] offered = new int[64];
    private readonly List<int> ranked = new();
    private readonly List<int> vertices = new();
    private readonly List<(int From, int To)> pairs = new();

    /// <summary>The neighbours that <see cref="Rank"/> found, the cheapest first.</summary>
    public IReadOnlyList<int> Ranked => ranked;

    /// <summary>What it costs to pull the point onto one of <see cref="Ranked"/>.</summary>
    public float CostOf(int rank) => costs[rank];

    /// <summary>Finds the neighbour that <see cref="Rank"/> lists first, −1 when there is none. Four of six are ruled out by their shape alone, in a third of the time that weights, colours and texture take.</summary>
    public int FindCheapest(int point, out float leastCost)
    {
        int count = 0;
        foreach (int n in surface.Neighbours(point))
        {
            if (KeepsSides(point, n) && count < offered.Length)
            {
                offered[count++] = n;
            }
        }

        cost.Bound(point, offered.AsSpan(0, count), shapes, costs);
        int vertex = surface.OnlyVertexOf(point);
        for (int i = 0; vertex < 0 && i < count; i++)
        {
            costs[i] += surface.Tears(point, offered[i]) ? cost.OfTear(point) : 0f;
        }

        int first = 0;
        for (int i = 1; i < count; i++)
        {
            first = costs[i] < costs[first] ? i : first;
        }

        int best = -1;
        leastCost = float.PositiveInfinity;
        for (int i = -1; i < count; i++)
        {
            // What costs least by its shape comes first, so that most others fall short of it.
            int at = i < 0 ? first : i;
            if (i == first || at >= count || costs[at] > leastCost)
            {
                continue;
            }

            int n = offered[at];
            int other = surface.OnlyVertexOf(n);
            float price = vertex >= 0 && other >= 0 ? cost.OfPlain(point, n, shapes[at], vertex, other) : InFull(point, n, shapes[at]);
            if (price < leastCost || (price == leastCost && n < best))
            {
                leastCost = price;
                best = n;
            }
        }

        return best;
    }

    private float InFull(int point, int n, float shape)
    {
        bool torn = !Match(point, n, pairs);
        return cost.Of(point, n, shape, pairs, torn);
    }

    /// <summary>Whether a point stays on its side of the plane of symmetry, or on the plane, when it is pulled onto a neighbour.</summary>
    private bool KeepsSides(int point, int n) =>
        subject.Rim[point] ? subject.Rim[n] : subject.Twin[point] == point ? subject.Twin[n] == n : n != subject.Twin[point] && subject.Side[n] >= 0;

    /// <summary>Lists the neighbours onto which a point may be pulled, the cheapest first.</summary>
    public void Rank(int point)
    {
        ranked.Clear();
        foreach (int n in surface.Neighbours(point))
        {
            if (!KeepsSides(point, n) || ranked.Count == costs.Length)
            {
                continue;
            }

            float edgeCost = InFull(point, n, cost.ShapeOf(point, n));
            int at = ranked.Count;
            ranked.Add(n);
            while (at > 0 && (edgeCost < costs[at - 1] || (edgeCost == costs[at - 1] && n < ranked[at - 1])))
            {
                costs[at] = costs[at - 1];
                ranked[at] = ranked[at - 1];
                at--;
            }

            costs[at] = edgeCost;
            ranked[at] = n;
        }
    }

    /// <summary>Finds for each vertex of a point the one of a neighbour that takes its place: across the edge between them, or else the most alike. False when one is not across the edge.</summary>
    public bool Match(int from, int to, List<(int From, int To)> found)
    {
        if (surface.Match(from, to, found))
        {
            return true;
        }

        for (int i = 0; i < found.Count; i++)
        {
            (int vertex, int other) = found[i];
            found[i] = (vertex, other >= 0 ? other : MaxAlike(vertex, to));
        }

        return false;
    }

    /// <summary>The vertex of a point that looks most like another vertex.</summary>
    public int MaxAlike(int vertex, int point)
    {
        surface.VerticesOf(point, vertices);
        int best = vertices[0];
        foreach (int v in vertices)
        {
            best = cost.Difference(vertex, v) < cost.Difference(vertex, best) ? v : best;
        }

        return best;
    }
}
