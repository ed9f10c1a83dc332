using System;
using System.Buffers;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Maths;

namespace CreatureGen.Appearance.Textures;

/// <summary>The three pictures of an atlas while they are painted: square, three bytes per texel, rows from the top.</summary>
/// <remarks>What is only needed while they are painted is borrowed from the pool and given back when they are disposed of: megabytes made anew for each atlas bring a full collection with them. The pictures stay.</remarks>
internal sealed class AtlasPictures : IDisposable
{
    private readonly int texels;
    private readonly bool[] painted;
    private readonly float[] heights;

    /// <summary>Pictures of a plain ground, grey, flat and rough, with a power of two texels a side, at least 256.</summary>
    public AtlasPictures(int size)
    {
        Size = size;
        texels = size * size;
        painted = ArrayPool<bool>.Shared.Rent(texels);
        Array.Clear(painted, 0, texels);
        heights = ArrayPool<float>.Shared.Rent(texels);
        BaseColour = new byte[3 * texels];
        Normal = new byte[3 * texels];
        Roughness = new byte[3 * texels];
        BaseColour.AsSpan().Fill(128);
        Fill(Roughness, 255, 191, 0);
        Fill(Normal, 128, 128, 255);
    }

    /// <summary>Texels along a side.</summary>
    public int Size { get; }

    /// <summary>sRGB.</summary>
    public byte[] BaseColour { get; }

    /// <summary>Tangent space, +X along u, +Y against v, as glTF wants it; 128 is nought.</summary>
    public byte[] Normal { get; }

    /// <summary>Openness to the light from all around in the red channel, roughness in the green one, metalness (none) in the blue one, as glTF wants it.</summary>
    public byte[] Roughness { get; }

    /// <summary>Whether a texel has been set.</summary>
    public bool IsPainted(int x, int y) => painted[(y * Size) + x];

    /// <summary>Sets a texel.</summary>
    /// <param name="x">From the left.</param>
    /// <param name="y">From the top.</param>
    /// <param name="colour">Linear, clamped to 0..1.</param>
    /// <param name="height">Height of the relief above the surface, metres; <see cref="Emboss"/> makes normals of it.</param>
    /// <param name="roughness">Clamped to 0..1.</param>
    /// <param name="openness">The share of the light from all around that comes here, clamped to 0..1.</param>
    public void Set(int x, int y, Vector3 colour, float height, float roughness, float openness)
    {
        int texel = (y * Size) + x;
        painted[texel] = true;
        heights[texel] = height;
        Span<byte> rgb = BaseColour.AsSpan(3 * texel, 3);
        rgb[2] = SrgbCurve.Encode(colour.Z);
        rgb[1] = SrgbCurve.Encode(colour.Y);
        rgb[0] = SrgbCurve.Encode(colour.X);
        Roughness[(3 * texel) + 1] = Byte(roughness);
        Roughness[3 * texel] = Byte(openness);
    }

    /// <summary>Fills a square block of texels with white, flat and of one roughness.</summary>
    public void SetPlain(int left, int top, int side, float roughness)
    {
        for (int y = top; y < top + side; y++)
        {
            for (int x = left; x < left + side; x++)
            {
                Set(x, y, Vector3.One, 0f, roughness, 1f);
            }
        }
    }

    /// <summary>Makes the normals of all painted texels of some rows from the heights of those beside them.</summary>
    /// <param name="texel">Side of a texel on the surface, metres.</param>
    /// <param name="rows">The rows.</param>
    public void Emboss(float texel, RowBand rows) => new Embossing(painted, heights, Normal, Size, texel).Make(rows);

    /// <summary>Gives unpainted texels the mean of their painted neighbours, some texels far, so that filtering at the edge of a chart finds no other colour.</summary>
    public void Bleed(int far)
    {
        List<int> border = Border();

        // A texel beside two painted ones is found twice, but listed once.
        bool[] listed = ArrayPool<bool>.Shared.Rent(texels);
        Array.Clear(listed, 0, texels);
        var next = new List<int>();
        for (int round = 0; round < far; round++)
        {
            foreach (int texel in border)
            {
                Average(texel);
            }

            foreach (int texel in border)
            {
                painted[texel] = true;
            }

            next.Clear();
            foreach (int texel in border)
            {
                AddUnpainted(texel, next, listed);
            }

            (border, next) = (next, border);
        }

        ArrayPool<bool>.Shared.Return(listed);
    }

