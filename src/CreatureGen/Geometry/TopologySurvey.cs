using System;
using System.Buffers;
using System.Numerics;
using CreatureGen.Maths;
using static CreatureGen.Geometry.TriangleCorner;

namespace CreatureGen.Geometry;

/// <summary>The working behind <see cref="SurfaceTopology"/>: half-edges sorted by their edge, disjoint sets of corners.</summary>
/// <remarks>Half-edge h starts at corner h of the index buffer and ends at the next corner of the same triangle.</remarks>
internal static class TopologySurvey
{
    /// <summary>Examines a mesh whose indices are in range.</summary>
    public static SurfaceTopology Examine(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles)
    {
        SurfaceTopology topology = VertexRings.AreWhole(positions.Length, triangles, out int used) ? OfClosed(positions.Length, triangles.Length / 3, used) : OfAny(positions.Length, triangles);
        return topology with
        {
            Triangles = triangles.Length / 3,
            DegenerateTriangles = CountDegenerate(positions, triangles),
            NonFinitePositions = CountNonFinite(positions),
        };
    }

    /// <summary>What nearly all surfaces are.</summary>
    private static SurfaceTopology OfClosed(int vertices, int triangles, int used) => new()
    {
        Edges = 3 * triangles / 2,
        EulerCharacteristic = used - (triangles / 2),
        UnusedVertices = vertices - used,
    };

    /// <summary>Counts all that is wrong.</summary>
    private static SurfaceTopology OfAny(int vertices, ReadOnlySpan<int> triangles)
    {
        int corners = triangles.Length;
        ArrayPool<int> pool = ArrayPool<int>.Shared;
        int[] sorted = pool.Rent(corners);
        int[] spare = pool.Rent(corners);
        int[] perVertex = pool.Rent(vertices + 1);
        int[] sets = pool.Rent(corners);
        try
        {
            int halfEdges = SortByEdge(triangles, sorted, spare, perVertex.AsSpan(0, vertices + 1));
            EdgeCounts edges = CountEdges(triangles, sorted.AsSpan(0, halfEdges), spare, sets.AsSpan(0, corners), perVertex.AsSpan(0, vertices));
            int used = 0;
            int pinched = 0;
            for (int v = 0; v < vertices; v++)
            {
                used += perVertex[v] > 0 ? 1 : 0;
                pinched += perVertex[v] > 1 ? 1 : 0;
            }

            return new SurfaceTopology
            {
                Edges = edges.All,
                OpenEdges = edges.Open,
                NonManifoldEdges = edges.NonManifold,
                WindingEdges = edges.Winding,
                PinchedVertices = pinched,
                EulerCharacteristic = used - edges.All + (halfEdges / 3),
                DuplicateTriangles = edges.DuplicateTriangles,
                UnusedVertices = CountUnused(triangles, perVertex.AsSpan(0, vertices)),
            };
        }
        finally
        {
            pool.Return(sorted);
            pool.Return(spare);
            pool.Return(perVertex);
            pool.Return(sets);
        }
    }

    /// <summary>Half-edges of the triangles that have three different vertices, by lower vertex, then higher vertex, then number.</summary>
    private static int SortByEdge(ReadOnlySpan<int> triangles, Span<int> sorted, Span<int> spare, Span<int> starts)
    {
        starts.Clear();
        int count = 0;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            if (UsesAVertexTwice(triangles, t))
            {
                continue;
            }

            for (int h = t; h < t + 3; h++)
            {
                starts[Math.Max(triangles[h], triangles[Next(h)]) + 1]++;
                sorted[count++] = h;
            }
        }

        Accumulate(starts);
        for (int i = 0; i < count; i++)
        {
            int h = sorted[i];
            spare[starts[Math.Max(triangles[h], triangles[Next(h)])]++] = h;
        }

        starts.Clear();
        for (int i = 0; i < count; i++)
        {
            int h = spare[i];
            starts[Math.Min(triangles[h], triangles[Next(h)]) + 1]++;
        }

        Accumulate(starts);
        for (int i = 0; i < count; i++)
        {
            int h = spare[i];
            sorted[starts[Math.Min(triangles[h], triangles[Next(h)])]++] = h;
        }

