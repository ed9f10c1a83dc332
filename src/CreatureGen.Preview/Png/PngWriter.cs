using System;
using System.IO;
using CreatureGen.Preview.Pictures;
using CreatureGen.Png;

namespace CreatureGen.Preview.Png;

/// <summary>Writes pictures as PNG files, the same bytes on every platform.</summary>
public static class PngWriter
{
    /// <summary>Writes <paramref name="picture"/> to <paramref name="stream"/> at its present position; the stream stays open.</summary>
    /// <exception cref="ArgumentException">The stream cannot be written.</exception>
    public static void Write(Picture picture, Stream stream)
    {
        ArgumentNullException.ThrowIfNull(picture);
        PngEncoder.Write(picture.Bytes, picture.Width, picture.Height, picture.Layout == PixelLayout.Rgb ? PngPixels.Rgb : PngPixels.Rgba, stream);
    }

    /// <summary>The bytes of the PNG file of <paramref name="picture"/>.</summary>
    public static byte[] ToBytes(Picture picture)
    {
        using var stream = new MemoryStream();
        Write(picture, stream);
        return stream.ToArray();
    }
}
