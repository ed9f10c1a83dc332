using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Creatures;

/// <summary>
/// Takes triangles from a creature's mesh, those that matter least first, without moving a vertex: every vertex that goes points at one that stays.
/// </summary>
/// <remarks>
/// Points go one by one; small pieces that sit on the creature go as a whole when they cost less than another point. All is done on the left side, and the right is its image (<see cref="MirroredHalf"/>).
/// Steps are taken in rounds: all points that might go are put in the order of what that costs, and as many of the cheapest as are too many go, but those around which something changed in the same round, which wait for the next one.
/// Afterwards the surface is searched for places where it cuts through itself; where there are some it is put back to what it was, and without the steps that led there all is done again.
/// The order depends on nothing but the mesh, so that a coarse level is always a coarsening of a finer one.
/// </remarks>
internal sealed class MeshReduction : IDisposable
{
    private readonly CreatureMesh mesh;
    private readonly ReductionSubject subject;
    private readonly CollapsingMesh surface;
    private readonly ReductionCost cost;
    private readonly StepChoice choice;
    private readonly CrossingSearch crossings;
    private readonly CostOrder order;
    private readonly int[] twin;
    private readonly ReductionPieces pieces;
    private readonly int[] remap;
    private readonly int[] standsFor;

    // What may go, points by their number and pieces by theirs after those of the points, and what that costs: infinite for those that may not now. A point whose cost has to be worked out anew is stale.
    private readonly int[] candidates;
    private readonly float[] costs;
    private readonly int[] cheapest;
    private readonly bool[] stale;
    private int candidateCount;

    // Points that may not go, because the surface would cut through itself.
    private readonly bool[] held;
    private readonly bool[] wereUsed;
    private readonly SavedArrays saved;
    private readonly List<(int From, int To)> pairs = new();
    private readonly List<(int From, int To)> twinPairs = new();
    private int savedTriangles;
    private int savedCandidates;

    /// <summary>Prepares the reduction of a mesh; it is not changed.</summary>
    public MeshReduction(CreatureMesh mesh)
    {
        this.mesh = mesh;
        subject = new ReductionSubject(mesh);
        twin = subject.Twin;
        Triangles = mesh.Triangles.Length / 3;
        surface = new CollapsingMesh(subject.Positions, subject.Normals(), subject.Corners, subject.Vertices, subject.Rim);
        cost = new ReductionCost(mesh, subject);
        choice = new StepChoice(surface, cost, subject);
        crossings = new CrossingSearch(subject.Positions, subject.Corners, subject.PieceOf, subject.Box);
        remap = Identity(subject.PointOf.Length);
        standsFor = Identity(subject.Points);
        pieces = new ReductionPieces(subject);
        held = new bool[subject.Points];
        wereUsed = new bool[subject.Points];
        stale = new bool[subject.Points];
        cheapest = new int[subject.Points];
        costs = new float[subject.Points + pieces.Lost.Length];
        candidates = new int[costs.Length];
        order = new CostOrder(costs.Length);
        for (int p = 0; p < subject.Points; p++)
        {
            stale[p] = subject.Side[p] >= 0;
            candidates[candidateCount] = p;
            candidateCount += stale[p] ? 1 : 0;
        }

        for (int piece = 0; piece < pieces.Lost.Length; piece++)
        {
            int item = subject.Points + piece;
            costs[item] = pieces.LossOf(piece, cost);
            candidates[candidateCount] = item;
            candidateCount += float.IsInfinity(costs[item]) ? 0 : 1;
        }

        saved = new SavedArrays(remap, standsFor, pieces.Lost, stale, cheapest, costs, candidates);
    }

    /// <summary>Triangles that are left.</summary>
    public int Triangles { get; private set; }

