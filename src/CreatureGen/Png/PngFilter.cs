using System;
using System.Buffers;

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
    /// <param name="filtered">Receives for each row the number of its filter, then its bytes: (<paramref name="rowBytes"/> + 1) · <paramref name="rows"/>.</param>
    public static void Apply(ReadOnlySpan<byte> bytes, int stride, int rowBytes, int rows, int bytesPerPixel, Span<byte> filtered)
    {
        var filters = new RowFilters(rowBytes, bytesPerPixel);
        for (int y = 0; y < rows; y++)
        {
            Span<byte> target = filtered.Slice(y * (rowBytes + 1), rowBytes + 1);
            int best = filters.Best(bytes.Slice(y * stride, rowBytes));
            target[0] = (byte)best;
            filters.Result(best).CopyTo(target[1..]);
        }
    }

    /// <summary>The zlib stream of a rectangle of bytes so filtered, to be disposed of.</summary>
    /// <param name="bytes">Rows, top first.</param>
    /// <param name="stride">Distance between the starts of rows, bytes.</param>
    /// <param name="rowBytes">Bytes used of each row.</param>
    /// <param name="rows">Number of rows.</param>
    /// <param name="bytesPerPixel">Distance to the left neighbour.</param>
    public static BitSink Compress(ReadOnlySpan<byte> bytes, int stride, int rowBytes, int rows, int bytesPerPixel)
    {
        int count = checked((rowBytes + 1) * rows);
        byte[] filtered = ArrayPool<byte>.Shared.Rent(count);
        Apply(bytes, stride, rowBytes, rows, bytesPerPixel, filtered);
        BitSink packed = Deflater.Compress(filtered.AsMemory(0, count));
        ArrayPool<byte>.Shared.Return(filtered);
        return packed;
    }
}
