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
/// Afterwards the surface is searched for places where it cuts through itself; where there are some it is put back to what it was, and the steps are taken once more without those that led there.
/// The order depends on nothing but the mesh, so that a coarse level is always a coarsening of a finer one.
/// </remarks>
internal sealed class MeshReduction : IDisposable
{
    /// <summary>Triangles by which the loss of a piece may leave fewer than were asked for.</summary>
    private const int LargestTooMuch = 100;

    private readonly CreatureMesh mesh;
    private readonly ReductionSubject subject;
    private readonly CollapsingMesh surface;
    private readonly ReductionCost cost;
    private readonly StepChoice choice;
    private readonly CrossingSearch crossings;
    private readonly CostOrder order;
    private readonly int[] twin;
    private readonly ReductionPieces pieces;
    private readonly ReductionRemap remap;

    // What may go, points by their number and pieces by theirs after those of the points, and what that costs: infinite for those that may not now. A point whose cost has to be worked out anew is stale.
    private readonly int[] candidates;
    private readonly float[] costs;
    private readonly int[] cheapest;
    private readonly bool[] stale;
    private int candidateCount;

    // Points that may not go, because the surface would cut through itself.
    private readonly bool[] held;
    private readonly bool[] changed;
    private readonly bool[] wereUsed;
    private readonly SavedArrays saved;
    private readonly List<(int From, int To)> pairs = new();
    private readonly List<(int From, int To)> twinPairs = new();

    // The steps that have been taken to the level that is made: what went, and for a point its neighbour.
    private readonly List<(int Item, int To)> taken = new();
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
        remap = new ReductionRemap(subject);
        pieces = new ReductionPieces(subject);
        held = new bool[subject.Points];
        wereUsed = new bool[subject.Points];
        changed = new bool[subject.Points];
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

        saved = new SavedArrays(pieces.Lost, stale, cheapest, costs, candidates);
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
        taken.Clear();
        TakeSteps(triangles);
        while (crossings.Find(surface) > 0 && HoldWhatLedThere())
        {
            Restore();
            TakeAgain();
            TakeSteps(triangles);
        }

