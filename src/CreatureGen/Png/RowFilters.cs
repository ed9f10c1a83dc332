using System;
using System.Runtime.InteropServices;
#if NET
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
#endif

namespace CreatureGen.Png;

/// <summary>
/// All five filters of one row of a picture, worked out in one pass. Where the framework allows, sixteen bytes at a time: arithmetic on whole bytes is exact in any width, so the bytes are the same.
/// </summary>
internal sealed class RowFilters
{
    /// <summary>Number of filters: none, left, above, mean, Paeth's.</summary>
    public const int Count = 5;

    private readonly int step;

    // The rows with a pixel of zeros before them: what lies beside the first pixel.
    private byte[] row;
    private byte[] above;
    private readonly byte[][] results = new byte[Count][];
    private readonly int[] sums = new int[Count];

    /// <summary>Filters for rows of <paramref name="length"/> bytes whose pixels have <paramref name="bytesPerPixel"/>; the row above the first is zeros.</summary>
    public RowFilters(int length, int bytesPerPixel)
    {
        step = bytesPerPixel;
        row = new byte[step + length];
        above = new byte[step + length];
        for (int filter = 1; filter < Count; filter++)
        {
            results[filter] = new byte[length];
        }
    }

    /// <summary>Filters the next row and returns the number of the filter whose differences, taken as signed, have the smallest sum of absolute values; the first of equals.</summary>
    public int Best(ReadOnlySpan<byte> next)
    {
        (row, above) = (above, row);
        next.CopyTo(row.AsSpan(step));
        sums.AsSpan().Clear();
        int done = FilterWide(next.Length);
        for (int i = done; i < next.Length; i++)
        {
            Filter(i);
        }

        int best = 0;
        for (int filter = 1; filter < Count; filter++)
        {
            best = sums[filter] < sums[best] ? filter : best;
        }

        return best;
    }

    /// <summary>The last row as a filter leaves it.</summary>
    public ReadOnlySpan<byte> Result(int filter) => filter == 0 ? row.AsSpan(step) : results[filter];

    private void Filter(int i)
    {
        int value = row[i + step];
        int left = row[i];
        int up = above[i + step];
        int corner = above[i];
        int toLeft = Math.Abs(up - corner);
        int toUp = Math.Abs(left - corner);
        int toCorner = Math.Abs(left + up - (2 * corner));
        int guess = toLeft <= toUp && toLeft <= toCorner ? left : toUp <= toCorner ? up : corner;
        sums[0] += Weight((byte)value);
        sums[1] += Weight(results[1][i] = (byte)(value - left));
        sums[2] += Weight(results[2][i] = (byte)(value - up));
        sums[3] += Weight(results[3][i] = (byte)(value - ((left + up) >> 1)));
        sums[4] += Weight(results[4][i] = (byte)(value - guess));
    }

    private static int Weight(byte difference) => difference < 128 ? difference : 256 - difference;

#if NET
    /// <summary>Filters as many whole vectors as there are; returns how many bytes that were. What it calls is always taken in: vectors handed from method to method keep code from being compiled ahead.</summary>
    private int FilterWide(int length)
    {
        int vectors = length / Vector128<byte>.Count;
        ReadOnlySpan<Vector128<byte>> lefts = MemoryMarshal.Cast<byte, Vector128<byte>>(row);
        ReadOnlySpan<Vector128<byte>> corners = MemoryMarshal.Cast<byte, Vector128<byte>>(above);
        ReadOnlySpan<Vector128<byte>> values = MemoryMarshal.Cast<byte, Vector128<byte>>(row.AsSpan(step));
        ReadOnlySpan<Vector128<byte>> ups = MemoryMarshal.Cast<byte, Vector128<byte>>(above.AsSpan(step));
        Span<Vector128<byte>> subs = MemoryMarshal.Cast<byte, Vector128<byte>>(results[1].AsSpan());
        Span<Vector128<byte>> rises = MemoryMarshal.Cast<byte, Vector128<byte>>(results[2].AsSpan());
        Span<Vector128<byte>> means = MemoryMarshal.Cast<byte, Vector128<byte>>(results[3].AsSpan());
        Span<Vector128<byte>> paeths = MemoryMarshal.Cast<byte, Vector128<byte>>(results[4].AsSpan());
        var none = default(Vector128<uint>);
        Vector128<uint> sub = none, rise = none, mean = none, paeth = none;
        for (int i = 0; i < vectors; i++)
        {
            Vector128<byte> value = values[i];
            Vector128<byte> left = lefts[i];
            Vector128<byte> up = ups[i];
            Vector128<byte> corner = corners[i];
            none += Weight(value);
            sub += Weight(subs[i] = value - left);
            rise += Weight(rises[i] = value - up);
            mean += Weight(means[i] = value - Mean(left, up));
            paeth += Weight(paeths[i] = value - Paeth(left, up, corner));
        }

        sums[0] = Total(none);
        sums[1] = Total(sub);
        sums[2] = Total(rise);
        sums[3] = Total(mean);
        sums[4] = Total(paeth);
        return vectors * Vector128<byte>.Count;
    }

    /// <summary>Half the sum, rounded down: what both have, and half of what one has.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<byte> Mean(Vector128<byte> a, Vector128<byte> b) => (a & b) + Vector128.ShiftRightLogical(a ^ b, 1);

    /// <summary>
    /// The one of three neighbours that is nearest to left + up − corner. Left of it by |up − corner|, above by |left − corner|; from the corner it is as far as both together where both differ from it the
    /// same way (then the corner is never the nearest), else as far as one differs more than the other.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<byte> Paeth(Vector128<byte> left, Vector128<byte> up, Vector128<byte> corner)
    {
        Vector128<byte> toLeft = Distance(up, corner);
        Vector128<byte> toUp = Distance(left, corner);
        Vector128<byte> sameWay = Vector128.Equals(Vector128.GreaterThanOrEqual(left, corner), Vector128.GreaterThanOrEqual(up, corner));
        Vector128<byte> toCorner = sameWay | Distance(toLeft, toUp);
        Vector128<byte> upOrCorner = Vector128.ConditionalSelect(Vector128.LessThanOrEqual(toUp, toCorner), up, corner);
        return Vector128.ConditionalSelect(Vector128.LessThanOrEqual(toLeft, Vector128.Min(toUp, toCorner)), left, upOrCorner);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<byte> Distance(Vector128<byte> a, Vector128<byte> b) => Vector128.Max(a, b) - Vector128.Min(a, b);

    /// <summary>Absolute values of differences taken as signed, added up by fours.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<uint> Weight(Vector128<byte> difference)
    {
        Vector128<byte> absolute = Vector128.Min(difference, default(Vector128<byte>) - difference);
        Vector128<ushort> pairs = (absolute & Vector128.Create((ushort)0x00FF).AsByte()).AsUInt16() + Vector128.ShiftRightLogical(absolute.AsUInt16(), 8);
        return (pairs & Vector128.Create(0x0000FFFFu).AsUInt16()).AsUInt32() + Vector128.ShiftRightLogical(pairs.AsUInt32(), 16);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Total(Vector128<uint> sums) => (int)(sums.GetElement(0) + sums.GetElement(1) + sums.GetElement(2) + sums.GetElement(3));
#else
    private static int FilterWide(int length) => 0;
#endif
}
