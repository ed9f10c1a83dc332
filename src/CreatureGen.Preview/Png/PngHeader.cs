using System;
using System.Buffers.Binary;
using System.IO;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Preview.Png;

/// <summary>The header of a PNG file, and how pixels are taken out of rows by it.</summary>
/// <param name="Width">Columns.</param>
/// <param name="Height">Rows.</param>
/// <param name="Depth">Bits of a sample.</param>
/// <param name="Colour">Colour type of the format: 0 grey, 2 colour, 3 palette, 4 grey with opacity, 6 colour with opacity.</param>
internal sealed record PngHeader(int Width, int Height, int Depth, int Colour)
{
    /// <summary>Bytes of a row.</summary>
    public int Stride => ((Width * Samples * Depth) + 7) / 8;

    /// <summary>Bytes from a byte to that of the pixel before, at least 1.</summary>
    public int BytesPerPixel => Math.Max(1, Samples * Depth / 8);

    private int Samples => Colour switch
    {
        2 => 3,
        4 => 2,
        6 => 4,
        _ => 1,
    };

    /// <summary>Reads the content of the chunk.</summary>
    /// <exception cref="InvalidDataException">It says what is not read.</exception>
    public static PngHeader Read(ReadOnlySpan<byte> content, int maxPixels, int length)
    {
        if (content.Length != length)
        {
            throw new InvalidDataException("its header is broken");
        }

        int width = BinaryPrimitives.ReadInt32BigEndian(content);
        int height = BinaryPrimitives.ReadInt32BigEndian(content[4..]);
        if (width < 1 || height < 1 || width > Picture.LargestSide || height > Picture.LargestSide || (long)width * height > maxPixels)
        {
            throw new InvalidDataException(FormattableString.Invariant($"it is {width} x {height} pixels; expected at most {maxPixels} in all"));
        }

        var header = new PngHeader(width, height, content[8], content[9]);
        bool known = header.Colour switch
        {
            0 => header.Depth is 1 or 2 or 4 or 8 or 16,
            3 => header.Depth is 1 or 2 or 4 or 8,
            2 or 4 or 6 => header.Depth is 8 or 16,
            _ => false,
        };
        return !known ? throw new InvalidDataException($"there is no colour type {header.Colour} of {header.Depth} bits")
            : content[12] != 0 ? throw new InvalidDataException("it is interlaced; expected a file that is not")
            : header;
    }

    /// <summary>A pixel of a row.</summary>
    /// <param name="row">The row without its filter.</param>
    /// <param name="x">Which column.</param>
    /// <param name="palette">Three bytes for each colour of the palette.</param>
    /// <param name="opacities">Opacities of the palette's colours, or the one colour that is clear.</param>
    /// <exception cref="InvalidDataException">The palette has no such colour.</exception>
    public Pixel PixelOf(ReadOnlySpan<byte> row, int x, byte[] palette, byte[] opacities)
    {
        if (Colour == 3)
        {
            int entry = Sample(row, x);
            return (3 * entry) + 2 < palette.Length
                ? new Pixel(palette[3 * entry], palette[(3 * entry) + 1], palette[(3 * entry) + 2], entry < opacities.Length ? opacities[entry] : (byte)255)
                : throw new InvalidDataException($"its palette has no colour {entry}");
        }

        int first = x * Samples;
        byte red = Byte(Sample(row, first));
        bool grey = Samples < 3;
        byte green = grey ? red : Byte(Sample(row, first + 1));
        byte blue = grey ? red : Byte(Sample(row, first + 2));
        bool clear = Samples is 1 or 3 && IsClear(row, first, opacities);
        byte opacity = Samples is 2 or 4 ? Byte(Sample(row, first + Samples - 1)) : clear ? (byte)0 : (byte)255;
        return new Pixel(red, green, blue, opacity);
    }

    private bool IsClear(ReadOnlySpan<byte> row, int first, byte[] colour)
    {
        bool clear = colour.Length >= 2 * Samples;
        for (int i = 0; i < Samples && clear; i++)
        {
            clear = Sample(row, first + i) == BinaryPrimitives.ReadUInt16BigEndian(colour.AsSpan(2 * i));
        }

        return clear;
    }

    private int Sample(ReadOnlySpan<byte> row, int number)
    {
        if (Depth == 16)
        {
            return BinaryPrimitives.ReadUInt16BigEndian(row[(2 * number)..]);
        }

        int bit = number * Depth;
        return (row[bit / 8] >> (8 - Depth - (bit % 8))) & ((1 << Depth) - 1);
    }

    private byte Byte(int sample) => (byte)(Depth == 16 ? sample >> 8 : sample * 255 / ((1 << Depth) - 1));
}