        return count;
    }

    private static void Accumulate(Span<int> starts)
    {
        for (int i = 1; i < starts.Length; i++)
        {
            starts[i] += starts[i - 1];
        }
    }

    /// <summary>Goes through the edges and leaves in <paramref name="fans"/> the number of fans of triangles around each vertex.</summary>
    private static EdgeCounts CountEdges(ReadOnlySpan<int> triangles, ReadOnlySpan<int> sorted, int[] opposites, Span<int> cornerSets, Span<int> fans)
    {
        var corners = new DisjointSets(cornerSets);
        var counts = default(EdgeCounts);
        fans.Clear();
        foreach (int h in sorted)
        {
            fans[triangles[h]]++;
        }

        for (int begin = 0; begin < sorted.Length;)
        {
            int first = sorted[begin];
            int from = triangles[first];
            int to = triangles[Next(first)];
            int end = begin + 1;
            while (end < sorted.Length && IsEdge(triangles, sorted[end], from, to))
            {
                int h = sorted[end++];
                bool same = triangles[h] == from;
                fans[from] -= corners.Join(first, same ? h : Next(h));
                fans[to] -= corners.Join(Next(first), same ? Next(h) : h);
            }

            int faces = end - begin;
            counts.All++;
            counts.Open += faces == 1 ? 1 : 0;
            counts.NonManifold += faces > 2 ? 1 : 0;
            counts.Winding += faces == 2 && triangles[sorted[begin + 1]] == from ? 1 : 0;
            if (faces > 1)
            {
                counts.DuplicateTriangles += CountDuplicates(triangles, sorted.Slice(begin, faces), Math.Max(from, to), opposites);
            }

            begin = end;
        }

        return counts;
    }

    private static bool IsEdge(ReadOnlySpan<int> triangles, int h, int from, int to)
    {
        int a = triangles[h];
        int b = triangles[Next(h)];
        return (a == from && b == to) || (a == to && b == from);
    }

    /// <summary>Triangles on one edge that have the same third vertex as another one; counted only where that vertex is above both of the edge's, which is once for each triangle.</summary>
    private static int CountDuplicates(ReadOnlySpan<int> triangles, ReadOnlySpan<int> edge, int high, int[] opposites)
    {
        int count = 0;
        foreach (int h in edge)
        {
            int opposite = triangles[Next(Next(h))];
            if (opposite > high)
            {
                opposites[count++] = opposite;
            }
        }

        if (count > 2)
        {
            Array.Sort(opposites, 0, count);
        }

        int duplicates = 0;
        for (int i = 1; i < count; i++)
        {
            duplicates += opposites[i] == opposites[i - 1] ? 1 : 0;
        }

        return duplicates;
    }

    private static int CountDegenerate(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles)
    {
        double twice = 2 * Tolerance.DegenerateAreaPerDiagonalSquared * PointBounds.Of(positions).DiagonalSquared;
        double min = twice * twice;
        int degenerate = 0;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            Vector3 a = positions[triangles[t]], b = positions[triangles[t + 1]], c = positions[triangles[t + 2]];
            double ux = (double)b.X - a.X, uy = (double)b.Y - a.Y, uz = (double)b.Z - a.Z;
            double vx = (double)c.X - a.X, vy = (double)c.Y - a.Y, vz = (double)c.Z - a.Z;
            double x = (uy * vz) - (uz * vy), y = (uz * vx) - (ux * vz), z = (ux * vy) - (uy * vx);
            double squared = (x * x) + (y * y) + (z * z);
            degenerate += squared > 0 && squared >= min ? 0 : 1;
        }

        return degenerate;
    }

    private static int CountNonFinite(ReadOnlySpan<Vector3> positions)
    {
        int count = 0;
        foreach (Vector3 p in positions)
        {
            count += TriangleList.IsFinite(p) ? 0 : 1;
        }

        return count;
    }

    private static int CountUnused(ReadOnlySpan<int> triangles, Span<int> marks)
    {
        marks.Clear();
        int unused = marks.Length;
        foreach (int v in triangles)
        {
            unused -= 1 - marks[v];
            marks[v] = 1;
        }

        return unused;
    }

    private static bool UsesAVertexTwice(ReadOnlySpan<int> triangles, int t) =>
        triangles[t] == triangles[t + 1] || triangles[t + 1] == triangles[t + 2] || triangles[t + 2] == triangles[t];

    private struct EdgeCounts
    {
        public int All;
        public int Open;
        public int NonManifold;
        public int Winding;
        public int DuplicateTriangles;
    }
}
