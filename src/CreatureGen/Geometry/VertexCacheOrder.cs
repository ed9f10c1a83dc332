using System;

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

        int[] start = new int[vertices + 1];
        int[] live = new int[vertices];
        int[] fans = TrianglesOfVertices(triangles, start, live);
        int[] entered = new int[vertices];
        bool[] emitted = new bool[count];
        int[] deadEnds = new int[triangles.Length];
        int deadEndCount = 0;
        int written = 0;
        int clock = CacheSize + 1;
        int cursor = 0;
        int fan = NextInInput(live, ref cursor);
        while (fan >= 0)
        {
            int ring = deadEndCount;
            for (int f = start[fan]; f < start[fan + 1]; f++)
            {
                int t = fans[f];
                if (emitted[t])
                {
                    continue;
                }

                emitted[t] = true;
                for (int k = 3 * t; k < (3 * t) + 3; k++)
                {
                    int v = triangles[k];
                    ordered[written++] = v;
                    deadEnds[deadEndCount++] = v;
                    live[v]--;
                    if (clock - entered[v] > CacheSize)
                    {
                        entered[v] = clock++;
                    }
                }
            }

            fan = NextInCache(deadEnds.AsSpan(ring, deadEndCount - ring), live, entered, clock);
            while (fan < 0 && deadEndCount > 0)
            {
                int v = deadEnds[--deadEndCount];
                fan = live[v] > 0 ? v : -1;
            }

            if (fan < 0)
            {
                fan = NextInInput(live, ref cursor);
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

    private static int[] TrianglesOfVertices(ReadOnlySpan<int> triangles, int[] start, int[] live)
    {
        foreach (int v in triangles)
        {
            live[v]++;
        }

        for (int v = 0; v < live.Length; v++)
        {
            start[v + 1] = start[v] + live[v];
        }

        int[] fans = new int[triangles.Length];
        int[] next = (int[])start.Clone();
        for (int i = 0; i < triangles.Length; i++)
        {
            fans[next[triangles[i]]++] = i / 3;
        }

        return fans;
    }

    /// <summary>Of the vertices just used, the one longest in the cache whose own triangles can all be drawn before it leaves; failing that, one that has triangles; −1 when none has.</summary>
    private static int NextInCache(ReadOnlySpan<int> ring, int[] live, int[] entered, int clock)
    {
        int best = -1;
        int longest = -1;
        foreach (int v in ring)
        {
            if (live[v] > 0)
            {
                int age = clock - entered[v];
                int priority = age + (2 * live[v]) <= CacheSize ? age : 0;
                if (priority > longest)
                {
                    longest = priority;
                    best = v;
                }
            }
        }

        return best;
    }

    private static int NextInInput(int[] live, ref int cursor)
    {
        while (cursor < live.Length && live[cursor] == 0)
        {
            cursor++;
        }

        return cursor < live.Length ? cursor : -1;
    }
}
