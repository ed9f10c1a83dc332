using System;
using System.Buffers;
using System.Collections.Generic;

namespace CreatureGen.Appearance.Textures;

/// <summary>
/// Fills what is not painted of an atlas from around it: smaller and smaller pictures of the atlas, as renderers use from afar, then mix in no colour that is not the creature's.
/// </summary>
/// <remarks>Based on: S. J. Gortler et al., "The Lumigraph" (1996): means of what is painted are pushed up a pyramid of halved pictures, and gaps pull theirs down from it.</remarks>
internal static class GapFilling
{
    private const int Channels = 3;

    /// <summary>Gives each texel that is not painted the mean of the smallest square around it, of those that halving makes, in which something is painted.</summary>
    /// <param name="picture">Three bytes per texel; changed. Nothing happens where nothing is painted.</param>
    /// <param name="painted">One per texel.</param>
    /// <param name="size">Texels along a side, a power of two.</param>
    public static void Fill(byte[] picture, bool[] painted, int size)
    {
        var pyramid = new Stack<Level>();
        pyramid.Push(new Level(size, picture, painted));
        while (pyramid.Peek().Size > 1)
        {
            pyramid.Push(pyramid.Peek().Halve());
        }

        bool any = pyramid.Peek().IsPainted(0);
        for (Level coarse = pyramid.Pop(); pyramid.Count > 0; coarse = pyramid.Pop())
        {
            if (any)
            {
                pyramid.Peek().FillFrom(coarse);
            }

            coarse.GiveBack();
        }
    }

    private sealed class Level
    {
        private readonly byte[] texels;
        private readonly bool[] painted;

        public Level(int size, byte[] texels, bool[] painted)
        {
            Size = size;
            this.texels = texels;
            this.painted = painted;
        }

        public int Size { get; }

        public bool IsPainted(int texel) => painted[texel];

        public Level Halve()
        {
            int size = Size / 2;
            var half = new Level(size, ArrayPool<byte>.Shared.Rent(Channels * size * size), ArrayPool<bool>.Shared.Rent(size * size));
            Array.Clear(half.painted, 0, size * size);
            for (int texel = 0, first = 0; texel < size * size; first += Size)
            {
                for (int end = texel + size; texel < end; texel++, first += 2)
                {
                    half.Average(texel, this, first);
                }
            }

            return half;
        }

        public void FillFrom(Level half)
        {
            for (int y = 0, texel = 0; y < Size; y++)
            {
                for (int x = 0; x < Size; x++, texel++)
                {
                    if (!painted[texel])
                    {
                        int over = Channels * ((y / 2 * half.Size) + (x / 2));
                        texels[Channels * texel] = half.texels[over];
                        texels[(Channels * texel) + 1] = half.texels[over + 1];
                        texels[(Channels * texel) + 2] = half.texels[over + 2];
                    }
                }
            }
        }

        /// <summary>Gives the memory of a halved picture back.</summary>
        public void GiveBack()
        {
            ArrayPool<byte>.Shared.Return(texels);
            ArrayPool<bool>.Shared.Return(painted);
        }

        private void Average(int texel, Level finer, int first)
        {
            int below = first + finer.Size;
            ReadOnlySpan<bool> has = finer.painted;
            if (has[first] & has[first + 1] & has[below] & has[below + 1])
            {
                // Most are like that: no branches and no quotients, half of the time.
                painted[texel] = true;
                ReadOnlySpan<byte> upper = finer.texels.AsSpan(Channels * first, 2 * Channels);
                ReadOnlySpan<byte> lower = finer.texels.AsSpan(Channels * below, 2 * Channels);
                Span<byte> mean = texels.AsSpan(Channels * texel, Channels);
                mean[0] = (byte)((upper[0] + upper[3] + lower[0] + lower[3] + 2) >> 2);
                mean[1] = (byte)((upper[1] + upper[4] + lower[1] + lower[4] + 2) >> 2);
                mean[2] = (byte)((upper[2] + upper[5] + lower[2] + lower[5] + 2) >> 2);
                return;
            }

            int red = 0, green = 0, blue = 0, count = 0;
            for (int corner = 0; corner < 4; corner++)
            {
                int at = first + (corner & 1) + ((corner >> 1) * finer.Size);
                if (finer.painted[at])
                {
                    red += finer.texels[Channels * at];
                    green += finer.texels[(Channels * at) + 1];
                    blue += finer.texels[(Channels * at) + 2];
                    count++;
                }
            }

            if (count > 0)
            {
                painted[texel] = true;
                texels[Channels * texel] = (byte)((red + (count / 2)) / count);
                texels[(Channels * texel) + 1] = (byte)((green + (count / 2)) / count);
                texels[(Channels * texel) + 2] = (byte)((blue + (count / 2)) / count);
            }
        }
    }
}
