using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>The mirror images of the triangles of a surface, as long as its two sides are exact images of one another. Buffers grow and are kept.</summary>
internal sealed class TriangleImages
{
    // The triangles of the right by their least corner: the last of each, and the one before each; plus one, so that zero is none.
    private int[] last = Array.Empty<int>();
    private int[] before = Array.Empty<int>();
    private bool known;

    /// <summary>Knows of no surface.</summary>
    public void Clear() => known = false;

    /// <summary>Finds the triangles of the right side of a surface, if that is the exact image of the left.</summary>
    /// <param name="positions">One per vertex.</param>
    /// <param name="triangles">Vertex indices, three per triangle.</param>
    /// <param name="mirror">For each vertex its mirror image in the plane x = 0.</param>
    public void Find(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, ReadOnlySpan<int> mirror)
    {
        known = AreImages(positions, mirror, default);
        if (!known)
        {
            return;
        }

        if (last.Length < positions.Length || before.Length < triangles.Length / 3)
        {
            last = new int[positions.Length];
            before = new int[triangles.Length / 3];
        }

        Array.Clear(last, 0, positions.Length);
        for (int t = 0; t < triangles.Length / 3; t++)
        {
            int a = triangles[3 * t], b = triangles[(3 * t) + 1], c = triangles[(3 * t) + 2];
            if (positions[a].X < 0f || positions[b].X < 0f || positions[c].X < 0f)
            {
                ref int end = ref last[Math.Min(a, Math.Min(b, c))];
                before[t] = end;
                end = t + 1;
            }
        }
    }

    /// <summary>Whether the sides are still exact images of one another after some points have moved together with their images.</summary>
    public bool Hold(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> mirror, ReadOnlySpan<bool> moved) => known &= AreImages(positions, mirror, moved);

    /// <summary>The image of a triangle of the left; −1 when there is none.</summary>
    public int Of(int triangle, ReadOnlySpan<int> triangles, ReadOnlySpan<int> mirror)
    {
        if (!known)
        {
            return -1;
        }

        int a = mirror[triangles[3 * triangle]], b = mirror[triangles[(3 * triangle) + 1]], c = mirror[triangles[(3 * triangle) + 2]];
        int image = last[Math.Min(a, Math.Min(b, c))] - 1;
        while (image >= 0 && !(Has(triangles, image, a) && Has(triangles, image, b) && Has(triangles, image, c)))
        {
            image = before[image] - 1;
        }

        return image;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool Has(ReadOnlySpan<int> triangles, int t, int vertex) => triangles[3 * t] == vertex || triangles[(3 * t) + 1] == vertex || triangles[(3 * t) + 2] == vertex;

    private static bool AreImages(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> mirror, ReadOnlySpan<bool> moved)
    {
        for (int v = 0; v < mirror.Length; v++)
        {
            bool asked = moved.IsEmpty || moved[v];
            if (asked && ((!moved.IsEmpty && !moved[mirror[v]]) || positions[mirror[v]] != Vec.Mirror(positions[v])))
            {
                return false;
            }
        }

        return true;
    }
}
