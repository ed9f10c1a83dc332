using System;
using CreatureGen.Geometry;

namespace CreatureGen.Png;

/// <summary>The row filters of PNG: each byte becomes its difference from a guess made of its neighbours.</summary>
internal static class PngFilter
{
    /// <summary>
    /// Filters a rectangle of bytes row by row, each row with the filter whose differences, taken as signed, have the smallest sum of absolute values.
    /// </summary>
    /// <param name="bytes">Rows, top first.</param>
    /// <param name="stride">Distance between the starts of rows, bytes.</param>
    /// <param name="rowBytes">Bytes used of each row.</param>
    /// <param name="rows">Number of rows.</param>
    /// <param name="bytesPerPixel">Distance to the left neighbour.</param>
    /// <returns>For each row the number of its filter, then its bytes; to be disposed of.</returns>
    public static PooledList<byte> Apply(ReadOnlySpan<byte> bytes, int stride, int rowBytes, int rows, int bytesPerPixel)
    {
        var filtered = new PooledList<byte>(checked((rowBytes + 1) * rows));
        var filters = new RowFilters(rowBytes, bytesPerPixel);
        for (int y = 0; y < rows; y++)
        {
            int best = filters.Best(bytes.Slice(y * stride, rowBytes));
            filtered.Add((byte)best);
            filtered.AddRange(filters.Result(best));
        }

        return filtered;
    }
}
