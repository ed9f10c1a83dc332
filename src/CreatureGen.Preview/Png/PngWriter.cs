using System;
using System.IO;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Preview.Png;

/// <summary>Writes pictures as PNG files, the same bytes on every platform.</summary>
public static class PngWriter
{
    /// <summary>Writes <paramref name="picture"/> to <paramref name="stream"/> at its present position; the stream stays open.</summary>
    /// <exception cref="ArgumentException">The stream cannot be written.</exception>
    public static void Write(Picture picture, Stream stream)
    {
        ArgumentNullException.ThrowIfNull(picture);
        ArgumentNullException.ThrowIfNull(stream);
        if (!stream.CanWrite)
        {
            throw new ArgumentException("the stream cannot be written; expected one that can", nameof(stream));
        }

        byte[] filtered = PngFilter.Apply(picture.Bytes, picture.Stride, picture.Stride, picture.Height, picture.BytesPerPixel);
        PngChunks.WriteStart(stream, picture.Width, picture.Height, picture.Layout);
        PngChunks.Write(stream, "IDAT"u8, Deflater.Compress(filtered).Bytes, default);
        PngChunks.WriteEnd(stream);
    }

    /// <summary>The bytes of the PNG file of <paramref name="picture"/>.</summary>
    public static byte[] ToBytes(Picture picture)
    {
        using var stream = new MemoryStream();
        Write(picture, stream);
        return stream.ToArray();
    }
}
