using System;
using System.IO;
using System.Text;

namespace CreatureGen.Png;

/// <summary>Text in PNG files: chunks iTXt (ISO/IEC 15948, 11.3.4.5), uncompressed, without language.</summary>
internal static class PngText
{
    private const int SignatureBytes = 8;
    private const int ChunkHeadBytes = 8;
    private const int CrcBytes = 4;

    private delegate bool ChunkVisitor(byte[] type, byte[] data);

    /// <summary>Copies a picture and puts text into it, before the first data of the picture. Text of the same keyword that it has already is left out.</summary>
    /// <returns>False if it is no whole PNG file; then part of it may have been written.</returns>
    public static bool Insert(Stream picture, string keyword, string text, Stream destination)
    {
        byte[] data = Encoding.UTF8.GetBytes(keyword + "\0\0\0\0\0" + text);
        bool inserted = false;
        return Walk(picture, int.MaxValue, (type, chunk) =>
        {
            if (!inserted && (Is(type, "IDAT") || Is(type, "IEND")))
            {
                PngChunks.Write(destination, "iTXt"u8, data, default);
                inserted = true;
            }

            if (TextOf(type, chunk, keyword) == null)
            {
                PngChunks.Write(destination, type, chunk, default);
            }

            return true;
        }, destination);
    }

    /// <summary>The text of a keyword; null if it has none, or is no PNG file. Chunks that are longer than allowed, and those whose checksum is wrong, count as the end.</summary>
    public static string? Find(Stream picture, string keyword, int longestChunk)
    {
        string? found = null;
        Walk(picture, longestChunk, (type, chunk) =>
        {
            found = TextOf(type, chunk, keyword);
            return found == null;
        }, Stream.Null);
        return found;
    }

    /// <summary>Visits chunks until one says no or the file ends. True if it was seen to its end.</summary>
    private static bool Walk(Stream picture, int longestChunk, ChunkVisitor visit, Stream destination)
    {
        byte[] signature = new byte[SignatureBytes];
        if (!Fill(picture, signature) || !signature.AsSpan().SequenceEqual(PngChunks.Signature))
        {
            return false;
        }

        destination.Write(signature);
        byte[] head = new byte[ChunkHeadBytes];
        byte[] crc = new byte[CrcBytes];
        while (Fill(picture, head))
        {
            long length = BigEndian(head);
            byte[] type = head[4..];
            if (length > longestChunk || !TryRead(picture, (int)Math.Min(length, int.MaxValue), out byte[] data) || !Fill(picture, crc)
                || BigEndian(crc) != Crc32.Finish(Crc32.Append(Crc32.Append(Crc32.Start, type), data)))
            {
                return false;
            }

            if (!visit(type, data))
            {
                return false;
            }

            if (Is(type, "IEND"))
            {
                return true;
            }
        }

        return false;
    }

    private static string? TextOf(byte[] type, byte[] chunk, string keyword)
    {
        byte[] start = Encoding.UTF8.GetBytes(keyword + "\0\0\0");
        if (!Is(type, "iTXt") || !chunk.AsSpan().StartsWith(start))
        {
            return null;
        }

        // The language and the translated keyword may be there; each ends with a zero.
        int at = start.Length;
        for (int i = 0; i < 2; i++)
        {
            int length = chunk.AsSpan(at).IndexOf((byte)0);
            if (length < 0)
            {
                return null;
            }

            at += length + 1;
        }

        return Encoding.UTF8.GetString(chunk, at, chunk.Length - at);
    }

    private static bool Is(byte[] type, string name) => Encoding.ASCII.GetString(type) == name;

    private static uint BigEndian(byte[] bytes) => ((uint)bytes[0] << 24) | ((uint)bytes[1] << 16) | ((uint)bytes[2] << 8) | bytes[3];

    /// <summary>Reads in steps, so that a length that lies reserves no memory.</summary>
    private static bool TryRead(Stream stream, int length, out byte[] data)
    {
        const int Step = 1 << 16;
        using var gathered = new MemoryStream();
        byte[] part = new byte[Math.Min(length, Step)];
        while (gathered.Length < length)
        {
            int read = stream.Read(part, 0, (int)Math.Min(part.Length, length - gathered.Length));
            if (read == 0)
            {
                break;
            }

            gathered.Write(part, 0, read);
        }

        data = gathered.ToArray();
        return data.Length == length;
    }

    private static bool Fill(Stream stream, byte[] bytes)
    {
        int at = 0;
        while (at < bytes.Length)
        {
            int read = stream.Read(bytes, at, bytes.Length - at);
            if (read == 0)
            {
                return false;
            }

            at += read;
        }

        return true;
    }
}
