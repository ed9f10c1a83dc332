using System;
using System.Runtime.CompilerServices;

namespace CreatureGen.Geometry;

/// <summary>The neighbours of each vertex along the edges of the faces, in a fixed order.</summary>
internal sealed class SurfaceAdjacency
{
    private readonly int[] start;
    private readonly int[] neighbours;

    /// <summary>Reads a closed surface: each edge runs once each way, so the directed edges out of a vertex are its neighbours, each once.</summary>
    public SurfaceAdjacency(int vertices, Face[] faces)
    {
        start = new int[vertices + 1];
        foreach (Face f in faces)
        {
            start[f.A + 1]++;
            start[f.B + 1]++;
            start[f.C + 1]++;
            if (f.D != f.C)
            {
                start[f.D + 1]++;
            }
        }

        for (int v = 0; v < vertices; v++)
        {
            start[v + 1] += start[v];
        }

        neighbours = new int[start[vertices]];
        int[] next = (int[])start.Clone();
        foreach (Face f in faces)
        {
            neighbours[next[f.A]++] = f.B;
            neighbours[next[f.B]++] = f.C;
            if (f.D != f.C)
            {
                neighbours[next[f.C]++] = f.D;
                neighbours[next[f.D]++] = f.A;
            }
            else
            {
                neighbours[next[f.C]++] = f.A;
            }
        }
    }

    /// <summary>The neighbours of a vertex.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public ReadOnlySpan<int> Of(int vertex) => new(neighbours, start[vertex], start[vertex + 1] - start[vertex]);
}
