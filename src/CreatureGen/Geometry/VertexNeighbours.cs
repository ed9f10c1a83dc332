using System;
using System.Buffers;

namespace CreatureGen.Geometry;

/// <summary>The neighbours of each vertex of an index buffer along the edges of the triangles, each once, in a fixed order; the mesh may be open.</summary>
/// <remarks>The long list lies in memory borrowed from the pool, which disposing gives back; nothing may be asked then.</remarks>
internal sealed class VertexNeighbours : IDisposable
{
    private readonly int[] start;
    private int[] neighbours;

    /// <summary>Reads an index buffer whose indices are in range.</summary>
    public VertexNeighbours(int vertices, ReadOnlySpan<int> triangles)
    {
        int[] slots = new int[vertices + 1];
        foreach (int v in triangles)
        {
            slots[v + 1] += 2;
        }

        for (int v = 0; v < vertices; v++)
        {
            slots[v + 1] += slots[v];
        }

        int[] all = ArrayPool<int>.Shared.Rent(2 * triangles.Length);
        int[] next = (int[])slots.Clone();
        for (int t = 0; t + 2 < triangles.Length; t += 3)
        {
            int a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
            all[next[a]++] = b;
            all[next[a]++] = c;
            all[next[b]++] = c;
            all[next[b]++] = a;
            all[next[c]++] = a;
            all[next[c]++] = b;
        }

        start = new int[vertices + 1];
        neighbours = all;
        int[] seenBy = next;
        Array.Fill(seenBy, -1);
        int kept = 0;
        for (int v = 0; v < vertices; v++)
        {
            seenBy[v] = v;
            for (int i = slots[v]; i < slots[v + 1]; i++)
            {
                int n = all[i];
                if (seenBy[n] != v)
                {
                    seenBy[n] = v;
                    neighbours[kept++] = n;
                }
            }

            start[v + 1] = kept;
        }
    }

    /// <summary>The number of vertices.</summary>
    public int Count => start.Length - 1;

    /// <inheritdoc/>
    public void Dispose()
    {
        if (neighbours.Length > 0)
        {
            ArrayPool<int>.Shared.Return(neighbours);
            neighbours = Array.Empty<int>();
        }
    }

    /// <summary>The neighbours of a vertex.</summary>
    public ReadOnlySpan<int> Of(int vertex) => new(neighbours, start[vertex], start[vertex + 1] - start[vertex]);
}
