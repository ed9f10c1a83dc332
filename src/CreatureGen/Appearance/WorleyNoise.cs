using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>The scattered point nearest to a place.</summary>
internal readonly struct NearestPoint
{
    private readonly Vector3 offset;
    private readonly uint bits;
    private readonly float second;

    /// <summary>The point of a cell.</summary>
    /// <param name="offset">From the place to the point, cells.</param>
    /// <param name="bits">Random bits of its cell.</param>
    /// <param name="second">Square of the distance to the next point.</param>
    public NearestPoint(Vector3 offset, uint bits, float second)
    {
        this.offset = offset;
        this.bits = bits;
        this.second = second;
    }

    /// <summary>Distance to the point, in cells.</summary>
    public float Distance => Vec.Length(offset);

    /// <summary>By how much the next point is farther away, in cells; both distances are cut at <see cref="WorleyNoise.Reach"/>, so that it changes without a jump.</summary>
    public float Margin => Math.Max(0f, Math.Min(WorleyNoise.Reach, (float)Math.Sqrt(second)) - Distance);

    /// <summary>A random number 0..1 of the point, the same for all places that it is nearest to.</summary>
    public float Value => LatticeHash.Unit(LatticeHash.Mix(bits));

    /// <summary>
    /// −1..1 by the direction of the point alone: the product of the cosines to two random axes of the point, so that a circle around it meets up to four zeros. 0 at the point itself.
    /// </summary>
    public float Lobes
    {
        get
        {
            uint first = LatticeHash.Mix(bits ^ 0x55555555u);
            Vector3 a = Axis(first);
            Vector3 b = Axis(LatticeHash.Mix(first));
            float size = Vec.LengthSquared(offset) * (float)Math.Sqrt(Vec.LengthSquared(a) * Vec.LengthSquared(b));
            return size > 1e-12f ? Scalar.Clamp(Vec.Dot(offset, a) * Vec.Dot(offset, b) / size, -1f, 1f) : 0f;
        }
    }

    private static Vector3 Axis(uint bits) => new((bits >> 22) - 511.5f, ((bits >> 12) & 1023u) - 511.5f, ((bits >> 2) & 1023u) - 511.5f);
}

/// <summary>Scattered points, one in each cell of an integer lattice, and which of them is nearest.</summary>
/// <remarks>
/// Based on: S. Worley, "A cellular texture basis function" (1996). Points stay within <see cref="Jitter"/> of the centre of their cell, so none outside
/// of the 8 cells around a place is closer to it than <see cref="Reach"/>. It remembers the points of the last 8 cells, because one place after another mostly lies among the same:
/// what it answers does not depend on that, but each thread needs its own.
/// </remarks>
internal sealed class WorleyNoise
{
    /// <summary>How far a point may lie from the centre of its cell along each axis, in cells.</summary>
    public const float Jitter = 0.36f;

    /// <summary>No point outside of the 8 cells around a place is closer to it, in cells.</summary>
    public const float Reach = 1f - Jitter;

    // A point's place along one axis of its cell: the least, and the step of its 10 random bits.
    private const float Min = 0.5f - Jitter;
    private const float Step = 2f * Jitter / 1023f;

    /// <summary>The bits of a squared distance that say which of eight cells it is of.</summary>
    private const int CellMask = 7;

    private readonly int salt;
    private bool known;
    private int cellX;
    private int cellY;
    private int cellZ;

    /// <summary>Of the eight points along each axis, in the order of their cells: from the low corner of its own cell to the point.</summary>
    private Vector4 nearX, nearY, nearZ, farX, farY, farZ;

    /// <summary>Scatters the points.</summary>
    /// <param name="salt">Which scatter.</param>
    public WorleyNoise(int salt) => this.salt = salt;

    /// <summary>The nearest point; exact wherever it is closer than <see cref="Reach"/>.</summary>
    public NearestPoint Nearest(Vector3 point)
    {
        int x = Low(point.X);
        int y = Low(point.Y);
        int z = Low(point.Z);
        Survey(x, y, z, point, out int first, out int second);
        x += first & 1;
        y += (first >> 1) & 1;
        z += (first >> 2) & 1;
        uint bits = LatticeHash.Bits(x, y, z, salt);
        return new NearestPoint(new Vector3(Offset(x - point.X, bits), Offset(y - point.Y, bits << 10), Offset(z - point.Z, bits << 20)), bits, Squared(second));
    }

