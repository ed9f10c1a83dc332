using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Geometry;

namespace CreatureGen.Inspection;

/// <summary>A drawn mesh welded again by equal positions, and its largest piece: the body with its limbs, without what is set into it.</summary>
internal sealed class WeldedSkin
{
    private readonly VertexWelding welding;
    private readonly int[] opaqueTriangles;
    private readonly int[] bodyTriangles;

    public WeldedSkin(CreatureMesh mesh)
    {
        welding = VertexWelding.Weld(mesh.Positions);
        opaqueTriangles = Array.Empty<int>();
        foreach (MeshPart part in mesh.Parts)
        {
            if (part.Material == MaterialKind.Skin)
            {
                opaqueTriangles = welding.Apply(mesh.Triangles.Slice(part.FirstIndex, part.IndexCount));
            }
        }

        bodyTriangles = LargestPiece(opaqueTriangles, welding.Positions.Length);
    }

    /// <summary>Distinct positions, metres.</summary>
    public ReadOnlySpan<Vector3> Positions => welding.Positions;

    /// <summary>Triangles of the opaque material, between distinct positions.</summary>
    public ReadOnlySpan<int> OpaqueTriangles => opaqueTriangles;

    /// <summary>Triangles of the largest piece of the opaque material, between distinct positions.</summary>
    public ReadOnlySpan<int> BodyTriangles => bodyTriangles;

    private static int[] LargestPiece(ReadOnlySpan<int> triangles, int vertices)
    {
        int[] sets = new int[vertices];
        var pieces = new DisjointSets(sets);
        for (int t = 0; t < triangles.Length; t += 3)
        {
            pieces.Join(triangles[t], triangles[t + 1]);
            pieces.Join(triangles[t], triangles[t + 2]);
        }

        int[] size = new int[vertices];
        int largest = 0;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            int piece = pieces.Root(triangles[t]);
            size[piece]++;
            largest = size[piece] > size[largest] ? piece : largest;
        }

        var kept = new List<int>(triangles.Length);
        for (int t = 0; t < triangles.Length; t += 3)
        {
            if (pieces.Root(triangles[t]) == largest)
            {
                kept.Add(triangles[t]);
                kept.Add(triangles[t + 1]);
                kept.Add(triangles[t + 2]);
            }
        }

        return kept.ToArray();
    }
}
