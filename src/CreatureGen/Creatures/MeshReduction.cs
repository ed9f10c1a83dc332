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
/// Points go one by one, together with their mirror images; small pieces that sit on the creature go as a whole when they cost less than another point.
/// The order depends on nothing but the mesh, so that a coarse level is always a coarsening of a finer one.
/// </remarks>
internal sealed class MeshReduction : IDisposable
{
    private readonly CreatureMesh mesh;
    private readonly CollapsingMesh surface;
    private readonly ReductionCost cost;
    private readonly Vector3[] positions;
    private readonly int[] corners;
    private readonly int[] vertices;
    private readonly int[] pointOf;
    private readonly int[] twin;
    private readonly sbyte[] side;
    private readonly int[] pieceOf;
    private readonly bool[] lostPieces;
    private readonly int[] remap;
    private readonly int[] standsFor;
    private readonly CostQueue queue;
    private readonly bool[] queued;

    // The neighbour that was found to cost least for a point, or −1 once something around the point has changed: spares looking for it a second time when its turn comes.
    private readonly int[] cheapest;
    private readonly StepChoice choice;
    private readonly List<int> neighbours = new();
    private readonly List<int> around = new();
    private readonly List<(int From, int To)> pairs = new();
    private readonly List<(int From, int To)> twinPairs = new();

    private readonly List<int> moved = new();
    private readonly List<int> lost = new();
    private readonly List<int> twinMoved = new();
    private readonly List<int> twinLost = new();

    // Of each piece whether its triangles are not mirrored, so that a step that crosses nothing may do so on the other side.
    private readonly bool[] lopsided;
    private CrossingGuard? guard;

    /// <summary>Prepares the reduction of a mesh; it is not changed.</summary>
    public MeshReduction(CreatureMesh mesh)
    {
        this.mesh = mesh;
        VertexWelding welding = VertexWelding.Weld(mesh.Positions);
        pointOf = welding.NewIndex.ToArray();
        positions = welding.Positions.ToArray();
        corners = welding.Apply(mesh.Triangles);
        vertices = mesh.Triangles.ToArray();
        var normals = new Vector3[positions.Length];
        for (int v = 0; v < pointOf.Length; v++)
        {
            normals[pointOf[v]] += mesh.Normals[v];
        }

        for (int p = 0; p < normals.Length; p++)
        {
            normals[p] = Vec.Normalize(normals[p], Vector3.UnitY);
        }

        surface = new CollapsingMesh(positions, normals, corners, vertices);
        twin = SagittalTwins.Find(welding);
        bool mirrored = Array.IndexOf(twin, -1) < 0;
        side = new sbyte[positions.Length];
        for (int p = 0; p < side.Length; p++)
        {
            // Without mirror images all is one side.
            twin[p] = mirrored ? twin[p] : p;
            side[p] = mirrored ? (sbyte)Math.Sign(positions[p].X) : (sbyte)1;
        }

        cost = new ReductionCost(mesh, positions, pointOf, corners);
        choice = new StepChoice(surface, cost, twin, side);
        remap = Identity(pointOf.Length);
        standsFor = Identity(positions.Length);

        var pieces = new SurfacePieces(positions, corners);
        pieceOf = pieces.PieceOf;
        lopsided = LopsidedPieces.Find(corners, twin, pieceOf);
        lostPieces = new bool[positions.Length];
        queued = new bool[positions.Length];
        cheapest = new int[positions.Length];
        Array.Fill(cheapest, -1);
        queue = new CostQueue(positions.Length);
        OfferPieces(pieces);
        for (int p = 0; p < positions.Length; p++)
        {
            if (side[p] >= 0)
            {
                Enqueue(p);
            }
        }
    }

    /// <summary>From now on no step is taken after which the surface would cut through itself where it did not before.</summary>
    public void KeepFromCrossing() => guard ??= new CrossingGuard(surface, positions, corners, pieceOf, MirrorImages.Find(corners, side, pieceOf, lopsided));

    /// <summary>Triangles that are left.</summary>
    public int Triangles => surface.Triangles;

    /// <summary>Takes triangles away until no more than a number are left, or nothing can go without damage.</summary>
    public void ReduceTo(int triangles)
    {
        while (surface.Triangles > triangles && queue.Count > 0)
        {
            int item = queue.Take(out double known);
            if (item >= twin.Length)
            {
                RemovePiece(item - twin.Length);
            }
            else
            {
                queued[item] = false;
                if (surface.IsUsed(item))
                {
                    Step(item, known);
                }
            }
        }
    }

    /// <summary>The mesh as it is now, over the same vertices.</summary>
    public CreatureLod ToLevel()
    {
        int[] triangles = new int[3 * surface.Triangles];
        var parts = new List<MeshPart>();
        int count = 0;
        foreach (MeshPart part in mesh.Parts)
        {
            int start = count;
            for (int c = part.FirstIndex; c < part.FirstIndex + part.IndexCount; c++)
            {
                if (!surface.IsGone(c / 3))
                {
                    triangles[count++] = vertices[c];
                }
            }

            if (count > start)
            {
                parts.Add(new MeshPart(part.Material, start, count - start));
            }
        }

        return new CreatureLod(mesh, triangles, parts, FinalRemap());
    }

