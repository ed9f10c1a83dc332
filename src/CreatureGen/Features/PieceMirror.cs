using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>The same piece on the other side of the body.</summary>
internal static class PieceMirror
{
    /// <summary>
    /// The mirror image of a piece (x → −x, winding reversed), vertex by vertex; colours are shared with the original.
    /// </summary>
    /// <param name="piece">The original.</param>
    /// <param name="binding">What the image moves with.</param>
    public static Piece Mirror(Piece piece, PieceBinding binding)
    {
        var positions = new Vector3[piece.Positions.Length];
        var normals = new Vector3[positions.Length];
        for (int v = 0; v < positions.Length; v++)
        {
            positions[v] = Vec.Mirror(piece.Positions[v]);
            normals[v] = Vec.Mirror(piece.Normals[v]);
        }

        int[] triangles = (int[])piece.Triangles.Clone();
        for (int i = 0; i < triangles.Length; i += 3)
        {
            (triangles[i + 1], triangles[i + 2]) = (triangles[i + 2], triangles[i + 1]);
        }

        return new Piece(binding)
        {
            Positions = positions,
            Normals = normals,
            Colours = piece.Colours,
            Triangles = triangles,
            Material = piece.Material,
            Finish = piece.Finish,
            SimplificationWeight = piece.SimplificationWeight,
        };
    }
}
