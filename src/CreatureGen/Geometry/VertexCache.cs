using System;
using System.Buffers;

namespace CreatureGen.Geometry;

/// <summary>How well an order of triangles uses a graphics processor's cache of transformed vertices, modelled as a queue: first in, first out.</summary>
internal static class VertexCache
{
    /// <summary>Average cache miss ratio: vertices transformed per triangle, 3 at worst and about one half at best. No triangles have a ratio of 0.</summary>
    /// <param name="vertices">Number of vertices.</param>
    /// <param name="triangles">Vertex indices, three per triangle.</param>
    /// <param name="cacheSize">Vertices that the cache holds, at least 3.</param>
    /// <exception cref="ArgumentException">The indices are not three per triangle, one is out of range, or the cache is too small.</exception>
    public static double MissRatio(int vertices, ReadOnlySpan<int> triangles, int cacheSize)
    {
        int count = TriangleList.Count(vertices, triangles);
        if (cacheSize < 3)
        {
            throw new ArgumentOutOfRangeException(nameof(cacheSize), FormattableString.Invariant($"a cache of {cacheSize} vertices; expected at least 3"));
        }

        // The number of the miss that last brought a vertex in; it leaves when as many misses as the cache is long have followed.
        int[] entered = ArrayPool<int>.Shared.Rent(vertices);
        Array.Fill(entered, -cacheSize, 0, vertices);
        int misses = 0;
        foreach (int v in triangles)
        {
            if (misses - entered[v] >= cacheSize)
            {
                entered[v] = misses++;
            }
        }

        ArrayPool<int>.Shared.Return(entered);
        return count == 0 ? 0 : (double)misses / count;
    }
}