    /// <summary>Takes triangles away until no more than a number are left, or nothing can go without damage.</summary>
    public void ReduceTo(int triangles)
    {
        if (Triangles <= triangles)
        {
            return;
        }

        Save();
        TakeSteps(triangles);
        while (crossings.Find(surface) > 0 && HoldWhatLedThere())
        {
            Restore();
            TakeSteps(triangles);
        }

        for (int p = 0; p < held.Length; p++)
        {
            stale[p] |= held[p];
            held[p] = false;
        }
    }

    /// <summary>The mesh as it is now, over the same vertices.</summary>
    public CreatureLod ToLevel() => CreatureLod.Of(mesh, FinalRemap(), subject.PlaceOf);

    /// <summary>Gives borrowed memory back; nothing may be asked of it any more.</summary>
    public void Dispose()
    {
        cost.Dispose();
        crossings.Dispose();
    }

    private static int[] Identity(int count)
    {
        int[] identity = new int[count];
        for (int i = 0; i < count; i++)
        {
            identity[i] = i;
        }

        return identity;
    }

    /// <summary>Takes steps in rounds until no more than a number of triangles are left.</summary>
    private void TakeSteps(int triangles)
    {
        const int TrianglesOfStep = 4;
        bool goesOn = true;
        while (Triangles > triangles && goesOn)
        {
            goesOn = Refresh();
            ReadOnlySpan<int> cheapestFirst = order.Sort(candidates.AsSpan(0, candidateCount), costs);
            int enough = Math.Min(cheapestFirst.Length, (Triangles - triangles + TrianglesOfStep - 1) / TrianglesOfStep);
            goesOn |= enough > 0;
            float limit = enough > 0 ? costs[cheapestFirst[enough - 1]] : 0f;
            for (int i = 0; i < enough && Triangles > triangles; i++)
            {
                int item = cheapestFirst[i];
                if (item >= subject.Points)
                {
                    Triangles -= pieces.Lose(item - subject.Points, surface);
                    costs[item] = float.PositiveInfinity;
                }
                else if (!stale[item])
                {
                    Step(item, limit);
                }
            }
        }
    }

    /// <summary>Works out anew what the points cost around which something has changed, and forgets those that have gone. False when nothing has changed.</summary>
    private bool Refresh()
    {
        bool any = false;
        int kept = 0;
        for (int i = 0; i < candidateCount; i++)
        {
            int item = candidates[i];
            if (item < subject.Points)
            {
                if (!surface.IsUsed(item))
                {
                    continue;
                }

                if (stale[item])
                {
                    stale[item] = false;
                    any = true;
                    cheapest[item] = choice.FindCheapest(item, out double leastCost);
                    costs[item] = held[item] ? float.PositiveInfinity : (float)leastCost;
                }
            }

            candidates[kept++] = item;
        }

        candidateCount = kept;
        return any;
    }

    /// <summary>Pulls a point onto the neighbour for which that costs least of those that will do; sets it aside where none will, or where that costs more than a limit.</summary>
    private void Step(int point, float limit)
    {
        if (!surface.IsUsed(point))
        {
            costs[point] = float.PositiveInfinity;
            return;
        }

        if (TryBoth(point, cheapest[point]))
        {
            Note(point, cheapest[point]);
            return;
        }

        choice.Rank(point);
        float tried = costs[point];
        for (int i = 0; i < choice.Ranked.Count; i++)
        {
            int to = choice.Ranked[i];
            float price = (float)choice.CostOf(i);
            if (price > limit && price > tried)
            {
                cheapest[point] = to;
                costs[point] = price;
                return;
            }

            if (to != cheapest[point] && TryBoth(point, to))
            {
                Note(point, to);
                return;
            }
        }

        costs[point] = float.PositiveInfinity;
    }

