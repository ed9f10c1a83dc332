using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;

namespace CreatureGen.Tests.Png;

/// <summary>A chunk of a PNG file.</summary>
/// <param name="Type">Four letters.</param>
/// <param name="Data">What is in it.</param>
/// <param name="StoredCrc">The checksum in the file.</param>
internal sealed record PngChunk(string Type, byte[] Data, uint StoredCrc)
{
    /// <summary>The checksum of type and data bit by bit, without a table (PNG specification, annex D).</summary>
    public uint ComputedCrc()
    {
        uint crc = 0xFFFFFFFF;
        foreach (byte value in Encoding.ASCII.GetBytes(Type).Concat(Data))
        {
            for (int bit = 0; bit < 8; bit++)
            {
                uint feedback = (crc ^ (uint)(value >> bit)) & 1;
                crc = (crc >> 1) ^ (feedback * 0xEDB88320);
            }
        }

        return ~crc;
    }

    /// <summary>The number of four bytes at a place in the data.</summary>
    public int Number(int at) => BinaryPrimitives.ReadInt32BigEndian(Data.AsSpan(at));
}

/// <summary>A second reader of PNG files, made of the specification and the runtime's own inflater.</summary>
internal sealed class PngFile
{
    private static readonly byte[] signature = [0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A];

    public PngFile(byte[] file)
    {
        if (!file.AsSpan().StartsWith(signature))
        {
            throw new InvalidDataException("the file does not start with the PNG signature");
        }

        var chunks = new List<PngChunk>();
        int at = signature.Length;
        while (at < file.Length)
        {
            int length = BinaryPrimitives.ReadInt32BigEndian(file.AsSpan(at));
            chunks.Add(new PngChunk(
                Encoding.ASCII.GetString(file, at + 4, 4),
                file.AsSpan(at + 8, length).ToArray(),
                BinaryPrimitives.ReadUInt32BigEndian(file.AsSpan(at + 8 + length))));
            at += 12 + length;
        }

        Chunks = chunks;
    }

    public IReadOnlyList<PngChunk> Chunks { get; }

    public PngChunk Header => Chunks[0];

    public int Width => Header.Number(0);

    public int Height => Header.Number(4);

    public int BytesPerPixel => Header.Data[9] switch
    {
        2 => 3,
        6 => 4,
        byte other => throw new InvalidDataException($"colour type {other}"),
    };

    /// <summary>The pixels of the still picture.</summary>
    public byte[] Pixels() => Pixels(Chunks.Where(c => c.Type == "IDAT").SelectMany(c => c.Data).ToArray(), Width, Height);

    /// <summary>The filters of the rows of the still picture.</summary>
    public byte[] Filters()
    {
        byte[] rows = Inflate(Chunks.Where(c => c.Type == "IDAT").SelectMany(c => c.Data).ToArray());
        return Enumerable.Range(0, Height).Select(y => rows[y * ((Width * BytesPerPixel) + 1)]).ToArray();
    }

    /// <summary>The pixels of a zlib stream of filtered rows.</summary>
    public byte[] Pixels(byte[] stream, int width, int height)
    {
        byte[] filtered = Inflate(stream);
        int step = BytesPerPixel;
        int stride = width * step;
        if (filtered.Length != (stride + 1) * height)
        {
            throw new InvalidDataException($"{filtered.Length} filtered bytes for {width} × {height}");
        }

        var pixels = new byte[stride * height];
        for (int y = 0; y < height; y++)
        {
            int filter = filtered[y * (stride + 1)];
            for (int i = 0; i < stride; i++)
            {
                int left = i >= step ? pixels[(y * stride) + i - step] : 0;
                int up = y > 0 ? pixels[((y - 1) * stride) + i] : 0;
                int corner = i >= step && y > 0 ? pixels[((y - 1) * stride) + i - step] : 0;
                int guess = filter switch
                {
                    0 => 0,
                    1 => left,
                    2 => up,
                    3 => (left + up) / 2,
                    4 => Paeth(left, up, corner),
                    _ => throw new InvalidDataException($"row {y} has filter {filter}"),
                };
                pixels[(y * stride) + i] = (byte)(filtered[(y * (stride + 1)) + 1 + i] + guess);
            }
        }

        return pixels;
    }

    public static byte[] Inflate(byte[] stream)
    {
        using var zlib = new ZLibStream(new MemoryStream(stream), CompressionMode.Decompress);
        var plain = new MemoryStream();
        zlib.CopyTo(plain);
        return plain.ToArray();
    }

    private static int Paeth(int left, int up, int corner)
    {
        int estimate = left + up - corner;
        int[] candidates = [left, up, corner];
        return candidates.MinBy(c => Math.Abs(estimate - c));
    }
}
