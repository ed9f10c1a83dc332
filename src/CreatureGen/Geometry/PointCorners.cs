using System;
using System.Buffers;

namespace CreatureGen.Geometry;

/// <summary>The corners of each point of a surface, side by side, as points take the place of others.</summary>
/// <remarks>A point that takes the place of another one gets a new place at the end, for its own corners and those of the other. What lies there before is left as it is, so that the last step can be taken back. The lists are borrowed from the pool.</remarks>
internal sealed class PointCorners : IDisposable
{
    private readonly int[] start;
    private readonly int[] count;
    private readonly SavedArrays saved;
    private int[] corners;
    private int[] savedCorners = Array.Empty<int>();
    private int end;
    private int savedEnd;
    private (int Point, int Start, int Count, int Gone, int CountOfGone) step;

    /// <summary>Lists the corners of each point, ascending.</summary>
    /// <param name="positions">Number of points.</param>
    /// <param name="points">The point of each corner.</param>
    public PointCorners(int positions, ReadOnlySpan<int> points)
    {
        start = new int[positions];
        count = new int[positions];
        corners = ArrayPool<int>.Shared.Rent(2 * points.Length);
        foreach (int p in points)
        {
            count[p]++;
        }

        for (int p = 0; p < positions; p++)
        {
            start[p] = end;
            end += count[p];
            count[p] = 0;
        }

        for (int c = 0; c < points.Length; c++)
        {
            corners[start[points[c]] + count[points[c]]++] = c;
        }

        saved = new SavedArrays(start, count);
    }

    /// <summary>The corners of a point; none when it has gone.</summary>
    public ReadOnlySpan<int> Of(int point) => new(corners, start[point], count[point]);

    /// <summary>How many corners a point has.</summary>
    public int CountOf(int point) => count[point];

    /// <summary>Room for all corners of two points; what is written there becomes those of one of them with <see cref="Replace"/>.</summary>
    public Span<int> RoomFor(int point, int other)
    {
        int room = count[point] + count[other];
        if (corners.Length < end + room)
        {
            int[] larger = ArrayPool<int>.Shared.Rent(2 * (end + room));
            Array.Copy(corners, larger, end);
            GiveBack(corners);
            corners = larger;
        }

        return corners.AsSpan(end, room);
    }

    /// <summary>Lets a point have the first of the corners that were written where there was room, and another one none.</summary>
    public void Replace(int point, int length, int gone)
    {
        step = (point, start[point], count[point], gone, count[gone]);
        start[point] = end;
        count[point] = length;
        count[gone] = 0;
        end += length;
    }

    /// <summary>Takes the last <see cref="Replace"/> back.</summary>
    public void Undo()
    {
        end = start[step.Point];
        start[step.Point] = step.Start;
        count[step.Point] = step.Count;
        count[step.Gone] = step.CountOfGone;
    }

    /// <summary>Takes the corner of a triangle from a point, and leaves it behind the others.</summary>
    public void Drop(int triangle, int point)
    {
        Span<int> own = corners.AsSpan(start[point], count[point]);
        int at = 0;
        while (TriangleCorner.TriangleOf(own[at]) != triangle)
        {
            at++;
        }

        (own[at], own[^1]) = (own[^1], own[at]);
        count[point]--;
    }

    /// <summary>Gives a point the corner back that was dropped last.</summary>
    public void TakeBack(int point) => count[point]++;

    /// <summary>Takes all corners from a point.</summary>
    public void Clear(int point) => count[point] = 0;

    /// <summary>Keeps the lists as they are.</summary>
    public void Save()
    {
        saved.Save();
        savedEnd = end;
        if (savedCorners.Length < end)
        {
            GiveBack(savedCorners);
            savedCorners = ArrayPool<int>.Shared.Rent(corners.Length);
        }

        Array.Copy(corners, savedCorners, end);
    }

    /// <summary>Puts the lists back to what they were when they were kept.</summary>
    public void Restore()
    {
        saved.Restore();
        end = savedEnd;
        Array.Copy(savedCorners, corners, end);
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        saved.Dispose();
        GiveBack(corners);
        GiveBack(savedCorners);
        corners = Array.Empty<int>();
        savedCorners = Array.Empty<int>();
    }

    private static void GiveBack(int[] borrowed)
    {
        if (borrowed.Length > 0)
        {
            ArrayPool<int>.Shared.Return(borrowed);
        }
    }
}
