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
internal sealed class CollapsingMesh : IDisposable
{
    private readonly Vector3[] positions;
    private readonly Vector3[] normals;
    private readonly int[] points;
    private readonly int[] vertices;
    private readonly bool[] gone;

    private readonly PointCorners corners;
    private readonly int[] marks;

    // The drawn vertex of a point that has but one, as most have: then an edge between two of these says at once which takes the place of which. −1 for others.
    private readonly int[] onlyVertex;

    // The points on the rim, where the surface ends at the plane that mirrors it.
    private readonly bool[] rim;

    // The points around which the surface ends, at the rim or elsewhere.
    private readonly bool[] open;
    private readonly int[] around;
    private int mark;

    private readonly List<int> movedVertices = new();
    private (int From, int To) step;
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
        corners = new PointCorners(positions.Length, points);
        marks = new int[positions.Length];
        onlyVertex = new int[positions.Length];
        around = new int[positions.Length + 1];
        open = new bool[positions.Length];
        Array.Fill(onlyVertex, int.MaxValue);
        for (int c = 0; c < points.Length; c++)
        {
            int p = points[c];
            onlyVertex[p] = onlyVertex[p] == int.MaxValue || onlyVertex[p] == vertices[c] ? vertices[c] : -1;
        }

        for (int p = 0; p < open.Length; p++)
        {
            open[p] = EndsAround(p);
        }

