using System;
using System.Collections.Generic;
using System.Numerics;

namespace CreatureGen.Geometry;

/// <summary>Finds where a surface cuts through itself.</summary>
/// <remarks>
/// A pair of triangles counts when the two share no vertex, each has corners behind the other's plane and corners that are not, and they have a segment
/// longer than <see cref="Maths.Tolerance.CrossingLengthPerDiagonal"/> of the diagonal of the box of all positions in common. A corner as near as that to the
/// other's plane is taken to be in front of it, so contact from outside, and triangles in one plane, are no crossing.
/// Vertices are the same only when their indices are: a mesh whose vertices are split for drawing goes through <see cref="VertexWelding"/> first.
/// Triangles with a corner that is not finite cross none.
/// </remarks>
internal static class SelfIntersection
{
    /// <summary>Finds all pairs of crossing triangles.</summary>
    /// <param name="positions">One per vertex.</param>
    /// <param name="triangles">Vertex indices, three per triangle.</param>
    /// <param name="pairs">Receives the pairs in place of what it held, ascending by their first and then their second triangle; the first is the lower of the two.</param>
    /// <returns>The number of pairs.</returns>
    /// <exception cref="ArgumentException">The indices are not three per triangle, or one is out of range.</exception>
    public static int Find(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, List<(int First, int Second)> pairs) =>
        Find(positions, triangles, pairs, new SelfIntersectionWorkspace());

    /// <summary>Finds all pairs of crossing triangles in buffers that are used again: nothing is allocated once they have grown to the size of the mesh.</summary>
    /// <param name="positions">One per vertex.</param>
    /// <param name="triangles">Vertex indices, three per triangle.</param>
    /// <param name="pairs">Receives the pairs in place of what it held, ascending by their first and then their second triangle; the first is the lower of the two.</param>
    /// <param name="workspace">The buffers.</param>
    /// <returns>The number of pairs.</returns>
    /// <exception cref="ArgumentException">The indices are not three per triangle, or one is out of range.</exception>
    public static int Find(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, List<(int First, int Second)> pairs, SelfIntersectionWorkspace workspace)
    {
        if (pairs is null)
        {
            throw new ArgumentNullException(nameof(pairs));
        }

        if (workspace is null)
        {
            throw new ArgumentNullException(nameof(workspace));
        }

        TriangleList.Count(positions.Length, triangles);
        return workspace.Find(positions, triangles, pairs);
    }
}