    /// <summary>Colours what is still unpainted of one of the pictures like what is around it; what is painted is only read.</summary>
    public void FillGround(byte[] picture) => GapFilling.Fill(picture, painted, Size);

    /// <summary>Gives borrowed memory back; nothing may be painted any more.</summary>
    public void Dispose()
    {
        ArrayPool<bool>.Shared.Return(painted);
        ArrayPool<float>.Shared.Return(heights);
    }

    private static void Fill(Span<byte> picture, byte red, byte green, byte blue)
    {
        Span<byte> first = picture.Slice(0, 3 * 256);
        for (int i = 0; i < first.Length; i += 3)
        {
            first[i] = red;
            first[i + 1] = green;
            first[i + 2] = blue;
        }

        for (int at = first.Length; at < picture.Length; at += first.Length)
        {
            first.CopyTo(picture.Slice(at));
        }
    }

    private static byte Byte(float fraction) => (byte)(int)((Scalar.Clamp(fraction, 0f, 1f) * 255f) + 0.5f);

    /// <summary>The texels beside one, within the picture: left, right, above, below.</summary>
    private int Neighbours(int texel, Span<int> found)
    {
        int x = texel & (Size - 1);
        int count = 0;
        if (x > 0)
        {
            found[count++] = texel - 1;
        }

        if (x < Size - 1)
        {
            found[count++] = texel + 1;
        }

        if (texel >= Size)
        {
            found[count++] = texel - Size;
        }

        if (texel < texels - Size)
        {
            found[count++] = texel + Size;
        }

        return count;
    }

    /// <summary>The unpainted texels beside painted ones, row by row. Eight are looked at in one word, for most have none or only painted ones around them.</summary>
    private List<int> Border()
    {
        const ulong All = 0x0101010101010101;
        var border = new List<int>();
        ReadOnlySpan<byte> marks = MemoryMarshal.AsBytes(painted.AsSpan(0, texels));
        for (int at = 0; at < texels; at += sizeof(ulong))
        {
            int x = at & (Size - 1);
            ulong here = BinaryPrimitives.ReadUInt64LittleEndian(marks[at..]);
            ulong before = (here << 8) | (x > 0 ? marks[at - 1] : 0UL);
            ulong after = (here >> 8) | (x + sizeof(ulong) < Size ? (ulong)marks[at + sizeof(ulong)] << 56 : 0UL);
            ulong above = at >= Size ? BinaryPrimitives.ReadUInt64LittleEndian(marks[(at - Size)..]) : 0UL;
            ulong below = at < texels - Size ? BinaryPrimitives.ReadUInt64LittleEndian(marks[(at + Size)..]) : 0UL;
            ulong found = (before | after | above | below) & (here ^ All);
            for (int texel = at; found != 0; texel++, found >>= 8)
            {
                if ((found & 1) != 0)
                {
                    border.Add(texel);
                }
            }
        }

        return border;
    }

    /// <summary>Adds the neighbours that are neither painted yet nor listed.</summary>
    private void AddUnpainted(int texel, List<int> found, bool[] listed)
    {
        Span<int> beside = stackalloc int[4];
        int count = Neighbours(texel, beside);
        for (int i = 0; i < count; i++)
        {
            if (!painted[beside[i]] && !listed[beside[i]])
            {
                listed[beside[i]] = true;
                found.Add(beside[i]);
            }
        }
    }

    /// <summary>Gives a texel the mean of its painted neighbours, of which there is at least one.</summary>
    private void Average(int texel)
    {
        Span<int> beside = stackalloc int[4];
        Span<int> sums = stackalloc int[6];
        sums.Clear();
        float height = 0f;
        int count = 0;
        foreach (int neighbour in beside.Slice(0, Neighbours(texel, beside)))
        {
            if (!painted[neighbour])
            {
                continue;
            }

            for (int c = 0; c < 3; c++)
            {
                sums[c] += BaseColour[(3 * neighbour) + c];
                sums[3 + c] += Roughness[(3 * neighbour) + c];
            }

            height += heights[neighbour];
            count++;
        }

        for (int c = 0; c < 3; c++)
        {
            BaseColour[(3 * texel) + c] = (byte)(sums[c] / count);
            Roughness[(3 * texel) + c] = (byte)(sums[3 + c] / count);
        }

        heights[texel] = height / count;
    }
}
