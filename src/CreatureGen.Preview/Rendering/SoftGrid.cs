using System;

namespace CreatureGen.Preview.Rendering;

/// <summary>A square grid of numbers that can be smoothed, halved and read between its texels. Beyond the grid everything is zero.</summary>
internal sealed class SoftGrid
{
    public SoftGrid(int size)
    {
        Size = size;
        Values = new float[size * size];
    }

    public int Size { get; }

    public float[] Values { get; }

    /// <summary>The mean of each two by two texels.</summary>
    public SoftGrid Halved()
    {
        var half = new SoftGrid(Size / 2);
        for (int y = 0; y < half.Size; y++)
        {
            ReadOnlySpan<float> upper = Values.AsSpan(2 * y * Size, Size);
            ReadOnlySpan<float> lower = Values.AsSpan(((2 * y) + 1) * Size, Size);
            Span<float> target = half.Values.AsSpan(y * half.Size, half.Size);
            for (int x = 0; x < target.Length; x++)
            {
                target[x] = (upper[2 * x] + upper[(2 * x) + 1] + lower[2 * x] + lower[(2 * x) + 1]) * 0.25f;
            }
        }

        return half;
    }

    /// <summary>Smooths in both directions with the weights 1 4 6 4 1 (a standard deviation of one texel).</summary>
    public void Smooth()
    {
        var copy = new float[Values.Length];
        for (int y = 0; y < Size; y++)
        {
            SmoothRow(Values.AsSpan(y * Size, Size), copy.AsSpan(y * Size, Size));
        }

        var zeros = new float[Size];
        for (int y = 0; y < Size; y++)
        {
            ReadOnlySpan<float> a = Row(copy, y - 2, zeros);
            ReadOnlySpan<float> b = Row(copy, y - 1, zeros);
            ReadOnlySpan<float> c = Row(copy, y, zeros);
            ReadOnlySpan<float> d = Row(copy, y + 1, zeros);
            ReadOnlySpan<float> e = Row(copy, y + 2, zeros);
            Span<float> target = Values.AsSpan(y * Size, Size);
            for (int x = 0; x < target.Length; x++)
            {
                target[x] = (((a[x] + e[x]) + ((b[x] + d[x]) * 4f)) + (c[x] * 6f)) * (1f / 16f);
            }
        }
    }

    /// <summary>The value at a place in texels; the middle of texel (0, 0) is at (0.5, 0.5).</summary>
    public float At(float u, float v)
    {
        u -= 0.5f;
        v -= 0.5f;
        if (!(u > -1f && v > -1f && u < Size && v < Size))
        {
            return 0f;
        }

        int x = (int)(u + 1f) - 1;
        int y = (int)(v + 1f) - 1;
        float fu = u - x;
        float fv = v - y;
        float upper = (Texel(x, y) * (1f - fu)) + (Texel(x + 1, y) * fu);
        float lower = (Texel(x, y + 1) * (1f - fu)) + (Texel(x + 1, y + 1) * fu);
        return (upper * (1f - fv)) + (lower * fv);
    }

    private static void SmoothRow(ReadOnlySpan<float> source, Span<float> target)
    {
        int last = source.Length - 1;
        for (int x = 0; x <= last; x++)
        {
            float a = x >= 2 ? source[x - 2] : 0f;
            float b = x >= 1 ? source[x - 1] : 0f;
            float d = x + 1 <= last ? source[x + 1] : 0f;
            float e = x + 2 <= last ? source[x + 2] : 0f;
            target[x] = (((a + e) + ((b + d) * 4f)) + (source[x] * 6f)) * (1f / 16f);
        }
    }

    private ReadOnlySpan<float> Row(float[] values, int y, float[] zeros) => (uint)y < (uint)Size ? values.AsSpan(y * Size, Size) : zeros;

    private float Texel(int x, int y) => (uint)x < (uint)Size && (uint)y < (uint)Size ? Values[(y * Size) + x] : 0f;
}
