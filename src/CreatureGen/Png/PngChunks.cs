using System;
using System.IO;

namespace CreatureGen.Png;

/// <summary>The signature and the chunks of a PNG file (ISO/IEC 15948), in the order they are written.</summary>
internal static class PngChunks
{
    /// <summary>Bytes of a file of one chunk of data besides those.</summary>
    public const int Overhead = 8 + (12 + 13) + (12 + 1) + 12 + 12;

    /// <summary>What every PNG file begins with.</summary>
    public static ReadOnlySpan<byte> Signature => [0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A];

    /// <summary>Writes the signature, the header, and that colours are sRGB.</summary>
    public static void WriteStart(Stream stream, int width, int height, PngPixels pixels)
    {
        stream.Write(Signature);
        Span<byte> header = stackalloc byte[13];
        PutBigEndian(header, (uint)width);
        PutBigEndian(header[4..], (uint)height);
        header[8] = 8;
        header[9] = (byte)(pixels == PngPixels.Rgb ? 2 : 6);
        header[10] = header[11] = header[12] = 0;
        Write(stream, "IHDR"u8, header, default);
        Write(stream, "sRGB"u8, [0], default);
    }

    /// <summary>Writes the end of the file.</summary>
    public static void WriteEnd(Stream stream) => Write(stream, "IEND"u8, default, default);

    /// <summary>Writes a chunk whose data come in two parts.</summary>
    public static void Write(Stream stream, ReadOnlySpan<byte> type, ReadOnlySpan<byte> data, ReadOnlySpan<byte> more)
    {
        Span<byte> number = stackalloc byte[4];
        PutBigEndian(number, checked((uint)data.Length + (uint)more.Length));
        stream.Write(number);
        stream.Write(type);
        stream.Write(data);
        stream.Write(more);
        PutBigEndian(number, Crc32.Finish(Crc32.Append(Crc32.Append(Crc32.Append(Crc32.Start, type), data), more)));
        stream.Write(number);
    }

    /// <summary>Puts a number as four bytes, highest first.</summary>
    public static void PutBigEndian(Span<byte> target, uint value)
    {
        target[0] = (byte)(value >> 24);
        target[1] = (byte)(value >> 16);
        target[2] = (byte)(value >> 8);
        target[3] = (byte)value;
    }
}
