using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using System.Text;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Preview.Png;

/// <summary>Reads still pictures from PNG files (ISO/IEC 15948) of any colour type and depth, without interlacing. Depths of 16 bits are cut to 8; colour profiles are not applied.</summary>
public static class PngReader
{
    private const int HeaderBytes = 13;
    private const int MaxPixels = 1 << 26;

    private static ReadOnlySpan<byte> Signature => [0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A];

    /// <summary>Whether a file starts as PNG files do.</summary>
    public static bool IsPng(ReadOnlySpan<byte> start) => start.StartsWith(Signature);

    /// <summary>Reads a picture with its opacity.</summary>
    /// <param name="file">All bytes of the file.</param>
    /// <exception cref="InvalidDataException">It is no PNG file, is broken, or is of a form that is not read; the message says what.</exception>
    public static Picture Read(ReadOnlySpan<byte> file)
    {
        if (!IsPng(file))
        {
            throw new InvalidDataException("it does not start as a PNG file does");
        }

        PngHeader? header = null;
        byte[] palette = [];
        byte[] opacities = [];
        var data = new MemoryStream();
        for (int at = Signature.Length; ;)
        {
            string type = Chunk(file, ref at, out ReadOnlySpan<byte> content);
            switch (type)
            {
                case "IHDR":
                    header = PngHeader.Read(content, MaxPixels, HeaderBytes);
                    break;
                case "PLTE":
                    palette = content.ToArray();
                    break;
                case "tRNS":
                    opacities = content.ToArray();
                    break;
                case "IDAT":
                    data.Write(content);
                    break;
                case "IEND":
                    return Decode(header ?? throw new InvalidDataException("it has no header"), palette, opacities, data);
            }
        }
    }

    private static string Chunk(ReadOnlySpan<byte> file, ref int at, out ReadOnlySpan<byte> content)
    {
        if (file.Length - at < 12)
        {
            throw new InvalidDataException("it ends before its end");
        }

        int length = BinaryPrimitives.ReadInt32BigEndian(file[at..]);
        if (length < 0 || length > file.Length - at - 12)
        {
            throw new InvalidDataException("it ends before its end");
        }

        content = file.Slice(at + 8, length);
        string type = Encoding.ASCII.GetString(file.Slice(at + 4, 4));
        at += length + 12;
        return type;
    }

    private static Picture Decode(PngHeader header, byte[] palette, byte[] opacities, MemoryStream data)
    {
        byte[] rows = Unfiltered(header, data);
        var picture = new Picture(header.Width, header.Height, PixelLayout.Rgba);
        for (int y = 0; y < header.Height; y++)
        {
            ReadOnlySpan<byte> row = rows.AsSpan(y * header.Stride, header.Stride);
            for (int x = 0; x < header.Width; x++)
            {
                picture[x, y] = header.PixelOf(row, x, palette, opacities);
            }
        }

        return picture;
    }

    private static byte[] Unfiltered(PngHeader header, MemoryStream data)
    {
        byte[] rows = new byte[header.Stride * header.Height];
        byte[] none = new byte[header.Stride];
        try
        {
            data.Position = 0;
            using var inflated = new ZLibStream(data, CompressionMode.Decompress);
            for (int y = 0; y < header.Height; y++)
            {
                int filter = inflated.ReadByte();
                Span<byte> row = rows.AsSpan(y * header.Stride, header.Stride);
                inflated.ReadExactly(row);
                Unfilter(filter, row, y == 0 ? none : rows.AsSpan((y - 1) * header.Stride, header.Stride), header.BytesPerPixel);
            }
        }
        catch (EndOfStreamException)
        {
            throw new InvalidDataException("it holds fewer pixels than its header says");
        }

        return rows;
    }

    private static void Unfilter(int filter, Span<byte> row, ReadOnlySpan<byte> above, int step)
    {
        for (int i = 0; i < row.Length; i++)
        {
            int left = i >= step ? row[i - step] : 0;
            int corner = i >= step ? above[i - step] : 0;
            row[i] += (byte)(filter switch
            {
                0 => 0,
                1 => left,
                2 => above[i],
                3 => (left + above[i]) / 2,
                4 => Paeth(left, above[i], corner),
                _ => throw new InvalidDataException($"a row has the filter {filter}, which there is not"),
            });
        }
    }

    private static int Paeth(int left, int above, int corner)
    {
        int estimate = left + above - corner;
        (int a, int b, int c) = (Math.Abs(estimate - left), Math.Abs(estimate - above), Math.Abs(estimate - corner));
        return a <= b && a <= c ? left : b <= c ? above : corner;
    }
}
