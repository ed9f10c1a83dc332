using System;
using System.Buffers;

namespace CreatureGen.Geometry;

/// <summary>Orders of triangles and vertices that are quick to draw.</summary>
internal static class VertexCacheOrder
{
    /// <summary>The cache that <see cref="Triangles"/> orders for; the smallest in use, and larger ones gain as well.</summary>
    public const int CacheSize = 16;

    /// <summary>Writes the triangles in an order that finds most vertices still in the cache. Each triangle keeps its corners in their order.</summary>
    /// <param name="vertices">Number of vertices.</param>
    /// <param name="triangles">Vertex indices, three per triangle.</param>
    /// <param name="ordered">Receives the triangles, as long as <paramref name="triangles"/> and no part of it.</param>
    /// <remarks>Based on: P. V. Sander, D. Nehab and J. Barczak 2007, "Fast triangle reordering for vertex locality and reduced overdraw" (Tipsify): fans around one vertex after another, in linear time.</remarks>
    /// <exception cref="ArgumentException">The indices are not three per triangle, one is out of range, or the output has another length.</exception>
    public static void Triangles(int vertices, ReadOnlySpan<int> triangles, Span<int> ordered)
    {
        int count = TriangleList.Count(vertices, triangles);
        if (ordered.Length != triangles.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"room for {ordered.Length} indices; expected {triangles.Length}"), nameof(ordered));
        }

        // One structure for each vertex, since what is asked of it is asked together; lists are rented, for those of a creature are large enough to make the collector clear up behind each of them.
        ArrayPool<Vertex> vertexPool = ArrayPool<Vertex>.Shared;
        ArrayPool<int> pool = ArrayPool<int>.Shared;
        Vertex[] rented = vertexPool.Rent(vertices + 1);
        int[] fans = pool.Rent(triangles.Length);
        int[] deadEnds = pool.Rent(triangles.Length);
        bool[] emitted = ArrayPool<bool>.Shared.Rent(count);
        Array.Clear(rented, 0, vertices + 1);
        Array.Clear(emitted, 0, count);
        FanOut(triangles, rented.AsSpan(0, vertices + 1), fans);
        Order(triangles, rented.AsSpan(0, vertices + 1), fans, emitted, deadEnds, ordered);
        ArrayPool<bool>.Shared.Return(emitted);
        pool.Return(deadEnds);
        pool.Return(fans);
        vertexPool.Return(rented);
    }

    private static void Order(ReadOnlySpan<int> triangles, Span<Vertex> vertices, int[] fans, bool[] emitted, int[] deadEnds, Span<int> ordered)
    {
        int deadEndCount = 0;
        int written = 0;
        int clock = CacheSize + 1;
        int cursor = 0;
        int fan = NextInInput(vertices, ref cursor);
        while (fan >= 0)
        {
            int ring = deadEndCount;
            int end = vertices[fan + 1].Start;
            for (int f = vertices[fan].Start; f < end; f++)
            {
                int t = fans[f];
                if (emitted[t])
                {
                    continue;
                }

                emitted[t] = true;
                ReadOnlySpan<int> corners = triangles.Slice(3 * t, 3);
                for (int k = 0; k < corners.Length; k++)
                {
                    int v = corners[k];
                    ordered[written++] = v;

                    // The fan itself is done: nobody need look at it again.
                    if (v != fan)
                    {
                        deadEnds[deadEndCount++] = v;
                    }

                    ref Vertex vertex = ref vertices[v];
                    vertex.Live--;
                    if (clock - vertex.Entered > CacheSize)
                    {
                        vertex.Entered = clock++;
                    }
                }
            }

            fan = NextInCache(deadEnds.AsSpan(ring, deadEndCount - ring), vertices, clock);
            while (fan < 0 && deadEndCount > 0)
            {
                int v = deadEnds[--deadEndCount];
                fan = vertices[v].Live > 0 ? v : -1;
            }

            if (fan < 0)
            {
                fan = NextInInput(vertices, ref cursor);
            }
        }
    }

    /// <summary>Numbers the vertices in the order in which the triangles first use them, those without a triangle last, and renumbers the triangles.</summary>
    /// <param name="triangles">Vertex indices, three per triangle; renumbered in place.</param>
    /// <param name="newIndex">Receives the new index of each vertex; one entry per vertex.</param>
    /// <returns>The number of vertices in use.</returns>
    /// <exception cref="ArgumentException">The indices are not three per triangle, or one is out of range.</exception>
    public static int Vertices(Span<int> triangles, Span<int> newIndex)
    {
        TriangleList.Count(newIndex.Length, triangles);
        newIndex.Fill(-1);
        int used = 0;
        for (int i = 0; i < triangles.Length; i++)
        {
            ref int index = ref newIndex[triangles[i]];
            if (index < 0)
            {
                index = used++;
            }

            triangles[i] = index;
        }

        int next = used;
        for (int v = 0; v < newIndex.Length; v++)
        {
            if (newIndex[v] < 0)
            {
                newIndex[v] = next++;
            }
        }

        return used;
    }

    /// <summary>Lists the triangles of each vertex, in their order; the last of the vertices is none and tells where the lists end.</summary>
    private static void FanOut(ReadOnlySpan<int> triangles, Span<Vertex> vertices, int[] fans)
    {
        foreach (int v in triangles)
        {
            vertices[v].Live++;
        }

        // Where each list ends; filled from its end, it is where it begins.
        int end = 0;
        for (int v = 0; v < vertices.Length; v++)
        {
            end += vertices[v].Live;
            vertices[v].Start = end;
        }

        for (int t = (triangles.Length / 3) - 1; t >= 0; t--)
        {
            ReadOnlySpan<int> corners = triangles.Slice(3 * t, 3);
            for (int k = 0; k < corners.Length; k++)
            {
                fans[--vertices[corners[k]].Start] = t;
            }
        }
    }

    /// <summary>Of the vertices just used, the one longest in the cache whose own triangles can all be drawn before it leaves; failing that, one that has triangles; −1 when none has.</summary>
    private static int NextInCache(ReadOnlySpan<int> ring, Span<Vertex> vertices, int clock)
    {
        int best = -1;
        int longest = -1;
        foreach (int v in ring)
        {
            ref Vertex vertex = ref vertices[v];
            if (vertex.Live > 0)
            {
                int age = clock - vertex.Entered;
                int priority = age + (2 * vertex.Live) <= CacheSize ? age : 0;
                if (priority > longest)
                {
                    longest = priority;
                    best = v;
                }
            }
        }

        return best;
    }

    private static int NextInInput(Span<Vertex> vertices, ref int cursor)
    {
        while (cursor < vertices.Length && vertices[cursor].Live == 0)
        {
            cursor++;
        }

        return cursor < vertices.Length ? cursor : -1;
    }

    /// <summary>What is known of a vertex.</summary>
    private struct Vertex
    {
        /// <summary>How many of its triangles have not been written.</summary>
        public int Live;

        /// <summary>When it last came into the cache.</summary>
        public int Entered;

        /// <summary>The first of its triangles in the list of all fans.</summary>
        public int Start;
    }
}
