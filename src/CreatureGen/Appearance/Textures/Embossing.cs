using System;
using System.Buffers.Binary;
using System.Numerics;
using System.Runtime.InteropServices;

namespace CreatureGen.Appearance.Textures;

/// <summary>Makes normals of the heights of a relief: the slope from texel to texel, in the middle where both neighbours are painted.</summary>
internal readonly ref struct Embossing
{
    /// <summary>So many texels are worked out at once where all around them are painted, as most are: the same bytes in less time.</summary>
    private const int Wide = 4;

    private readonly ReadOnlySpan<byte> painted;
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
        this.painted = MemoryMarshal.AsBytes(painted.Slice(0, size * size));
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
            int at = row;
            while (at < row + size)
            {
                if (upper && lower && at > row && at + Wide < row + size && AreSurrounded(at))
                {
                    MakeWide(at);
                    at += Wide;
                    continue;
                }

                if (painted[at] != 0)
                {
                    float du = Slope(at, at > row, at < row + size - 1, 1) * perTexel;
                    float dv = Slope(at, upper, lower, size) * perTexel;
                    float scale = 127f / (float)Math.Sqrt(1f + (du * du) + (dv * dv));
                    Set(at, -du * scale, dv * scale, scale);
                }

                at++;
            }
        }
    }

    private bool AreSurrounded(int at) => (Marks(at) & Marks(at - 1) & Marks(at + 1) & Marks(at - size) & Marks(at + size)) == 0x01010101;

    private uint Marks(int at) => BinaryPrimitives.ReadUInt32LittleEndian(painted.Slice(at));

    private void MakeWide(int at)
    {
        Vector4 du = (Heights(at + 1) - Heights(at - 1)) * new Vector4(0.5f) * new Vector4(perTexel);
        Vector4 dv = (Heights(at + size) - Heights(at - size)) * new Vector4(0.5f) * new Vector4(perTexel);
        Vector4 squared = Vector4.One + (du * du) + (dv * dv);
        Vector4 scale = new Vector4(127f) / new Vector4((float)Math.Sqrt(squared.X), (float)Math.Sqrt(squared.Y), (float)Math.Sqrt(squared.Z), (float)Math.Sqrt(squared.W));
        Vector4 x = -du * scale;
        Vector4 y = dv * scale;
        Set(at, x.X, y.X, scale.X);
        Set(at + 1, x.Y, y.Y, scale.Y);
        Set(at + 2, x.Z, y.Z, scale.Z);
        Set(at + 3, x.W, y.W, scale.W);
    }

    private Vector4 Heights(int at) => MemoryMarshal.Read<Vector4>(MemoryMarshal.AsBytes(heights.Slice(at, Wide)));

    private void Set(int texel, float x, float y, float z)
    {
        Span<byte> rgb = normals.Slice(3 * texel, 3);
        rgb[2] = (byte)(int)(z + 128.5f);
        rgb[1] = (byte)(int)(y + 128.5f);
        rgb[0] = (byte)(int)(x + 128.5f);
    }

    private float Slope(int texel, bool hasBefore, bool hasAfter, int stride)
    {
        bool before = hasBefore && painted[texel - stride] != 0;
        bool after = hasAfter && painted[texel + stride] != 0;
        return before && after ? 0.5f * (heights[texel + stride] - heights[texel - stride])
            : before ? heights[texel] - heights[texel - stride]
            : after ? heights[texel + stride] - heights[texel]
            : 0f;
    }
}
