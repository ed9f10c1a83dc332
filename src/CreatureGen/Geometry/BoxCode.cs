using System.Runtime.CompilerServices;

namespace CreatureGen.Geometry;

/// <summary>
/// Corners of axis-aligned boxes on a grid of 2^20 cells a side, packed three coordinates to a number, so that boxes are compared
/// and enclosed without a branch.
/// </summary>
/// <remarks>
/// Each coordinate has 20 bits and a guard bit above them, which catches the borrow of a subtraction (L. Lamport 1975, "Multiple byte processing with full-word instructions").
/// The bit that is left over marks the upper corners of boxes that are still: two of these never overlap, so that a search among what has moved and what has not costs no step more.
/// </remarks>
internal static class BoxCode
{
    /// <summary>The largest coordinate.</summary>
    public const int MaxCoordinate = (1 << Bits) - 1;

    private const int Bits = 20;
    private const int Stride = Bits + 1;
    private const ulong Ones = 1UL | (1UL << Stride) | (1UL << (2 * Stride));
    private const ulong Stillness = 1UL << 63;
    private const ulong Guards = (1UL << Bits) | (1UL << (Bits + Stride)) | (1UL << (Bits + (2 * Stride)));

    /// <summary>A corner from coordinates of 0..<see cref="MaxCoordinate"/>.</summary>
    public static ulong Pack(int x, int y, int z) => (uint)x | ((ulong)(uint)y << Stride) | ((ulong)(uint)z << (2 * Stride));

    /// <summary>The lesser of each coordinate.</summary>
    public static ulong Min(ulong a, ulong b)
    {
        ulong mask = NotLess(a, b);
        return (b & mask) | (a & ~mask);
    }

    /// <summary>The greater of each coordinate.</summary>
    public static ulong Max(ulong a, ulong b)
    {
        ulong mask = NotLess(a, b);
        return (a & mask) | (b & ~mask);
    }

    /// <summary>An upper corner ready for <see cref="Overlap"/>: its guard bits are set.</summary>
    public static ulong Guard(ulong high) => high | Guards;

    /// <summary>An upper corner of a box that is still or not.</summary>
    public static ulong Mark(ulong high, bool still) => still ? high | Stillness : high;

    /// <summary>The upper corner of a box around others, marked as still when these four are.</summary>
    public static ulong MarkAsAll(ulong high, ulong a, ulong b, ulong c, ulong d) => (high & ~Stillness) | (a & b & c & d & Stillness);

    /// <summary>An upper corner without its guard bits and its mark.</summary>
    public static ulong Bare(ulong high) => high & ~(Guards | Stillness);

    /// <summary>One when two boxes have a cell in common and one of them is not still, otherwise zero. The upper corners are guarded.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Overlap(ulong lowA, ulong highA, ulong lowB, ulong highB) =>
        ((highA - lowB) & (highB - lowA) & (Guards | Stillness)) == Guards ? 1 : 0;

    /// <summary>One when no number of one triple equals any of the other, otherwise zero. Both are packed.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Distinct(ulong a, ulong b)
    {
        ulong x = (a & MaxCoordinate) * Ones;
        ulong y = ((a >> Stride) & MaxCoordinate) * Ones;
        ulong z = (a >> (2 * Stride)) * Ones;
        return ((((x ^ b) | Guards) - Ones) & (((y ^ b) | Guards) - Ones) & (((z ^ b) | Guards) - Ones) & Guards) == Guards ? 1 : 0;
    }

    /// <summary>Sum of the three sides of a box, in cells. The upper corner may be guarded.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Extent(ulong low, ulong high)
    {
        ulong size = (high | Guards) - low;
        return (int)(size & MaxCoordinate) + (int)((size >> Stride) & MaxCoordinate) + (int)((size >> (2 * Stride)) & MaxCoordinate);
    }

    /// <summary>Place of the box's centre on the Z-order curve of 2^10 cells a side (G. M. Morton 1966). The upper corner is guarded.</summary>
    public static uint Morton(ulong low, ulong high)
    {
        ulong twice = low + Bare(high);
        uint x = (uint)(twice >> (Stride - 10)) & 1023u;
        uint y = (uint)(twice >> ((2 * Stride) - 10)) & 1023u;
        uint z = (uint)(twice >> ((3 * Stride) - 10)) & 1023u;
        return Spread(x) | (Spread(y) << 1) | (Spread(z) << 2);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ulong NotLess(ulong a, ulong b)
    {
        ulong guard = ((a | Guards) - b) & Guards;
        return guard - (guard >> Bits);
    }

    private static uint Spread(uint x)
    {
        x = (x | (x << 16)) & 0x030000FFu;
        x = (x | (x << 8)) & 0x0300F00Fu;
        x = (x | (x << 4)) & 0x030C30C3u;
        return (x | (x << 2)) & 0x09249249u;
    }
}
