using System;
using System.Collections.Generic;
using System.Numerics;

namespace CreatureGen.Geometry;

/// <summary>Finds where what is left of a surface cuts through itself, piece by piece.</summary>
internal sealed class CrossingSearch : IDisposable
{
    /// <summary>The buffers of the last search that was disposed of: they are large, and as long as those of the next one.</summary>
    [ThreadStatic]
    private static SelfIntersectionWorkspace? spare;

    private readonly Vector3[] positions;
    private readonly int[] corners;
    private readonly int[] pieceOf;
    private readonly SelfIntersectionWorkspace workspace;
    private readonly int[] left;
    private readonly bool[] touched;
    private readonly List<(int First, int Second)> pairs = new();
    private readonly int[] finest;
    private readonly bool[] inherited;
    private bool knowsFinest;

    /// <summary>Takes the surface.</summary>
    /// <param name="positions">Place of each point.</param>
    /// <param name="corners">The point of each corner, three for each triangle, as a reduction changes them.</param>
    /// <param name="pieceOf">The piece of each point.</param>
    /// <param name="box">The box of the whole of which the surface is a part.</param>
    public CrossingSearch(Vector3[] positions, int[] corners, int[] pieceOf, PointBounds box)
    {
        // What counts as a crossing depends on the size of the whole: its box is told by two points of no triangle.
        this.positions = new Vector3[positions.Length + 2];
        positions.CopyTo(this.positions, 0);
        this.positions[^2] = box.Min;
        this.positions[^1] = box.Max;
        this.corners = corners;
        this.pieceOf = pieceOf;
        workspace = spare ?? new SelfIntersectionWorkspace();
        spare = null;
        left = new int[corners.Length];
        touched = new bool[positions.Length];
        inherited = new bool[positions.Length];
        finest = (int[])corners.Clone();
    }

    /// <summary>Searches what is left, and tells the pairs of triangles of one piece.</summary>
    public int Find(CollapsingMesh surface)
    {
        int count = 0;
        for (int c = 0; c < corners.Length; c += 3)
        {
            if (!surface.IsGone(c / 3))
            {
                left[count] = corners[c];
                left[count + 1] = corners[c + 1];
                left[count + 2] = corners[c + 2];
                count += 3;
            }
        }

        if (workspace.Find(positions, left.AsSpan(0, count), pairs, pieceOf) > 0 && !knowsFinest)
        {
            knowsFinest = true;
            workspace.Find(positions, finest, pairs, pieceOf);
            Touch(finest);
            Inherit();
            workspace.Find(positions, left.AsSpan(0, count), pairs, pieceOf);
        }

        return Touch(left);
    }

    /// <summary>Takes what was found for given: it does not count from now on.</summary>
    public void Inherit()
    {
        for (int p = 0; p < touched.Length; p++)
        {
            inherited[p] |= touched[p];
        }
    }

    private int Touch(int[] triangles)
    {
        Array.Clear(touched, 0, touched.Length);
        int found = 0;
        foreach ((int first, int second) in pairs)
        {
            ReadOnlySpan<int> a = triangles.AsSpan(3 * first, 3), b = triangles.AsSpan(3 * second, 3);
            if (!IsInherited(a) && !IsInherited(b))
            {
                found++;
                for (int c = 0; c < 3; c++)
                {
                    touched[a[c]] = true;
                    touched[b[c]] = true;
                }
            }
        }

        return found;
    }

    private bool IsInherited(ReadOnlySpan<int> triangle) => inherited[triangle[0]] || inherited[triangle[1]] || inherited[triangle[2]];

    /// <summary>Whether a point is a corner of one of the triangles that were found.</summary>
    public bool Touches(int point) => touched[point];

    /// <inheritdoc/>
    public void Dispose() => spare = workspace;
}
