using System;

namespace CreatureGen.Geometry;

/// <summary>Finds the pieces of a surface of mirrored points whose triangles are not mirrored: their quadrangles are cut the same way round on both sides.</summary>
internal static class LopsidedPieces
{
    /// <summary>Says of each piece, at its index, whether one of its triangles has no mirror image.</summary>
    /// <param name="corners">Three points for each triangle.</param>
    /// <param name="twin">The mirror image of each point; a point on the plane, or without an image, is its own.</param>
    /// <param name="pieceOf">The piece of each point.</param>
    public static bool[] Find(ReadOnlySpan<int> corners, ReadOnlySpan<int> twin, ReadOnlySpan<int> pieceOf)
    {
        // Triangles by their least corner, of which few have the same.
        int[] start = new int[twin.Length + 1];
        for (int c = 0; c < corners.Length; c += 3)
        {
            start[Sorted(corners[c], corners[c + 1], corners[c + 2]).Least + 1]++;
        }

        for (int p = 0; p < twin.Length; p++)
        {
            start[p + 1] += start[p];
        }

        int[] filled = start[..^1];
        var others = new (int Middle, int Greatest)[corners.Length / 3];
        for (int c = 0; c < corners.Length; c += 3)
        {
            (int least, int middle, int greatest) = Sorted(corners[c], corners[c + 1], corners[c + 2]);
            others[filled[least]++] = (middle, greatest);
        }

        bool[] found = new bool[twin.Length];
        for (int c = 0; c < corners.Length; c += 3)
        {
            (int least, int middle, int greatest) = Sorted(twin[corners[c]], twin[corners[c + 1]], twin[corners[c + 2]]);
            found[pieceOf[corners[c]]] |= others.AsSpan(start[least], start[least + 1] - start[least]).IndexOf((middle, greatest)) < 0;
        }

        return found;
    }

    private static (int Least, int Middle, int Greatest) Sorted(int a, int b, int c)
    {
        int min = Math.Min(a, Math.Min(b, c)), max = Math.Max(a, Math.Max(b, c));
        return (min, a + b + c - min - max, max);
    }
}
