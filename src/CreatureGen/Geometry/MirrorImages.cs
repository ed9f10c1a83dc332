using System;

namespace CreatureGen.Geometry;

/// <summary>Finds the triangles of a mirrored surface that are images of others: what holds on the left side of it holds for them.</summary>
internal static class MirrorImages
{
    /// <summary>Says of each triangle whether it lies on the right side, in a piece whose triangles are mirrored and none of which reaches across the plane.</summary>
    /// <param name="corners">Three points for each triangle.</param>
    /// <param name="side">The side that each point is on: 1 left, −1 right, 0 on the plane.</param>
    /// <param name="pieceOf">The piece of each point.</param>
    /// <param name="lopsided">Of each piece whether its triangles are not mirrored.</param>
    public static bool[] Find(ReadOnlySpan<int> corners, ReadOnlySpan<sbyte> side, ReadOnlySpan<int> pieceOf, ReadOnlySpan<bool> lopsided)
    {
        bool[] reaches = new bool[side.Length];
        for (int c = 0; c < corners.Length; c += 3)
        {
            (int least, int greatest) = Sides(corners.Slice(c, 3), side);
            reaches[pieceOf[corners[c]]] |= least * greatest < 0;
        }

        bool[] isImage = new bool[corners.Length / 3];
        for (int t = 0; t < isImage.Length; t++)
        {
            int piece = pieceOf[corners[3 * t]];
            isImage[t] = !reaches[piece] && !lopsided[piece] && Sides(corners.Slice(3 * t, 3), side).Least < 0;
        }

        return isImage;
    }

    private static (int Least, int Greatest) Sides(ReadOnlySpan<int> triangle, ReadOnlySpan<sbyte> side)
    {
        int a = side[triangle[0]], b = side[triangle[1]], c = side[triangle[2]];
        return (Math.Min(a, Math.Min(b, c)), Math.Max(a, Math.Max(b, c)));
    }
}
