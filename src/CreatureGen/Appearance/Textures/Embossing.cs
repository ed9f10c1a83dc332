using System;

namespace CreatureGen.Appearance.Textures;

/// <summary>Makes normals of the heights of a relief: the slope from texel to texel, in the middle where both neighbours are painted.</summary>
internal readonly ref struct Embossing
{
    private readonly ReadOnlySpan<bool> painted;
    private readonly ReadOnlySpan<float> heights;
    private readonly Span<byte> normals;
    private readonly int size;
    private readonly float perTexel;

    /// <summary>A relief.</summary>
    /// <param name="painted">Which texels have a height; rows from the top.</param>
    /// <param name="heights">Height of each texel above the surface, metres.</param>
    /// <param name="normals">Receives three bytes for each painted texel; 128 is nought.</param>
    /// <param name="size">Texels along a side.</param>
    /// <param name="texel">Side of a texel on the surface, metres.</param>
    public Embossing(ReadOnlySpan<bool> painted, ReadOnlySpan<float> heights, Span<byte> normals, int size, float texel)
    {
        this.painted = painted.Slice(0, size * size);
        this.heights = heights.Slice(0, size * size);
        this.normals = normals;
        this.size = size;
        perTexel = 1f / texel;
    }

    /// <summary>Makes the normals of all painted texels of some rows; heights of the rows beside them are read.</summary>
    public void Make(RowBand rows)
    {
        for (int row = rows.Top * size; row < rows.End * size; row += size)
        {
            bool upper = row > 0;
            bool lower = row < painted.Length - size;
            for (int at = row; at < row + size; at++)
            {
                if (!painted[at])
                {
                    continue;
                }

                float du = Slope(at, at > row, at < row + size - 1, 1) * perTexel;
                float dv = Slope(at, upper, lower, size) * perTexel;
                float scale = 127f / (float)Math.Sqrt(1f + (du * du) + (dv * dv));
                Set(at, -du * scale, dv * scale, scale);
            }
        }
    }

    private void Set(int texel, float x, float y, float z)
    {
        Span<byte> rgb = normals.Slice(3 * texel, 3);
        rgb[2] = (byte)(int)(z + 128.5f);
        rgb[1] = (byte)(int)(y + 128.5f);
        rgb[0] = (byte)(int)(x + 128.5f);
    }

    private float Slope(int texel, bool hasBefore, bool hasAfter, int stride)
    {
        bool before = hasBefore && painted[texel - stride];
        bool after = hasAfter && painted[texel + stride];
        return before && after ? 0.5f * (heights[texel + stride] - heights[texel - stride])
            : before ? heights[texel] - heights[texel - stride]
            : after ? heights[texel + stride] - heights[texel]
            : 0f;
    }
}
