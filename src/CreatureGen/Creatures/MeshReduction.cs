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
internal sealed class MeshReduction
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
    private readonly bool mirrored;
    private readonly int[] pieceOf;
    private readonly bool[] lost;
    private readonly int[] remap;
    private readonly int[] standsFor;
    private readonly CostQueue queue;
    private readonly bool[] queued;

    // The neighbour that was found to cost least for a point, or −1 once something around the point has changed: spares ranking the neighbours a second time when that price is due.
    // Not kept where the texture tears: then it depends on vertices farther away.
    private readonly int[] cheapest;
    private bool tears;
    private readonly double[] neighbourCosts = new double[64];
    private readonly List<int> neighbours = new();
    private readonly List<int> around = new();
    private readonly List<int> candidates = new();
    private readonly List<(int From, int To)> pairs = new();
    private readonly List<(int From, int To)> twinPairs = new();

    private readonly List<int> moved = new();
    private readonly List<int> twinMoved = new();
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

        cost = new ReductionCost(mesh, positions, pointOf, corners);
        surface = new CollapsingMesh(positions, normals, corners, vertices);
        twin = SagittalTwins.Find(positions);
        mirrored = Array.IndexOf(twin, -1) < 0;
        for (int p = 0; p < twin.Length && !mirrored; p++)
        {
            twin[p] = p;
        }

        side = new sbyte[positions.Length];
        for (int p = 0; p < side.Length; p++)
        {
            side[p] = (sbyte)Math.Sign(positions[p].X);
        }

        remap = Identity(pointOf.Length);
        standsFor = Identity(positions.Length);

        var pieces = new SurfacePieces(positions, corners);
        pieceOf = pieces.PieceOf;
        lost = new bool[positions.Length];
        queued = new bool[positions.Length];
        cheapest = new int[positions.Length];
        Array.Fill(cheapest, -1);
        queue = new CostQueue(positions.Length);
        OfferPieces(pieces);
        for (int p = 0; p < positions.Length; p++)
        {
            if (!mirrored || side[p] >= 0)
            {
                Enqueue(p);
            }
        }
    }

    /// <summary>From now on no step is taken after which the surface would cut through itself where it did not before.</summary>
    public void KeepFromCrossing() => guard ??= new CrossingGuard(surface, positions, corners, pieceOf);

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
            min = Math.Min(min, cost.MinOf(point, n));
        }

        queued[point] = true;
        queue.Add(point, min);
    }

    /// <summary>Pulls a point onto the neighbour for which that costs least; puts it back when that costs more than was known, and sets it aside when no neighbour will do.</summary>
    private void Step(int point, double known)
    {
        int best = cheapest[point];
        if (best >= 0 && TryBoth(point, best))
        {
            Requeue(best);
            return;
        }

        Rank(point);
        for (int i = best >= 0 ? 1 : 0; i < candidates.Count; i++)
        {
            if (neighbourCosts[i] > known)
            {
                cheapest[point] = i == 0 && !tears ? candidates[0] : -1;
                queued[point] = true;
                queue.Add(point, neighbourCosts[i]);
                return;
            }

            if (TryBoth(point, candidates[i]))
            {
                Requeue(candidates[i]);
                return;
            }
        }
    }

    /// <summary>Lists the neighbours onto which a point may be pulled, the cheapest first.</summary>
    private void Rank(int point)
    {
        surface.Neighbours(point, neighbours);
        candidates.Clear();
        tears = false;
        foreach (int n in neighbours)
        {
            bool sidesKept = !mirrored || (twin[point] == point ? twin[n] == n : n != twin[point] && !OnOtherSide(n));
            if (!sidesKept || candidates.Count == neighbourCosts.Length)
            {
                continue;
            }

            bool torn = !Match(point, n, pairs);
            tears |= torn;
            double edgeCost = cost.Of(point, n, pairs, torn);
            int at = candidates.Count;
            candidates.Add(n);
            while (at > 0 && (edgeCost < neighbourCosts[at - 1] || (edgeCost == neighbourCosts[at - 1] && n < candidates[at - 1])))
            {
                neighbourCosts[at] = neighbourCosts[at - 1];
                candidates[at] = candidates[at - 1];
                at--;
            }

            neighbourCosts[at] = edgeCost;
            candidates[at] = n;
        }
    }

    private bool OnOtherSide(int point) => side[point] < 0;

    /// <summary>Pulls a point onto a neighbour, and the mirror image of the one onto that of the other; both or none.</summary>
    private bool TryBoth(int from, int to)
    {
        int twinFrom = twin[from];
        int twinTo = twin[to];
        surface.Prune(to);
        surface.Prune(twinFrom);
        surface.Prune(twinTo);
        Match(from, to, pairs);
        if (!surface.TryCollapse(from, to, pairs))
        {
            return false;
        }

        surface.Moved(moved);
        if (guard != null && (guard.Cross(moved, to) || (twinFrom != from && guard.CrossImages(moved, twin))))
        {
            surface.Undo();
            return false;
        }

        if (twinFrom != from)
        {
            Match(twinFrom, twinTo, twinPairs);
            if (!surface.TryCollapse(twinFrom, twinTo, twinPairs))
            {
                surface.Undo();
                return false;
            }

            // Mirror images cross nothing when these do not.
            surface.Moved(twinMoved);
            guard?.Note(twinMoved);
            Accept(twinFrom, twinTo, twinPairs);
        }

        guard?.Note(moved);
        Accept(from, to, pairs);
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

    /// <summary>Finds for each vertex of a point the one of a neighbour that takes its place: across the edge between them, or else the most alike. False when one is not across the edge.</summary>
    private bool Match(int from, int to, List<(int From, int To)> found)
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
    private int MaxAlike(int vertex, int point)
    {
        surface.VerticesOf(point, around);
        int best = around[0];
        foreach (int v in around)
        {
            best = cost.Difference(vertex, v) < cost.Difference(vertex, best) ? v : best;
        }

        return best;
    }

    /// <summary>Gives the points around a step another chance.</summary>
    private void Requeue(int to)
    {
        surface.Neighbours(to, neighbours);
        neighbours.Add(to);
        foreach (int n in neighbours)
        {
            cheapest[n] = -1;
            if (!mirrored || !OnOtherSide(n))
            {
                Enqueue(n);
            }
        }
    }

    private void RemovePiece(int piece)
    {
        int other = pieceOf[twin[piece]];
        lost[piece] = true;
        lost[other] = true;
        for (int t = 0; t < corners.Length / 3; t++)
        {
            if (!surface.IsGone(t) && lost[pieceOf[corners[3 * t]]])
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
            if (lost[pieceOf[point]])
            {
                final[v] = -1;
                continue;
            }

            // The last triangle of a vertex may have gone while its point stayed with others.
            int at = End(v, remap);
            final[v] = used[at] ? at : MaxAlike(v, point);
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
