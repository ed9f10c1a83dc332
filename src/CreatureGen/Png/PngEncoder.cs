using System;
using System.IO;
using System.Text;

namespace CreatureGen.Png;

/// <summary>Writes bytes as PNG files (ISO/IEC 15948), the same bytes on every platform.</summary>
public static class PngEncoder
{
    private static readonly byte[] imageData = Encoding.ASCII.GetBytes("IDAT");

    /// <summary>Writes a picture to a stream at its present position; the stream stays open.</summary>
    /// <param name="pixels">Rows from the top, without gaps.</param>
    /// <param name="width">Columns, at least 1.</param>
    /// <param name="height">Rows, at least 1.</param>
    /// <param name="layout">What the bytes mean.</param>
    /// <param name="stream">Where to write.</param>
    /// <exception cref="ArgumentNullException">There is no stream.</exception>
    /// <exception cref="ArgumentException">The bytes are not as many as the size asks for, or the stream cannot be written.</exception>
    public static void Write(ReadOnlySpan<byte> pixels, int width, int height, PngPixels layout, Stream stream)
    {
        if (stream is null)
        {
            throw new ArgumentNullException(nameof(stream));
        }

        if (!stream.CanWrite)
        {
            throw new ArgumentException("the stream cannot be written; expected one that can", nameof(stream));
        }

        int bytesPerPixel = layout == PngPixels.Rgb ? 3 : 4;
        if (width < 1 || height < 1 || pixels.Length != (long)width * height * bytesPerPixel)
        {
            throw new ArgumentException(FormattableString.Invariant($"{pixels.Length} bytes for a picture of {width} × {height} {layout}; expected {bytesPerPixel} for each pixel"), nameof(pixels));
        }

        using BitSink packed = Pack(pixels, width, height, bytesPerPixel);
        WriteFile(packed.Bytes, width, height, layout, stream);
    }

    /// <summary>The file of a picture without transparency.</summary>
    /// <param name="pixels">Three bytes for each pixel, rows from the top, without gaps.</param>
    /// <param name="width">Columns, at least 1.</param>
    /// <param name="height">Rows, at least 1.</param>
    internal static byte[] FileOf(ReadOnlySpan<byte> pixels, int width, int height)
    {
        using BitSink packed = Pack(pixels, width, height, 3);
        byte[] file = new byte[PngChunks.Overhead + packed.Bytes.Length];
        using var stream = new MemoryStream(file);
        WriteFile(packed.Bytes, width, height, PngPixels.Rgb, stream);
        return file;
    }

    private static BitSink Pack(ReadOnlySpan<byte> pixels, int width, int height, int bytesPerPixel) =>
        PngFilter.Compress(pixels, width * bytesPerPixel, width * bytesPerPixel, height, bytesPerPixel);

    private static void WriteFile(ReadOnlySpan<byte> packed, int width, int height, PngPixels layout, Stream stream)
    {
        PngChunks.WriteStart(stream, width, height, layout);
        PngChunks.Write(stream, imageData, packed, default);
        PngChunks.WriteEnd(stream);
    }
}
