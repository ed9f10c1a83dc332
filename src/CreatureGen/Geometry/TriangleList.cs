using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Geometry;

/// <summary>What every measure of a triangle mesh needs of its two buffers.</summary>
internal static class TriangleList
{
    /// <summary>The number of triangles of an index buffer.</summary>
    /// <exception cref="ArgumentException">The indices are not three per triangle, or one is out of range.</exception>
    public static int Count(int vertices, ReadOnlySpan<int> triangles)
    {
        if (triangles.Length % 3 != 0)
        {
            throw new ArgumentException(FormattableString.Invariant($"{triangles.Length} indices; expected three per triangle"), nameof(triangles));
        }

        for (int i = 0; i < triangles.Length; i++)
        {
            if ((uint)triangles[i] >= (uint)vertices)
            {
                throw new ArgumentException(FormattableString.Invariant($"triangles[{i}] = {triangles[i]}; expected a vertex of 0..{vertices - 1}"), nameof(triangles));
            }
        }

        return triangles.Length / 3;
    }

    /// <summary>True when no coordinate is infinite or not a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsFinite(Vector3 p) => (p.X - p.X) + (p.Y - p.Y) + (p.Z - p.Z) == 0;

    /// <exception cref="ArgumentException">A position is not finite.</exception>
    public static void RequireFinite(ReadOnlySpan<Vector3> positions)
    {
        for (int v = 0; v < positions.Length; v++)
        {
            if (!IsFinite(positions[v]))
            {
                Vector3 p = positions[v];
                throw new ArgumentException(FormattableString.Invariant($"positions[{v}] = ({p.X}, {p.Y}, {p.Z}); expected finite coordinates"), nameof(positions));
            }
        }
    }
}