        crossings.Inherit();
        for (int p = 0; p < held.Length; p++)
        {
            stale[p] |= held[p];
            held[p] = false;
        }
    }

    /// <summary>The mesh as it is now, over the same vertices.</summary>
    public CreatureLod ToLevel() => CreatureLod.Of(mesh, remap.Final(surface, pieces, choice), subject.PlaceOf);

    /// <summary>Gives borrowed memory back; nothing may be asked of it any more.</summary>
    public void Dispose()
    {
        cost.Dispose();
        crossings.Dispose();
        surface.Dispose();
        remap.Dispose();
        saved.Dispose();
    }

    /// <summary>Takes steps in rounds until no more than a number of triangles are left.</summary>
    private void TakeSteps(int triangles)
    {
        const int TrianglesOfStep = 4;
        bool goesOn = true;
        int before = Triangles + 1;
        while (Triangles > triangles && goesOn)
        {
            goesOn = Refresh();
            bool stuck = before == Triangles && !goesOn;
            before = Triangles;
            ReadOnlySpan<int> cheapestFirst = order.Sort(candidates.AsSpan(0, candidateCount), costs);
            int enough = (Triangles - triangles + TrianglesOfStep - 1) / TrianglesOfStep;

            // Some of them will not do or have to wait: a few more save a round.
            enough = Math.Min(cheapestFirst.Length, enough + (enough / 4) + 16);
            goesOn |= enough > 0;
            float limit = enough > 0 ? costs[cheapestFirst[enough - 1]] : 0f;
            for (int i = 0; i < enough && Triangles > triangles; i++)
            {
                int item = cheapestFirst[i];
                if (item >= subject.Points)
                {
                    // A piece that is far more than what has to go stays as long as points can go instead: a wing would be gone for the sake of a few triangles.
                    if (stuck || pieces.LeftOf(item - subject.Points, surface) <= Triangles - triangles + LargestTooMuch)
                    {
                        Lose(item);
                    }
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
                    cheapest[item] = choice.FindCheapest(item, out float leastCost);
                    costs[item] = held[item] ? float.PositiveInfinity : leastCost;
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
            float price = choice.CostOf(i);
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
        if (!surface.Allows(from, to))
        {
            return false;
        }

        int twinFrom = twin[from];
        int twinTo = twin[to];
        if (twinFrom == from)
        {
            Take(from, to);
            return true;
        }

        int before = surface.Triangles;
        choice.Match(from, to, pairs);
        surface.Collapse(from, to, pairs);
        if (!surface.Allows(twinFrom, twinTo))
        {
            surface.Undo();
            return false;
        }

        choice.Match(twinFrom, twinTo, twinPairs);
        surface.Collapse(twinFrom, twinTo, twinPairs);
        Accept(twinFrom, twinTo, twinPairs);
        Accept(from, to, pairs);
        Triangles -= before - surface.Triangles;
        return true;
    }

    /// <summary>Pulls a point that has no mirror image but itself onto a neighbour, where that is allowed.</summary>
    private void Take(int from, int to)
    {
        int before = surface.Triangles;
        choice.Match(from, to, pairs);
        surface.Collapse(from, to, pairs);
        Accept(from, to, pairs);
        Triangles -= (before - surface.Triangles) * pieces.SidesOf(subject.PieceOf[from]);
    }

    /// <summary>Removes a piece.</summary>
    private void Lose(int item)
    {
        Triangles -= pieces.Lose(item - subject.Points, surface);
        costs[item] = float.PositiveInfinity;
        taken.Add((item, -1));
    }

    /// <summary>Takes the steps once more that have been taken, without those of points that are held by now. What they cost need not be worked out again, and where the surface is as it was then nor whether they are allowed.</summary>
    private void TakeAgain()
    {
        Array.Clear(changed, 0, changed.Length);
        int count = taken.Count;
        for (int i = 0; i < count; i++)
        {
            (int item, int to) = taken[i];
            if (item >= subject.Points)
            {
                Lose(item);
            }
            else if (held[item])
            {
                MarkChanged(item);
            }
            else if (twin[item] == item && !changed[item] && !changed[to])
            {
                Take(item, to);
                Note(item, to);
            }
            else if (TryBoth(item, to))
            {
                Note(item, to);
                MarkChanged(to);
            }
            else
            {
                MarkChanged(item);
            }
        }

        taken.RemoveRange(0, count);
    }

    /// <summary>Marks a point and its neighbours as such that may have others around them than when the steps were first taken.</summary>
    private void MarkChanged(int point)
    {
        changed[point] = true;
        foreach (int n in surface.Neighbours(point))
        {
            changed[n] = true;
        }
    }

    private void Accept(int from, int to, List<(int From, int To)> matched)
    {
        cost.Merge(from, to);
        remap.Take(from, to, matched);
    }

    /// <summary>Gives the points around a step another chance: what the others cost has not changed.</summary>
    private void Note(int from, int to)
    {
        taken.Add((from, to));
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
        for (int p = 0; p < held.Length; p++)
        {
            if (!held[p] && subject.Side[p] >= 0 && wereUsed[p] && remap.HasGone(p) && (crossings.Touches(remap.PointFor(p)) || crossings.Touches(remap.PointFor(twin[p]))))
            {
                held[p] = true;
                any = true;
            }
        }

        return any;
    }

    private void Save()
    {
        savedTriangles = Triangles;
        savedCandidates = candidateCount;
        surface.Save();
        cost.Save();
        remap.Save();
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
        remap.Restore();
        saved.Restore();
        for (int p = 0; p < held.Length; p++)
        {
            costs[p] = held[p] ? float.PositiveInfinity : costs[p];
        }
    }
}
