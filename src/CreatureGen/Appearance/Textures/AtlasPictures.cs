using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Appearance.Textures;

/// <summary>The three pictures of an atlas while they are painted: square, three bytes per texel, rows from the top.</summary>
internal sealed class AtlasPictures
{
    private readonly bool[] painted;
    private readonly float[] heights;

    /// <summary>Empty pictures of a power of two texels a side: white, flat and rough, the way that pieces with colours of their own need them.</summary>
    public AtlasPictures(int size)
    {
        Size = size;
        painted = new bool[size * size];
        heights = new float[size * size];
        BaseColour = new byte[3 * size * size];
        Normal = new byte[3 * size * size];
        Roughness = new byte[3 * size * size];
    }

    /// <summary>Texels along a side.</summary>
    public int Size { get; }

    /// <summary>sRGB.</summary>
    public byte[] BaseColour { get; }

    /// <summary>Tangent space, +X along u, +Y against v, as glTF wants it; 128 is nought.</summary>
    public byte[] Normal { get; }

    /// <summary>Roughness in the green channel, metalness (none) in the blue one, as glTF wants it.</summary>
    public byte[] Roughness { get; }

    /// <summary>Whether a texel has been set.</summary>
    public bool IsPainted(int x, int y) => painted[(y * Size) + x];

    /// <summary>Sets a texel.</summary>
    /// <param name="x">From the left.</param>
    /// <param name="y">From the top.</param>
    /// <param name="colour">Linear, clamped to 0..1.</param>
    /// <param name="height">Height of the relief above the surface, metres; <see cref="Emboss"/> makes normals of it.</param>
    /// <param name="roughness">Clamped to 0..1.</param>
    public void Set(int x, int y, Vector3 colour, float height, float roughness)
    {
        int texel = (y * Size) + x;
        painted[texel] = true;
        int at = 3 * texel;
        BaseColour[at] = SrgbCurve.Encode(colour.X);
        BaseColour[at + 1] = SrgbCurve.Encode(colour.Y);
        BaseColour[at + 2] = SrgbCurve.Encode(colour.Z);
        heights[texel] = height;
        Roughness[at] = 255;
        Roughness[at + 1] = (byte)((Scalar.Clamp(roughness, 0f, 1f) * 255f) + 0.5f);
        Roughness[at + 2] = 0;
    }

    /// <summary>Fills a square block of texels with white, flat and of one roughness.</summary>
    public void SetPlain(int left, int top, int side, float roughness)
    {
        for (int y = top; y < top + side; y++)
        {
            for (int x = left; x < left + side; x++)
            {
                Set(x, y, Vector3.One, 0f, roughness);
            }
        }
    }

    /// <summary>Makes the normals of all texels from the heights of those beside them.</summary>
    /// <param name="texel">Side of a texel on the surface, metres.</param>
    public void Emboss(float texel)
    {
        for (int y = 0; y < Size; y++)
        {
            for (int x = 0; x < Size; x++)
            {
                int at = (y * Size) + x;
                if (!painted[at])
                {
                    SetNormal(at, 0f, 0f, 127f);
                    continue;
                }

                float du = Slope(at, x, 1) / texel;
                float dv = Slope(at, y, Size) / texel;
                float scale = 127f / (float)Math.Sqrt(1f + (du * du) + (dv * dv));
                SetNormal(at, -du * scale, dv * scale, scale);
            }
        }
    }

    /// <summary>Gives unpainted texels the mean of their painted neighbours, some texels far, so that filtering at the edge of a chart finds no other colour; what is left gets a plain ground.</summary>
    public void Bleed(int texels)
    {
        var border = new List<int>();
        for (int texel = 0; texel < painted.Length; texel++)
        {
            if (!painted[texel] && HasPaintedNeighbour(texel))
            {
                border.Add(texel);
            }
        }

        var next = new List<int>();
        for (int round = 0; round < texels; round++)
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
                AddUnpainted(texel, next);
            }

            (border, next) = (next, border);
        }

        for (int texel = 0; texel < painted.Length; texel++)
        {
            if (!painted[texel])
            {
                BaseColour.AsSpan(3 * texel, 3).Fill(128);
                Roughness[3 * texel] = 255;
                Roughness[(3 * texel) + 1] = 191;
            }
        }
    }

    private bool HasPaintedNeighbour(int texel)
    {
        int x = texel & (Size - 1);
        return (x > 0 && painted[texel - 1]) || (x < Size - 1 && painted[texel + 1])
            || (texel >= Size && painted[texel - Size]) || (texel < painted.Length - Size && painted[texel + Size]);
    }

    /// <summary>Adds the neighbours that are not painted yet. One beside two painted ones is added twice, which its mean does not mind.</summary>
    private void AddUnpainted(int texel, List<int> found)
    {
        int x = texel & (Size - 1);
        if (x > 0 && !painted[texel - 1])
        {
            found.Add(texel - 1);
        }

        if (x < Size - 1 && !painted[texel + 1])
        {
            found.Add(texel + 1);
        }

        if (texel >= Size && !painted[texel - Size])
        {
            found.Add(texel - Size);
        }

        if (texel < painted.Length - Size && !painted[texel + Size])
        {
            found.Add(texel + Size);
        }
    }

    private void SetNormal(int texel, float x, float y, float z)
    {
        Normal[3 * texel] = (byte)(x + 128.5f);
        Normal[(3 * texel) + 1] = (byte)(y + 128.5f);
        Normal[(3 * texel) + 2] = (byte)(z + 128.5f);
    }

    /// <summary>Change of the height from one texel to the next: in the middle where both neighbours have one.</summary>
    private float Slope(int texel, int along, int stride)
    {
        int before = along > 0 && painted[texel - stride] ? texel - stride : texel;
        int after = along < Size - 1 && painted[texel + stride] ? texel + stride : texel;
        return before == after ? 0f : (heights[after] - heights[before]) * stride / (after - before);
    }

    /// <summary>Gives a texel the mean of its painted neighbours, of which there is at least one.</summary>
    private void Average(int texel)
    {
        int x = texel & (Size - 1);
        int y = texel / Size;
        Span<int> sums = stackalloc int[6];
        sums.Clear();
        float height = 0f;
        int count = 0;
        for (int k = 0; k < 4; k++)
        {
            int nx = x + (k == 0 ? -1 : k == 1 ? 1 : 0);
            int ny = y + (k == 2 ? -1 : k == 3 ? 1 : 0);
            if ((uint)nx >= (uint)Size || (uint)ny >= (uint)Size || !painted[(ny * Size) + nx])
            {
                continue;
            }

            int from = 3 * ((ny * Size) + nx);
            for (int c = 0; c < 3; c++)
            {
                sums[c] += BaseColour[from + c];
                sums[3 + c] += Roughness[from + c];
            }

            height += heights[(ny * Size) + nx];
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
