using System;

namespace CreatureGen.Geometry;

/// <summary>
/// The half of a drawn surface that says all about it: of pieces that are exact mirror images, or halves of one another, the left side alone; of all others everything.
/// </summary>
/// <remarks>A piece is halved when no triangle reaches across the plane of symmetry, each has an image, and each drawn vertex of the left stands for exactly one of the right.</remarks>
internal sealed class MirroredHalf
{
    private readonly int[] pointOf;
    private readonly int[] corners;
    private readonly int[] twin;
    private readonly sbyte[] side;
    private readonly int[] pieceOf;
    private readonly sbyte[] sideOf;

    /// <summary>Finds it.</summary>
    /// <param name="pointOf">The point of each drawn vertex.</param>
    /// <param name="corners">The point of each corner, three for each triangle.</param>
    /// <param name="vertices">The drawn vertex of each corner.</param>
    /// <param name="twin">The mirror image of each point; a point on the plane, or without an image, is its own.</param>
    /// <param name="side">The side that each point is on: 1 left, −1 right, 0 on the plane.</param>
    /// <param name="pieceOf">The piece of each point.</param>
    public MirroredHalf(int[] pointOf, int[] corners, ReadOnlySpan<int> vertices, int[] twin, sbyte[] side, int[] pieceOf)
    {
        this.pointOf = pointOf;
        this.corners = corners;
        this.twin = twin;
        this.side = side;
        this.pieceOf = pieceOf;
        IsHalved = new bool[twin.Length];
        Image = new int[pointOf.Length];
        Array.Fill(Image, -1);
        for (int p = 0; p < twin.Length; p++)
        {
            IsHalved[p] = true;
        }

        sideOf = new sbyte[corners.Length / 3];
        for (int t = 0; t < sideOf.Length; t++)
        {
            sideOf[t] = FindSide(t);
        }

        PairTriangles(vertices);
        int count = 0;
        int[] kept = new int[corners.Length / 3];
        for (int t = 0; t < kept.Length; t++)
        {
            kept[count] = t;
            count += IsHalved[pieceOf[corners[3 * t]]] && sideOf[t] < 0 ? 0 : 1;
        }

        Triangles = kept[..count];
        for (int v = 0; v < Image.Length; v++)
        {
            Image[v] = IsHalved[pieceOf[pointOf[v]]] ? Image[v] : -1;
        }
    }

    /// <summary>Whether a piece, at its index, is there with its left side alone.</summary>
    public bool[] IsHalved { get; }

    /// <summary>For each drawn vertex of the left side of a halved piece the one that is its image; −1 for all others.</summary>
    public int[] Image { get; }

    /// <summary>The triangles of the half, ascending.</summary>
    public int[] Triangles { get; }

    /// <summary>1 left, −1 right, 0 when it reaches across the plane or lies in it.</summary>
    private sbyte FindSide(int t)
    {
        int a = side[corners[3 * t]], b = side[corners[(3 * t) + 1]], c = side[corners[(3 * t) + 2]];
        int low = Math.Min(a, Math.Min(b, c)), high = Math.Max(a, Math.Max(b, c));
        return (sbyte)(low * high < 0 ? 0 : low + high);
    }

    private void PairTriangles(ReadOnlySpan<int> vertices)
    {
        // The triangles of the right by their least corner, of which few have the same.
        int[] start = new int[twin.Length + 1];
        int[] balance = new int[twin.Length];
        for (int t = 0; t < corners.Length / 3; t++)
        {
            int facing = sideOf[t];
            int piece = LeftOf(pieceOf[corners[3 * t]]);
            balance[piece] += facing;
            IsHalved[piece] &= facing != 0;
            if (facing < 0)
            {
                start[Least(corners[3 * t], corners[(3 * t) + 1], corners[(3 * t) + 2]) + 1]++;
            }
        }

        for (int p = 0; p < twin.Length; p++)
        {
            start[p + 1] += start[p];
        }

        int[] filled = start[..^1];
        int[] right = new int[start[^1]];
        for (int t = 0; t < corners.Length / 3; t++)
        {
            if (sideOf[t] < 0)
            {
                right[filled[Least(corners[3 * t], corners[(3 * t) + 1], corners[(3 * t) + 2])]++] = t;
            }
        }

        int[] imageOf = new int[pointOf.Length];
        Array.Fill(imageOf, -1);
        for (int t = 0; t < corners.Length / 3; t++)
        {
            int piece = LeftOf(pieceOf[corners[3 * t]]);
            if (sideOf[t] > 0 && IsHalved[piece])
            {
                IsHalved[piece] = balance[piece] == 0 && TryPair(t, vertices, right, start, imageOf);
            }
        }

        for (int p = 0; p < twin.Length; p++)
        {
            IsHalved[p] = IsHalved[LeftOf(pieceOf[p])];
        }
    }

    /// <summary>The lower index of a piece and its image: one stands for both.</summary>
    private int LeftOf(int piece) => Math.Min(piece, pieceOf[twin[piece]]);

    private bool TryPair(int t, ReadOnlySpan<int> vertices, int[] right, int[] start, int[] imageOf)
    {
        int a = twin[corners[3 * t]], b = twin[corners[(3 * t) + 1]], c = twin[corners[(3 * t) + 2]];
        int least = Least(a, b, c);
        for (int i = start[least]; i < start[least + 1]; i++)
        {
            int u = 3 * right[i];
            for (int turn = 0; turn < 3; turn++)
            {
                // An image is wound the other way.
                int second = u + ((turn + 2) % 3), third = u + ((turn + 1) % 3);
                if (corners[u + turn] == a && corners[second] == b && corners[third] == c)
                {
                    return Pair(vertices[3 * t], vertices[u + turn], imageOf) && Pair(vertices[(3 * t) + 1], vertices[second], imageOf) && Pair(vertices[(3 * t) + 2], vertices[third], imageOf);
                }
            }
        }

        return false;
    }

    private bool Pair(int left, int image, int[] imageOf)
    {
        if (Image[left] < 0 && imageOf[image] < 0)
        {
            Image[left] = image;
            imageOf[image] = left;
        }

        return Image[left] == image && imageOf[image] == left;
    }

    private static int Least(int a, int b, int c) => Math.Min(a, Math.Min(b, c));
}
