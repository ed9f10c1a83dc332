using System;
using System.Buffers;
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

        (bodyTriangles, BodyVertices) = LargestPiece(opaqueTriangles, welding.Positions.Length);
    }

    /// <summary>Distinct positions, metres.</summary>
    public ReadOnlySpan<Vector3> Positions => welding.Positions;

    /// <summary>Triangles of the opaque material, between distinct positions.</summary>
    public ReadOnlySpan<int> OpaqueTriangles => opaqueTriangles;

    /// <summary>Triangles of the largest piece of the opaque material, between distinct positions.</summary>
    public ReadOnlySpan<int> BodyTriangles => bodyTriangles;

    /// <summary>Distinct positions that <see cref="BodyTriangles"/> use.</summary>
    public int BodyVertices { get; }

    /// <summary>Whether a vertex is at a place, to the bit.</summary>
    public bool HasVertexAt(Vector3 place) => welding.IndexAt(place) >= 0;

    private static (int[] Triangles, int Vertices) LargestPiece(ReadOnlySpan<int> triangles, int vertices)
    {
        int[] pieceOf = ArrayPool<int>.Shared.Rent(vertices);
        int[] size = ArrayPool<int>.Shared.Rent(vertices);
        var pieces = new DisjointSets(pieceOf.AsSpan(0, vertices));
        Array.Clear(size, 0, vertices);
        for (int t = 0; t < triangles.Length; t += 3)
        {
            pieces.Join(triangles[t], triangles[t + 1]);
            pieces.Join(triangles[t], triangles[t + 2]);
        }

        pieces.Flatten();
        int largest = 0;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            int piece = pieceOf[triangles[t]];
            size[piece]++;
            largest = size[piece] > size[largest] ? piece : largest;
        }

        int[] kept = new int[3 * (vertices > 0 ? size[largest] : 0)];
        int count = 0;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            if (pieceOf[triangles[t]] == largest)
            {
                triangles.Slice(t, 3).CopyTo(kept.AsSpan(count));
                count += 3;
            }
        }

        int used = 0;
        for (int v = 0; v < vertices; v++)
        {
            used += pieceOf[v] == largest ? 1 : 0;
        }

        ArrayPool<int>.Shared.Return(pieceOf);
        ArrayPool<int>.Shared.Return(size);
        return (kept, used);
    }
}