    /// <summary>By how much the second nearest point is farther away than the nearest, in cells: 0 on the borders between their plates.</summary>
    /// <param name="point">The place, in cells.</param>
    /// <param name="max">The answer is exact up to here, and no less than this wherever it is more.</param>
    public float Gap(Vector3 point, float max)
    {
        int x0 = Low(point.X);
        int y0 = Low(point.Y);
        int z0 = Low(point.Z);
        Survey(x0, y0, z0, point, out int first, out int second);

        // Of the cells around these eight only the nearer side of each axis can matter, and few of them do.
        float within = (float)Math.Sqrt(Squared(first)) + max;
        float reach = Math.Min(Squared(second), within * within);
        if (reach > Reach * Reach)
        {
            (int outerX, float dx) = Beyond(point.X, x0);
            (int outerY, float dy) = Beyond(point.Y, y0);
            (int outerZ, float dz) = Beyond(point.Z, z0);
            if (Math.Min(dx, Math.Min(dy, dz)) < reach)
            {
                for (int k = 0; k < 3; k++)
                {
                    for (int j = 0; j < 3; j++)
                    {
                        for (int i = 0; i < 3; i++)
                        {
                            float apart = (i < 2 ? 0f : dx) + (j < 2 ? 0f : dy) + (k < 2 ? 0f : dz);
                            if (apart > 0f && apart < reach)
                            {
                                int x = i < 2 ? x0 + i : outerX;
                                int y = j < 2 ? y0 + j : outerY;
                                int z = k < 2 ? z0 + k : outerZ;
                                Meet(SquaredOffset(x - point.X, y - point.Y, z - point.Z, LatticeHash.Bits(x, y, z, salt)), 0, ref first, ref second);
                            }
                        }
                    }
                }
            }
        }

        return (float)Math.Sqrt(Squared(second)) - (float)Math.Sqrt(Squared(first));
    }

    // The lower of the two cells along an axis whose middles are nearest to a place.
    private static int Low(float at) => (int)Math.Floor(at - 0.5);

    // The nearer of the two cells beside a pair of cells, and the square of the least distance to its point along this axis.
    private static (int Cell, float Squared) Beyond(float at, int low)
    {
        float fraction = at - 0.5f - low;
        float min = Reach + Math.Min(fraction, 1f - fraction);
        return (fraction < 0.5f ? low - 1 : low + 2, min * min);
    }

    // The two least squared distances to the points of eight cells, as Meet orders them.
    private void Survey(int x0, int y0, int z0, Vector3 point, out int first, out int second)
    {
        if (x0 != cellX || y0 != cellY || z0 != cellZ || !known)
        {
            Enter(x0, y0, z0);
        }

        float left = x0 - point.X;
        float right = left + 1f;
        var alongX = new Vector4(left, right, left, right);
        float below = y0 - point.Y;
        float above = (y0 + 1) - point.Y;
        var alongY = new Vector4(below, below, above, above);
        Vector4 x = alongX + nearX;
        Vector4 y = alongY + nearY;
        Vector4 z = new Vector4(z0 - point.Z) + nearZ;
        Vector4 near = (x * x) + (y * y) + (z * z);
        x = alongX + farX;
        y = alongY + farY;
        z = new Vector4((z0 + 1) - point.Z) + farZ;
        Vector4 far = (x * x) + (y * y) + (z * z);
        int min = int.MaxValue;
        int next = int.MaxValue;
        Meet(near.X, 0, ref min, ref next);
        Meet(near.Y, 1, ref min, ref next);
        Meet(near.Z, 2, ref min, ref next);
        Meet(near.W, 3, ref min, ref next);
        Meet(far.X, 4, ref min, ref next);
        Meet(far.Y, 5, ref min, ref next);
        Meet(far.Z, 6, ref min, ref next);
        Meet(far.W, 7, ref min, ref next);
        first = min;
        second = next;
    }

    private void Enter(int x, int y, int z)
    {
        Points(x, y, z, out nearX, out nearY, out nearZ);
        Points(x, y, z + 1, out farX, out farY, out farZ);
        cellX = x;
        cellY = y;
        cellZ = z;
        known = true;
    }

    // The points of four cells of one layer.
    private void Points(int x, int y, int z, out Vector4 alongX, out Vector4 alongY, out Vector4 alongZ)
    {
        uint a = LatticeHash.Bits(x, y, z, salt);
        uint b = LatticeHash.Bits(x + 1, y, z, salt);
        uint c = LatticeHash.Bits(x, y + 1, z, salt);
        uint d = LatticeHash.Bits(x + 1, y + 1, z, salt);
        alongX = new Vector4(InCell(a), InCell(b), InCell(c), InCell(d));
        alongY = new Vector4(InCell(a << 10), InCell(b << 10), InCell(c << 10), InCell(d << 10));
        alongZ = new Vector4(InCell(a << 20), InCell(b << 20), InCell(c << 20), InCell(d << 20));
    }

    // Positive numbers are ordered as their bits are: as integers they can be compared without a branch, and carry their cell in the bits that matter least.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Meet(float squared, int cell, ref int first, ref int second)
    {
        int key = (BitConverter.SingleToInt32Bits(squared) & ~CellMask) | cell;
        second = Math.Min(second, Math.Max(first, key));
        first = Math.Min(first, key);
    }

    private static float Squared(int key) => BitConverter.Int32BitsToSingle(key & ~CellMask);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float SquaredOffset(float x, float y, float z, uint bits)
    {
        float dx = Offset(x, bits);
        float dy = Offset(y, bits << 10);
        float dz = Offset(z, bits << 20);
        return (dx * dx) + (dy * dy) + (dz * dz);
    }

    // From a place to the point of a cell along one axis: from the place to the cell, and the highest 10 bits.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Offset(float toCell, uint bits) => toCell + InCell(bits);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float InCell(uint bits) => Min + (Step * (int)(bits >> 22));
}
