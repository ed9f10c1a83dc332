using System;
using System.Buffers;

namespace CreatureGen.Geometry;

/// <summary>Whether the triangles around each vertex follow one another in a ring, which tells a closed surface several times faster than sorting its edges.</summary>
internal static class VertexRings
{
    /// <summary>Fewer corners in a ring are two triangles back to back.</summary>
    private const int MinCorners = 3;

    /// <summary>
    /// True when the triangles around each vertex make up one ring of three and more. The surface is closed then, each of its edges has two triangles that run along it in opposite directions, no vertex is pinched, and no triangle is there twice.
    /// </summary>
    /// <param name="vertices">Their number.</param>
    /// <param name="triangles">Vertex indices in range, three per triangle.</param>
    /// <param name="used">Vertices that triangles use, where all are rings.</param>
    public static bool AreWhole(int vertices, ReadOnlySpan<int> triangles, out int used)
    {
        int[] ends = ArrayPool<int>.Shared.Rent(vertices + 1);
        (int From, int To)[] spans = ArrayPool<(int From, int To)>.Shared.Rent(triangles.Length);
        (int Centre, int To)[] steps = ArrayPool<(int Centre, int To)>.Shared.Rent(vertices);
        try
        {
            GroupByVertex(triangles, ends.AsSpan(0, vertices + 1), spans);
            Array.Fill(steps, (-1, 0), 0, vertices);
            used = 0;
            for (int v = 0, begin = 0; v < vertices; v++)
            {
                int end = ends[v];
                if (end > begin)
                {
                    used++;
                    if (!IsRing(v, spans.AsSpan(begin, end - begin), steps))
                    {
                        return false;
                    }
                }

                begin = end;
            }

            return true;
        }
        finally
        {
            ArrayPool<int>.Shared.Return(ends);
            ArrayPool<(int From, int To)>.Shared.Return(spans);
            ArrayPool<(int Centre, int To)>.Shared.Return(steps);
        }
    }

    /// <summary>For each vertex the other two corners of each of its triangles, in their order around it; those of vertex v end where <paramref name="ends"/> says.</summary>
    private static void GroupByVertex(ReadOnlySpan<int> triangles, Span<int> ends, Span<(int From, int To)> spans)
    {
        ends.Clear();
        foreach (int v in triangles)
        {
            ends[v + 1]++;
        }

        for (int i = 1; i < ends.Length; i++)
        {
            ends[i] += ends[i - 1];
        }

        for (int t = 0; t < triangles.Length; t += 3)
        {
            int a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
            spans[ends[a]++] = (b, c);
            spans[ends[b]++] = (c, a);
            spans[ends[c]++] = (a, b);
        }
    }

    /// <summary>Whether from the first corner the steps lead through all and no sooner back to it.</summary>
    /// <param name="centre">The vertex.</param>
    /// <param name="spans">Where each of its triangles begins and ends around it.</param>
    /// <param name="steps">For each vertex the centre around which a triangle begins there, and where that triangle ends.</param>
    private static bool IsRing(int centre, ReadOnlySpan<(int From, int To)> spans, Span<(int Centre, int To)> steps)
    {
        if (spans.Length < MinCorners)
        {
            return false;
        }

        foreach ((int from, int to) in spans)
        {
            if (steps[from].Centre == centre || from == centre || to == centre)
            {
                return false;
            }

            steps[from] = (centre, to);
        }

        int first = spans[0].From;
        int at = first;
        for (int left = spans.Length; left > 0; left--)
        {
            (int around, int to) = steps[at];
            if (around != centre || (to == first && left > 1))
            {
                return false;
            }

            at = to;
        }

        return at == first;
    }
}