    /// <summary>Pulls a point onto a neighbour, and in pieces of which both sides are there the mirror image of the one onto that of the other; both or none.</summary>
    private bool TryBoth(int from, int to)
    {
        int twinFrom = twin[from];
        int twinTo = twin[to];
        int before = surface.Triangles;
        surface.Prune(to);
        if (!surface.Allows(from, to))
        {
            return false;
        }

        surface.Prune(twinFrom);
        surface.Prune(twinTo);
        choice.Match(from, to, pairs);
        surface.Collapse(from, to, pairs);
        if (twinFrom != from)
        {
            if (!surface.Allows(twinFrom, twinTo))
            {
                surface.Undo();
                return false;
            }

            choice.Match(twinFrom, twinTo, twinPairs);
            surface.Collapse(twinFrom, twinTo, twinPairs);
            Accept(twinFrom, twinTo, twinPairs);
        }

        Accept(from, to, pairs);
        Triangles -= (before - surface.Triangles) * pieces.SidesOf(subject.PieceOf[from]);
        return true;
    }

    private void Accept(int from, int to, List<(int From, int To)> taken)
    {
        cost.Merge(from, to);
        standsFor[from] = to;
        foreach ((int vertex, int other) in taken)
        {
            remap[vertex] = other;
        }
    }

    /// <summary>Gives the points around a step another chance: what the others cost has not changed.</summary>
    private void Note(int from, int to)
    {
        NoteAround(from, to);
        if (twin[from] != from)
        {
            NoteAround(twin[from], twin[to]);
        }
    }

    private void NoteAround(int from, int to)
    {
        costs[from] = float.PositiveInfinity;
        stale[to] = true;
        foreach (int n in surface.Neighbours(to))
        {
            stale[n] |= cheapest[n] == from || float.IsInfinity(costs[n]);
        }
    }

    /// <summary>Holds the points that went where the surface now cuts through itself. False when all of them were held already: then it did so before.</summary>
    private bool HoldWhatLedThere()
    {
        bool any = false;
        for (int p = 0; p < standsFor.Length; p++)
        {
            if (!held[p] && subject.Side[p] >= 0 && wereUsed[p] && standsFor[p] != p && (crossings.Touches(End(p, standsFor)) || crossings.Touches(End(twin[p], standsFor))))
            {
                held[p] = true;
                any = true;
            }
        }

        return any;
    }

    /// <summary>For each vertex of the mesh the one that stands for it, −1 when its piece is lost.</summary>
    private int[] FinalRemap()
    {
        bool[] used = new bool[remap.Length];
        for (int c = 0; c < subject.Vertices.Length; c++)
        {
            used[subject.Vertices[c]] |= !surface.IsGone(c / 3);
        }

        int[] final = new int[remap.Length];
        for (int v = 0; v < final.Length; v++)
        {
            final[v] = v;
            if (subject.PointOf[v] >= 0)
            {
                int point = End(subject.PointOf[v], standsFor);

                // The last triangle of a vertex may have gone while its point stayed with others.
                int at = End(v, remap);
                final[v] = pieces.Lost[subject.PieceOf[point]] ? -1 : used[at] ? at : choice.MaxAlike(v, point);
            }
        }

        int[] images = subject.Half.Image;
        for (int v = 0; v < final.Length; v++)
        {
            if (images[v] >= 0 && images[v] != v)
            {
                final[images[v]] = final[v] < 0 ? -1 : images[final[v]];
            }
        }

        return final;
    }

    private void Save()
    {
        savedTriangles = Triangles;
        savedCandidates = candidateCount;
        surface.Save();
        cost.Save();
        saved.Save();
        for (int p = 0; p < wereUsed.Length; p++)
        {
            wereUsed[p] = surface.IsUsed(p);
        }
    }

    private void Restore()
    {
        Triangles = savedTriangles;
        candidateCount = savedCandidates;
        surface.Restore();
        cost.Restore();
        saved.Restore();
        for (int p = 0; p < held.Length; p++)
        {
            costs[p] = held[p] ? float.PositiveInfinity : costs[p];
        }
    }

    private static int End(int at, int[] chain)
    {
        while (chain[at] != at)
        {
            at = chain[at];
        }

        return at;
    }
}
