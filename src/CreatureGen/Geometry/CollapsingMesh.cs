using System;
using System.Collections.Generic;
using System.Numerics;
using static CreatureGen.Geometry.TriangleCorner;

namespace CreatureGen.Geometry;

/// <summary>
/// A closed surface that loses one point after another: a point is pulled onto one of its neighbours, and the two triangles at the edge between them vanish.
/// </summary>
/// <remarks>
/// A corner of a triangle has a point, where it is, and a drawn vertex, how it looks: points at which a texture or a colour parts have several vertices. A closed two-manifold stays one, because a point only moves when the link condition holds: what both ends of the edge neighbour is what the edge neighbours. Based on: H. Hoppe 1996, "Progressive meshes"; T. K. Dey, H. Edelsbrunner, S. Guha and D. V. Nekhayev 1999, "Topology preserving edge contraction".
/// </remarks>
internal sealed class CollapsingMesh
{
    private readonly Vector3[] positions;
    private readonly Vector3[] normals;
    private readonly int[] points;
    private readonly int[] vertices;
    private readonly bool[] gone;

    // The corners of a point as a chain; those of triangles that are gone stay in it until it is pruned. Most chains have none and are not looked through.
    private readonly int[] first;
    private readonly int[] last;
    private readonly int[] next;
    private readonly bool[] unpruned;
    private readonly int[] marks;

    // The drawn vertex of a point that has but one, as most have: then an edge between two of these says at once which takes the place of which. −1 for others.
    private readonly int[] onlyVertex;

    // The points on the rim, where the surface ends at the plane that mirrors it.
    private readonly bool[] rim;
    private readonly int[] around;
    private int mark;

    private readonly List<int> movedCorners = new();
    private readonly List<int> movedVertices = new();
    private readonly List<int> lostTriangles = new();
    private (int From, int To, int FirstOfFrom, int LastOfFrom, int FirstOfTo) step;
    private readonly SavedArrays saved;
    private int savedTriangles;

    /// <summary>Takes a surface whose every edge has two triangles, or one and two points on the rim.</summary>
    /// <param name="positions">Place of each point.</param>
    /// <param name="normals">Unit normal of each point: no triangle is turned against those of its corners.</param>
    /// <param name="points">The point of each corner, three corners per triangle; changed in place from now on.</param>
    /// <param name="vertices">The drawn vertex of each corner; changed in place from now on.</param>
    /// <param name="rim">The points on the plane beyond which the surface goes on as its own mirror image; null where it is whole.</param>
    public CollapsingMesh(Vector3[] positions, Vector3[] normals, int[] points, int[] vertices, bool[]? rim = null)
    {
        this.rim = rim ?? new bool[positions.Length];
        this.positions = positions;
        this.normals = normals;
        this.points = points;
        this.vertices = vertices;
        Triangles = points.Length / 3;
        gone = new bool[Triangles];
        first = new int[positions.Length];
        last = new int[positions.Length];
        next = new int[points.Length];
        unpruned = new bool[positions.Length];
        marks = new int[positions.Length];
        onlyVertex = new int[positions.Length];
        around = new int[positions.Length + 1];
        Array.Fill(first, -1);
        for (int c = points.Length - 1; c >= 0; c--)
        {
            int p = points[c];
            onlyVertex[p] = first[p] < 0 || onlyVertex[p] == vertices[c] ? vertices[c] : -1;
            next[c] = first[p];
            last[p] = first[p] < 0 ? c : last[p];
            first[p] = c;
        }

        saved = new SavedArrays(points, vertices, first, last, next, gone, unpruned);
    }

    /// <summary>Number of triangles left of those that were given.</summary>
    public int Triangles { get; private set; }

    /// <summary>Keeps the surface as it is.</summary>
    public void Save()
    {
        savedTriangles = Triangles;
        saved.Save();
    }

    /// <summary>Puts the surface back to what it was when it was saved.</summary>
    public void Restore()
    {
        Triangles = savedTriangles;
        saved.Restore();
    }

    /// <summary>Whether a triangle has vanished.</summary>
    public bool IsGone(int triangle) => gone[triangle];

    /// <summary>Whether a point is still a corner of triangles.</summary>
    public bool IsUsed(int point) => first[point] >= 0;

    /// <summary>The drawn vertex of a point that has but one, −1 for others.</summary>
    public int OnlyVertexOf(int point) => onlyVertex[point];