        saved = new SavedArrays(points, vertices, gone);
    }

    /// <summary>Number of triangles left of those that were given.</summary>
    public int Triangles { get; private set; }

    /// <summary>Keeps the surface as it is.</summary>
    public void Save()
    {
        savedTriangles = Triangles;
        saved.Save();
        corners.Save();
    }

    /// <summary>Puts the surface back to what it was when it was saved.</summary>
    public void Restore()
    {
        Triangles = savedTriangles;
        saved.Restore();
        corners.Restore();
    }

    /// <summary>Gives borrowed memory back; nothing may be asked of it any more.</summary>
    public void Dispose()
    {
        corners.Dispose();
        saved.Dispose();
    }

    /// <summary>Whether a triangle has vanished.</summary>
    public bool IsGone(int triangle) => gone[triangle];

    /// <summary>Whether a point is still a corner of triangles.</summary>
    public bool IsUsed(int point) => corners.CountOf(point) > 0;

    /// <summary>The drawn vertex of a point that has but one, −1 for others.</summary>
    public int OnlyVertexOf(int point) => onlyVertex[point];

    /// <summary>The neighbours of a point, each once; valid until the next question.</summary>
    public ReadOnlySpan<int> Neighbours(int point)
    {
        int found = 0;
        foreach (int c in corners.Of(point))
        {
            around[found++] = points[Next(c)];
        }

        // Around a point within the surface each neighbour comes after it in one triangle; where the surface ends one of two does not.
        if (open[point])
        {
            foreach (int c in corners.Of(point))
            {
                int b = points[Previous(c)];
                around[found] = b;
                found += around.AsSpan(0, found).IndexOf(b) < 0 ? 1 : 0;
            }
        }

        return new ReadOnlySpan<int>(around, 0, found);
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
        if (onlyVertex[from] >= 0)
        {
            int taker = onlyVertex[to];
            bool whole = true;
            for (int i = 0; i < corners.CountOf(from) && onlyVertex[to] < 0; i++)
            {
                int other = Across(corners.Of(from)[i], to);
                whole &= other < 0 || taker < 0 || other == taker;
                taker = taker < 0 ? other : taker;
            }

            pairs.Add((onlyVertex[from], taker));
            return whole;
        }

        bool all = true;
        foreach (int c in corners.Of(from))
        {
            int other = Across(c, to);
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
                all &= other < 0 || other == pairs[at].To;
            }
        }

        foreach ((int _, int To) pair in pairs)
        {
            all &= pair.To >= 0;
        }

        return all;
    }

    /// <summary>Whether the vertices of a point part, but not along the edge to a neighbour: pulled onto that one, some of them would leave their places in the texture.</summary>
    public bool Tears(int from, int to)
    {
        if (onlyVertex[from] >= 0)
        {
            return false;
        }

        int found = -1;
        foreach (int c in corners.Of(from))
        {
            if (points[Next(c)] == to || points[Previous(c)] == to)
            {
                if (found >= 0 && vertices[c] != found)
                {
                    return false;
                }

                found = vertices[c];
            }
        }

        return true;
    }

    /// <summary>The drawn vertices of a point, in the order of its corners, some of them several times.</summary>
    public void VerticesOf(int point, List<int> found)
    {
        found.Clear();
        foreach (int c in corners.Of(point))
        {
            found.Add(vertices[c]);
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
        movedVertices.Clear();
        step = (from, to);
        Span<int> room = corners.RoomFor(from, to);
        int kept = 0;
        foreach (int c in corners.Of(to))
        {
            room[kept] = c;
            kept += points[Next(c)] == from || points[Previous(c)] == from ? 0 : 1;
        }

        foreach (int c in corners.Of(from))
        {
            int a = points[Next(c)];
            int b = points[Previous(c)];
            movedVertices.Add(vertices[c]);
            if (a == to || b == to)
            {
                int t = TriangleOf(c);
                gone[t] = true;
                Triangles--;
                corners.Drop(t, a == to ? b : a);
                continue;
            }

            room[kept++] = c;
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

        open[to] |= open[from];
        corners.Replace(to, kept, from);
    }

    /// <summary>Takes back the last collapse.</summary>
    public void Undo()
    {
        corners.Undo();
        ReadOnlySpan<int> ring = corners.Of(step.From);
        for (int i = 0; i < ring.Length; i++)
        {
            int c = ring[i];
            points[c] = step.From;
            vertices[c] = movedVertices[i];
            int t = TriangleOf(c);
            if (gone[t])
            {
                // What was dropped still lies behind the others.
                gone[t] = false;
                Triangles++;
                corners.TakeBack(points[Next(c)] == step.To ? points[Previous(c)] : points[Next(c)]);
            }
        }
    }

    /// <summary>Removes a triangle together with the others of its piece, one by one.</summary>
    public void Remove(int triangle)
    {
        for (int c = 3 * triangle; c < (3 * triangle) + 3; c++)
        {
            corners.Clear(points[c]);
        }

        gone[triangle] = true;
        Triangles--;
    }

    /// <summary>Whether the surface ends at an edge to a point: where it does not, every neighbour after it in one triangle is before it in another.</summary>
    private bool EndsAround(int point)
    {
        mark++;
        foreach (int c in corners.Of(point))
        {
            marks[points[Previous(c)]] = mark;
        }

        bool ends = false;
        foreach (int c in corners.Of(point))
        {
            ends |= marks[points[Next(c)]] != mark;
        }

        return ends;
    }

    /// <summary>The drawn vertex that a triangle has at a point, −1 when it has none there.</summary>
    /// <param name="corner">One of its other corners.</param>
    /// <param name="point">The point.</param>
    private int Across(int corner, int point) => points[Next(corner)] == point ? vertices[Next(corner)] : points[Previous(corner)] == point ? vertices[Previous(corner)] : -1;

    /// <summary>The two ends of an edge have no neighbours in common but the two across it, of which the second may be a mirror image, and those two are no triangle with both.</summary>
    private bool LinkHolds(int from, int to)
    {
        int sides = rim[from] ? 1 : 2;
        mark++;
        int across = -1, alsoAcross = -1, faces = 0;
        foreach (int c in corners.Of(from))
        {
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
        foreach (int n in Neighbours(to))
        {
            common += marks[n] == mark ? 1 : 0;
        }

        return common == sides && !(corners.CountOf(from) == 3 && sides == 2 && IsTriangle(to, across, alsoAcross));
    }

    /// <summary>Whether a point and its mirror image, pulled onto the rim from both sides, would meet along an edge or in a triangle there.</summary>
    private bool Pinches(int from, int to, int across, int alsoAcross)
    {
        foreach (int c in corners.Of(from))
        {
            int a = points[Next(c)];
            if (rim[a] && a != to && ((a != across && a != alsoAcross) || rim[points[Previous(c)]] && points[Previous(c)] != to))
            {
                return true;
            }
        }

        return false;
    }

    private bool IsTriangle(int point, int a, int b)
    {
        foreach (int c in corners.Of(point))
        {
            int x = points[Next(c)];
            int y = points[Previous(c)];
            if ((x == a && y == b) || (x == b && y == a))
            {
                return true;
            }
        }

        return false;
    }

    private bool Folds(int from, int to)
    {
        foreach (int c in corners.Of(from))
        {
            int i = points[Next(c)];
            int j = points[Previous(c)];
            if (i == to || j == to)
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
