using System;
using System.Buffers;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace CreatureGen.Appearance.Textures;

/// <summary>
/// Fills what is not painted of an atlas from around it: smaller and smaller pictures of the atlas, as renderers use from afar, then mix in no colour that is not the creature's.
/// </summary>
/// <remarks>Based on: S. J. Gortler et al., "The Lumigraph" (1996): means of what is painted are pushed up a pyramid of halved pictures, and gaps pull theirs down from it.</remarks>
internal static class GapFilling
{
    private const int Channels = 3;

    /// <summary>So many texels are looked at in one word, and its value where all of them are painted.</summary>
    private const int Eight = sizeof(ulong);
    private const ulong All = 0x0101010101010101;

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
                int end = texel + size;
                while (texel < end)
                {
                    int block = Math.Min(Eight / 2, end - texel);
                    if (block < Eight / 2 || !half.TryAverageWide(texel, this, first))
                    {
                        for (int i = 0; i < block; i++)
                        {
                            half.Average(texel + i, this, first + (2 * i));
                        }
                    }

                    texel += block;
                    first += 2 * block;
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
                    if (Size - x >= Eight && Marks(texel) == All)
                    {
                        x += Eight - 1;
                        texel += Eight - 1;
                    }
                    else if (!painted[texel])
                    {
                        int over = Channels * ((y / 2 * half.Size) + (x / 2));
                        half.texels.AsSpan(over, Channels).CopyTo(texels.AsSpan(Channels * texel, Channels));
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

        /// <summary>The marks of eight texels in a row.</summary>
        private ulong Marks(int texel) => BinaryPrimitives.ReadUInt64LittleEndian(MemoryMarshal.AsBytes(painted.AsSpan(texel, Eight)));

        /// <summary>Four means of a row where all that they are means of is painted, or nothing: most are like that, and need no branches and no quotients. False for others.</summary>
        private bool TryAverageWide(int texel, Level finer, int first)
        {
            int below = first + finer.Size;
            ulong marks = finer.Marks(first);
            if (finer.Marks(below) != marks || (marks != All && marks != 0))
            {
                return false;
            }

            if (marks == All)
            {
                painted.AsSpan(texel, Eight / 2).Fill(true);
                ReadOnlySpan<byte> upper = finer.texels.AsSpan(Channels * first, Channels * Eight);
                ReadOnlySpan<byte> lower = finer.texels.AsSpan(Channels * below, Channels * Eight);
                Span<byte> means = texels.AsSpan(Channels * texel, Channels * Eight / 2);
                for (int to = 0, from = 0; to < means.Length; to += Channels, from += 2 * Channels)
                {
                    means[to] = (byte)((upper[from] + upper[from + 3] + lower[from] + lower[from + 3] + 2) >> 2);
                    means[to + 1] = (byte)((upper[from + 1] + upper[from + 4] + lower[from + 1] + lower[from + 4] + 2) >> 2);
                    means[to + 2] = (byte)((upper[from + 2] + upper[from + 5] + lower[from + 2] + lower[from + 5] + 2) >> 2);
                }
            }

            return true;
        }

        private void Average(int texel, Level finer, int first)
        {
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