    /// <summary>The neighbours of a point, each once; valid until the next question.</summary>
    public ReadOnlySpan<int> Neighbours(int point)
    {
        Prune(point);
        mark++;
        int count = 0;
        for (int c = first[point]; c >= 0; c = next[c])
        {
            // What has been marked already is overwritten.
            int a = points[Next(c)], b = points[Previous(c)];
            around[count] = a;
            count += marks[a] == mark ? 0 : 1;
            marks[a] = mark;
            around[count] = b;
            count += marks[b] == mark ? 0 : 1;
            marks[b] = mark;
        }

        return new ReadOnlySpan<int>(around, 0, count);
    }

    /// <summary>
    /// Says onto which vertex of <paramref name="to"/> each vertex of <paramref name="from"/> would be pulled: the one at the other end of the edge, on the same side of it.
    /// </summary>
    /// <param name="from">The point that would go.</param>
    /// <param name="to">A neighbour of it.</param>
    /// <param name="pairs">Receives the vertices; the second is −1 when the edge does not say.</param>
    /// <returns>Whether the edge says it for all, so that nothing is torn out of its place in the texture.</returns>
    public bool Match(int from, int to, List<(int From, int To)> pairs)
    {
        pairs.Clear();
        if (onlyVertex[from] >= 0 && onlyVertex[to] >= 0)
        {
            pairs.Add((onlyVertex[from], onlyVertex[to]));
            return true;
        }

        bool whole = true;
        for (int c = first[from]; c >= 0; c = next[c])
        {
            if (gone[TriangleOf(c)])
            {
                continue;
            }

            int other = points[Next(c)] == to ? vertices[Next(c)] : points[Previous(c)] == to ? vertices[Previous(c)] : -1;
            int at = 0;
            while (at < pairs.Count && pairs[at].From != vertices[c])
            {
                at++;
            }

            if (at == pairs.Count)
            {
                pairs.Add((vertices[c], other));
            }
            else if (pairs[at].To < 0)
            {
                pairs[at] = (vertices[c], other);
            }
            else
            {
                whole &= other < 0 || other == pairs[at].To;
            }
        }

        foreach ((int _, int To) pair in pairs)
        {
            whole &= pair.To >= 0;
        }

        return whole;
    }

    /// <summary>The drawn vertices of a point, in the order of its corners, some of them several times.</summary>
    public void VerticesOf(int point, List<int> found)
    {
        found.Clear();
        for (int c = first[point]; c >= 0; c = next[c])
        {
            if (!gone[TriangleOf(c)])
            {
                found.Add(vertices[c]);
            }
        }
    }

    /// <summary>Whether a point can be pulled onto a neighbour without pinching the surface, folding it or making a sliver.</summary>
    public bool Allows(int from, int to) => LinkHolds(from, to) && !Folds(from, to);

    /// <summary>Pulls a point onto a neighbour, where that is allowed. <see cref="Undo"/> takes the last step back.</summary>
    /// <param name="from">The point that goes.</param>
    /// <param name="to">Its neighbour.</param>
    /// <param name="pairs">For each vertex of <paramref name="from"/> the vertex of <paramref name="to"/> that takes its place.</param>
    public void Collapse(int from, int to, List<(int From, int To)> pairs)
    {
        movedCorners.Clear();
        movedVertices.Clear();
        lostTriangles.Clear();
        step = (from, to, first[from], last[from], first[to]);
        for (int c = first[from]; c >= 0; c = next[c])
        {
            int t = TriangleOf(c);
            if (gone[t])
            {
                continue;
            }

            int a = points[Next(c)];
            int b = points[Previous(c)];
            if (a == to || b == to)
            {
                gone[t] = true;
                unpruned[a == to ? b : a] = true;
                lostTriangles.Add(t);
                continue;
            }

            movedCorners.Add(c);
            movedVertices.Add(vertices[c]);
            points[c] = to;
            foreach ((int From, int To) pair in pairs)
            {
                if (pair.From == vertices[c])
                {
                    vertices[c] = pair.To;
                    break;
                }
            }
        }

        unpruned[to] = true;
        Triangles -= lostTriangles.Count;
        next[last[from]] = first[to];
        first[to] = first[from];
        first[from] = -1;
    }

