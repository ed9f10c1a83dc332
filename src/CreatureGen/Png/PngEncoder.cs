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

        int stride = width * bytesPerPixel;
        byte[] filtered = PngFilter.Apply(pixels, stride, stride, height, bytesPerPixel);
        PngChunks.WriteStart(stream, width, height, layout);
        PngChunks.Write(stream, imageData, Deflater.Compress(filtered).Bytes, default);
        PngChunks.WriteEnd(stream);
    }
}
