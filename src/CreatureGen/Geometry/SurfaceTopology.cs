using System;
using System.Numerics;

namespace CreatureGen.Geometry;

/// <summary>How a triangle mesh hangs together, and what is wrong with it.</summary>
/// <remarks>
/// Vertices are the same only when their indices are: a mesh whose vertices are split for drawing goes through <see cref="VertexWelding"/> first.
/// Triangles that use a vertex twice have no place in the topology; they count as degenerate and nowhere else.
/// </remarks>
internal sealed record SurfaceTopology
{
    internal SurfaceTopology()
    {
    }

    /// <summary>Triangles in the index buffer.</summary>
    public int Triangles { get; internal init; }

    /// <summary>Distinct edges.</summary>
    public int Edges { get; internal init; }

    /// <summary>Edges of one triangle.</summary>
    public int OpenEdges { get; internal init; }

    /// <summary>Edges of three or more triangles.</summary>
    public int NonManifoldEdges { get; internal init; }

    /// <summary>Edges whose two triangles run along them in the same direction, so that one of the two is turned over.</summary>
    public int WindingEdges { get; internal init; }

    /// <summary>Vertices in which several fans of triangles meet that have no edge in common there.</summary>
    public int PinchedVertices { get; internal init; }

    /// <summary>Vertices in use − edges + triangles: twice the number of pieces − twice the number of handles when the surface is closed.</summary>
    public int EulerCharacteristic { get; internal init; }

    /// <summary>Triangles with the same three vertices as an earlier one, whatever their winding.</summary>
    public int DuplicateTriangles { get; internal init; }

    /// <summary>Triangles whose area is zero, not a number, or below <see cref="Maths.Tolerance.DegenerateAreaPerDiagonalSquared"/> of the squared diagonal of the box of all finite positions.</summary>
    public int DegenerateTriangles { get; internal init; }

    /// <summary>Positions with an infinite coordinate or one that is not a number.</summary>
    public int NonFinitePositions { get; internal init; }

    /// <summary>Vertices that no triangle uses.</summary>
    public int UnusedVertices { get; internal init; }

    /// <summary>True when the mesh has triangles and is a closed, consistently wound two-manifold: every edge has two triangles that run along it in opposite directions, and no vertex is pinched.</summary>
    public bool IsClosed => Edges > 0 && OpenEdges == 0 && NonManifoldEdges == 0 && WindingEdges == 0 && PinchedVertices == 0;

    /// <summary>True when the mesh is closed and has no duplicate or degenerate triangle, no position that is not finite and no vertex without a triangle.</summary>
    public bool IsSound => IsClosed && DuplicateTriangles == 0 && DegenerateTriangles == 0 && NonFinitePositions == 0 && UnusedVertices == 0;

    /// <summary>Examines a mesh.</summary>
    /// <param name="positions">One per vertex.</param>
    /// <param name="triangles">Vertex indices, three per triangle.</param>
    /// <exception cref="ArgumentException">The indices are not three per triangle, or one is out of range.</exception>
    public static SurfaceTopology Of(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles)
    {
        TriangleList.Count(positions.Length, triangles);
        return TopologySurvey.Examine(positions, triangles);
    }
}