    /// <summary>Takes back the last collapse. No chain may have been pruned since.</summary>
    public void Undo()
    {
        first[step.From] = step.FirstOfFrom;
        next[step.LastOfFrom] = -1;
        first[step.To] = step.FirstOfTo;
        for (int i = 0; i < movedCorners.Count; i++)
        {
            points[movedCorners[i]] = step.From;
            vertices[movedCorners[i]] = movedVertices[i];
        }

        foreach (int t in lostTriangles)
        {
            gone[t] = false;
        }

        Triangles += lostTriangles.Count;
    }

    /// <summary>Removes a triangle together with the others of its piece, one by one.</summary>
    public void Remove(int triangle)
    {
        for (int c = 3 * triangle; c < (3 * triangle) + 3; c++)
        {
            first[points[c]] = -1;
        }

        gone[triangle] = true;
        Triangles--;
    }

    /// <summary>Forgets the corners of triangles that are gone.</summary>
    public void Prune(int point)
    {
        if (!unpruned[point])
        {
            return;
        }

        unpruned[point] = false;
        int kept = -1;
        int c = first[point];
        first[point] = -1;
        while (c >= 0)
        {
            int following = next[c];
            if (!gone[TriangleOf(c)])
            {
                if (kept < 0)
                {
                    first[point] = c;
                }
                else
                {
                    next[kept] = c;
                }

                next[c] = -1;
                kept = c;
            }

            c = following;
        }

        last[point] = kept;
    }

    /// <summary>The two ends of an edge have no neighbours in common but the two across it, of which the second may be a mirror image, and those two are no triangle with both.</summary>
    private bool LinkHolds(int from, int to)
    {
        int sides = rim[from] ? 1 : 2;
        mark += 2;
        int across = -1, alsoAcross = -1, faces = 0;
        for (int c = first[from]; c >= 0; c = next[c])
        {
            if (gone[TriangleOf(c)])
            {
                continue;
            }

            int a = points[Next(c)];
            int b = points[Previous(c)];
            marks[a] = mark;
            marks[b] = mark;
            if (a == to || b == to)
            {
                alsoAcross = across;
                across = a == to ? b : a;
                faces++;
            }
        }

        if (faces != sides || across == alsoAcross || (rim[to] && !rim[from] && Pinches(from, to, across, alsoAcross)))
        {
            return false;
        }

        int common = 0;
        bool bridged = false;
        for (int c = first[to]; c >= 0; c = next[c])
        {
            if (gone[TriangleOf(c)])
            {
                continue;
            }

            int a = points[Next(c)];
            int b = points[Previous(c)];
            common += Count(a) + Count(b);
            bridged |= (a == across && b == alsoAcross) || (b == across && a == alsoAcross);
        }

        return common == sides && !(bridged && IsTriangle(from, across, alsoAcross));

        int Count(int neighbour)
        {
            if (marks[neighbour] != mark)
            {
                return 0;
            }

            marks[neighbour] = mark - 1;
            return 1;
        }
    }

    /// <summary>Whether a point and its mirror image, pulled onto the rim from both sides, would meet along an edge or in a triangle there.</summary>
    private bool Pinches(int from, int to, int across, int alsoAcross)
    {
        for (int c = first[from]; c >= 0; c = next[c])
        {
            int a = points[Next(c)];
            if (!gone[TriangleOf(c)] && rim[a] && a != to && ((a != across && a != alsoAcross) || rim[points[Previous(c)]] && points[Previous(c)] != to))
            {
                return true;
            }
        }

        return false;
    }

    private bool IsTriangle(int point, int a, int b)
    {
        for (int c = first[point]; c >= 0; c = next[c])
        {
            int x = points[Next(c)];
            int y = points[Previous(c)];
            if (!gone[TriangleOf(c)] && ((x == a && y == b) || (x == b && y == a)))
            {
                return true;
            }
        }

        return false;
    }

    private bool Folds(int from, int to)
    {
        for (int c = first[from]; c >= 0; c = next[c])
        {
            int i = points[Next(c)];
            int j = points[Previous(c)];
            if (gone[TriangleOf(c)] || i == to || j == to)
            {
                continue;
            }

            Vector3 facing = normals[i] + normals[j];
            if (CornerPull.Spoils(positions[from], positions[to], positions[i], positions[j], facing + normals[from], facing + normals[to]))
            {
                return true;
            }
        }

        return false;
    }
}
