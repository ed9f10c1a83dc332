using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Geometry;

namespace CreatureGen.Inspection;

/// <summary>Counts how often a drawn surface cuts through itself, at rest or in any pose: welded once, counted as often as one likes.</summary>
internal sealed class CrossingCounter
{
    private readonly List<(int First, int Second)> pairs = new();
    private readonly SelfIntersectionWorkspace workspace = new();
    private readonly int[] triangles;
    private readonly int[] pieces;
    private readonly int[] vertices;
    private readonly Vector3[] positions;
    private readonly int body;

    /// <summary>Takes triangles over the vertices of a mesh: its own, or those of a level of detail.</summary>
    public CrossingCounter(CreatureMesh mesh, ReadOnlySpan<int> triangles)
    {
        VertexWelding welding = VertexWelding.Weld(mesh.Positions);
        positions = welding.Positions.ToArray();
        this.triangles = welding.Apply(triangles);
        vertices = new int[positions.Length];
        for (int v = mesh.Positions.Length - 1; v >= 0; v--)
        {
            vertices[welding.NewIndex[v]] = v;
        }

        var surface = new SurfacePieces(positions, this.triangles);
        pieces = surface.PieceOf;
        body = surface.Largest;
    }

    /// <summary>At rest.</summary>
    public SurfaceCrossings Count()
    {
        SelfIntersection.Find(positions, triangles, pairs, workspace);
        int inBody = 0;
        int inPieces = 0;
        foreach ((int first, int second) in pairs)
        {
            int piece = pieces[triangles[3 * first]];
            if (piece == pieces[triangles[3 * second]])
            {
                inBody += piece == body ? 1 : 0;
                inPieces += piece == body ? 0 : 1;
            }
        }

        return new SurfaceCrossings(inBody, inPieces);
    }

    /// <summary>With the vertices of the mesh where a pose has brought them.</summary>
    public SurfaceCrossings Count(ReadOnlySpan<Vector3> posed)
    {
        for (int p = 0; p < positions.Length; p++)
        {
            positions[p] = posed[vertices[p]];
        }

        return Count();
    }
}