    /// <summary>Gives borrowed memory back; nothing may be asked of it any more.</summary>
    public void Dispose()
    {
        cost.Dispose();
        guard?.Dispose();
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

    /// <summary>Lets all pieces but the largest be lost, each together with its mirror image.</summary>
    private void OfferPieces(SurfacePieces pieces)
    {
        for (int p = 0; p < twin.Length; p++)
        {
            int other = pieceOf[twin[p]];
            if (pieceOf[p] == p && p <= other && p != pieces.Largest && other != pieces.Largest)
            {
                queue.Add(twin.Length + p, cost.OfLoss(p, pieces.AreaOf(p), pieces.DiagonalOf(p)));
            }
        }
    }

    private void Enqueue(int point)
    {
        if (queued[point])
        {
            return;
        }

        surface.Neighbours(point, around);
        double min = double.PositiveInfinity;
        foreach (int n in around)
        {
            min = Math.Min(min, cost.MinOf(point, n, cost.ShapeOf(point, n)));
        }

        queued[point] = true;
        queue.Add(point, min);
    }

    /// <summary>Pulls a point onto the neighbour for which that costs least; puts it back when that costs more than was known, and sets it aside when no neighbour will do.</summary>
    private void Step(int point, double known)
    {
        int best = cheapest[point];
        if (best < 0)
        {
            best = choice.FindCheapest(point, out double leastCost);
            if (best >= 0 && leastCost > known)
            {
                cheapest[point] = choice.MayTear ? -1 : best;
                queued[point] = true;
                queue.Add(point, leastCost);
                return;
            }
        }

        if (best >= 0 && TryBoth(point, best))
        {
            Requeue(best);
            return;
        }

        choice.Rank(point);
        for (int i = 1; i < choice.Ranked.Count; i++)
        {
            if (choice.CostOf(i) > known)
            {
                cheapest[point] = -1;
                queued[point] = true;
                queue.Add(point, choice.CostOf(i));
                return;
            }

            if (TryBoth(point, choice.Ranked[i]))
            {
                Requeue(choice.Ranked[i]);
                return;
            }
        }
    }

    private bool OnOtherSide(int point) => side[point] < 0;

    /// <summary>Pulls a point onto a neighbour, and the mirror image of the one onto that of the other; both or none.</summary>
    private bool TryBoth(int from, int to)
    {
        int twinFrom = twin[from];
        int twinTo = twin[to];
        surface.Prune(to);
        if (!surface.Allows(from, to))
        {
            return false;
        }

        surface.Prune(twinFrom);
        surface.Prune(twinTo);
        if (guard != null && twinFrom != from && lopsided[pieceOf[from]] && !StaysClear(guard, twinFrom, twinTo))
        {
            return false;
        }

        // What is around the image of a step is the image of what is around the step: what is allowed here is allowed there.
        bool apart = twinFrom != from && !lopsided[pieceOf[from]] && surface.LiesAmong(from, side, 1) && surface.LiesAmong(to, side, 1);
        choice.Match(from, to, pairs);
        surface.Collapse(from, to, pairs);
        surface.Taken(moved, lost);
        if (guard != null && (guard.Cross(moved, from, to) || (twinFrom != from && guard.CrossImages(moved, twin))))
        {
            surface.Undo();
            return false;
        }

        if (twinFrom != from)
        {
            if (!apart && !surface.Allows(twinFrom, twinTo))
            {
                surface.Undo();
                return false;
            }

            choice.Match(twinFrom, twinTo, twinPairs);
            surface.Collapse(twinFrom, twinTo, twinPairs);

            // Mirror images cross nothing when these do not; where they are none, that was looked at.
            surface.Taken(twinMoved, twinLost);
            guard?.Note(twinMoved, twinLost);
            Accept(twinFrom, twinTo, twinPairs);
        }

        guard?.Note(moved, lost);
        Accept(from, to, pairs);
        return true;
    }

    /// <summary>Whether nothing cuts through anything after a step, which is not taken yet.</summary>
    private bool StaysClear(CrossingGuard asked, int from, int to)
    {
        if (!surface.Allows(from, to))
        {
            return false;
        }

        choice.Match(from, to, twinPairs);
        surface.Collapse(from, to, twinPairs);
        surface.Taken(twinMoved, twinLost);
        bool clear = !asked.Cross(twinMoved, from, to);
        surface.Undo();
        return clear;
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

    /// <summary>Gives the points around a step another chance.</summary>
    private void Requeue(int to)
    {
        surface.Neighbours(to, neighbours);
        neighbours.Add(to);
        foreach (int n in neighbours)
        {
            cheapest[n] = -1;
            if (!OnOtherSide(n))
            {
                Enqueue(n);
            }
        }
    }

    private void RemovePiece(int piece)
    {
        int other = pieceOf[twin[piece]];
        lostPieces[piece] = true;
        lostPieces[other] = true;
        for (int t = 0; t < corners.Length / 3; t++)
        {
            if (!surface.IsGone(t) && lostPieces[pieceOf[corners[3 * t]]])
            {
                surface.Remove(t);
            }
        }
    }

    /// <summary>For each vertex of the mesh the one that stands for it, −1 when its piece is lost.</summary>
    private int[] FinalRemap()
    {
        bool[] used = new bool[remap.Length];
        for (int c = 0; c < vertices.Length; c++)
        {
            used[vertices[c]] |= !surface.IsGone(c / 3);
        }

        int[] final = new int[remap.Length];
        for (int v = 0; v < final.Length; v++)
        {
            int point = End(pointOf[v], standsFor);
            if (lostPieces[pieceOf[point]])
            {
                final[v] = -1;
                continue;
            }

            // The last triangle of a vertex may have gone while its point stayed with others.
            int at = End(v, remap);
            final[v] = used[at] ? at : choice.MaxAlike(v, point);
        }

        return final;
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
