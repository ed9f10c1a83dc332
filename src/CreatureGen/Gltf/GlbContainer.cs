using System;
using System.Globalization;
using System.IO;
using System.Text;
using CreatureGen.Blueprints;

namespace CreatureGen.Gltf;

/// <summary>The container of a binary glTF: a header, a chunk of JSON, a chunk of bytes, each a multiple of four bytes long.</summary>
internal static class GlbContainer
{
    private const int HeaderLength = 12;
    private const int ChunkHeaderLength = 8;
    private const uint Version = 2;

    // Each the little-endian bytes of its letters.
    private const uint Magic = 0x46546C67;
    private const uint JsonChunk = 0x4E4F534A;
    private const uint BinaryChunk = 0x004E4942;

    private const int FirstRead = 64 * 1024;

    /// <summary>Writes the whole file. <paramref name="binary"/> must be a multiple of four bytes long.</summary>
    public static void Write(Stream destination, ReadOnlySpan<byte> json, ReadOnlySpan<byte> binary)
    {
        int jsonLength = BufferPlan.Align(json.Length);
        long total = (long)HeaderLength + ChunkHeaderLength + jsonLength + ChunkHeaderLength + binary.Length;
        Span<byte> head = stackalloc byte[HeaderLength + ChunkHeaderLength];
        LittleEndian.Write(head, 0, Magic);
        LittleEndian.Write(head, 4, Version);
        LittleEndian.Write(head, 8, checked((uint)total));
        LittleEndian.Write(head, 12, (uint)jsonLength);
        LittleEndian.Write(head, 16, JsonChunk);
        destination.Write(head);
        destination.Write(json);
        Span<byte> spaces = stackalloc byte[3] { (byte)' ', (byte)' ', (byte)' ' };
        destination.Write(spaces.Slice(0, jsonLength - json.Length));
        LittleEndian.Write(head, 0, (uint)binary.Length);
        LittleEndian.Write(head, 4, BinaryChunk);
        destination.Write(head.Slice(0, ChunkHeaderLength));
        destination.Write(binary);
    }

    /// <summary>Reads the JSON chunk, and nothing beyond it; null if there is none, with the reason in <paramref name="problem"/>.</summary>
    /// <param name="source">Read from where it stands; need not be able to seek.</param>
    /// <param name="maximumBytes">A longer chunk is a problem.</param>
    /// <param name="problem">Why there is no JSON; null if there is.</param>
    public static byte[]? ReadJson(Stream source, int maximumBytes, out Problem? problem)
    {
        byte[] head = ReadUpTo(source, HeaderLength + ChunkHeaderLength);
        problem = FindProblem(head, maximumBytes);
        if (problem != null)
        {
            return null;
        }

        int length = (int)LittleEndian.ReadUInt32(head, HeaderLength);
        byte[] json = ReadUpTo(source, length);
        if (json.Length < length)
        {
            problem = new Problem("JSON chunk", Bytes(json.Length) + " before the file ends", Bytes(length) + ", as its header says");
            return null;
        }

        return json;
    }

    /// <summary>Reads the binary chunk that follows the JSON; empty if the file ends there. Null if it is broken, with the reason in <paramref name="problem"/>.</summary>
    /// <param name="source">Read from where <see cref="ReadJson"/> has left it.</param>
    /// <param name="maximumBytes">A longer chunk is a problem.</param>
    /// <param name="problem">Why there are no bytes; null if there are.</param>
    public static byte[]? ReadBinary(Stream source, int maximumBytes, out Problem? problem)
    {
        problem = null;
        byte[] head = ReadUpTo(source, ChunkHeaderLength);
        if (head.Length == 0)
        {
            return head;
        }

        if (head.Length < ChunkHeaderLength)
        {
            problem = new Problem("binary chunk", Bytes(head.Length), "the " + Bytes(ChunkHeaderLength) + " of its header");
            return null;
        }

        uint length = LittleEndian.ReadUInt32(head, 0);
        if (LittleEndian.ReadUInt32(head, 4) != BinaryChunk)
        {
            problem = new Problem("second chunk", "type " + Hexadecimal(head.AsSpan(4, 4)), "42 49 4E 00 (\"BIN\")");
            return null;
        }

        if (length > (uint)maximumBytes)
        {
            problem = new Problem("binary chunk", Bytes(length), "at most " + Bytes(maximumBytes));
            return null;
        }

        byte[] binary = ReadUpTo(source, (int)length);
        if (binary.Length < length)
        {
            problem = new Problem("binary chunk", Bytes(binary.Length) + " before the file ends", Bytes(length) + ", as its header says");
            return null;
        }

        return binary;
    }

    private static Problem? FindProblem(byte[] head, int maximumBytes)
    {
        if (head.Length < 4 || LittleEndian.ReadUInt32(head, 0) != Magic)
        {
            return new Problem("file", head.Length == 0 ? "nothing" : Hexadecimal(head.AsSpan(0, Math.Min(4, head.Length))), "a GLB file, which begins with 67 6C 54 46 (\"glTF\")");
        }

        if (head.Length < HeaderLength + ChunkHeaderLength)
        {
            return new Problem("file", Bytes(head.Length), "at least the " + Bytes(HeaderLength + ChunkHeaderLength) + " of the headers of the file and of its first chunk");
        }

        uint version = LittleEndian.ReadUInt32(head, 4);
        if (version != Version)
        {
            return new Problem("version", version.ToString(CultureInfo.InvariantCulture), "GLB version 2");
        }

        if (LittleEndian.ReadUInt32(head, HeaderLength + 4) != JsonChunk)
        {
            return new Problem("first chunk", "type " + Hexadecimal(head.AsSpan(HeaderLength + 4, 4)), "4A 53 4F 4E (\"JSON\")");
        }

        uint length = LittleEndian.ReadUInt32(head, HeaderLength);
        if (length > (uint)maximumBytes)
        {
            return new Problem("JSON chunk", Bytes(length), "at most " + Bytes(maximumBytes));
        }

        uint total = LittleEndian.ReadUInt32(head, 8);
        return total < HeaderLength + ChunkHeaderLength + length
            ? new Problem("length", Bytes(total), "at least the " + Bytes(HeaderLength + ChunkHeaderLength + length) + " of the headers and the JSON chunk")
            : null;
    }

    /// <summary>The next bytes of a stream, fewer if it ends. Memory grows with what is there, not with what was announced.</summary>
    private static byte[] ReadUpTo(Stream source, int count)
    {
        long there = source.CanSeek ? source.Length - source.Position : FirstRead;
        byte[] bytes = new byte[Math.Max(0, Math.Min(count, there))];
        int length = 0;
        while (length < count)
        {
            if (length == bytes.Length)
            {
                Array.Resize(ref bytes, (int)Math.Min(count, 2L * bytes.Length));
            }

            int read = source.Read(bytes, length, bytes.Length - length);
            if (read == 0)
            {
                break;
            }

            length += read;
        }

        Array.Resize(ref bytes, length);
        return bytes;
    }

    private static string Bytes(long count) => count.ToString(CultureInfo.InvariantCulture) + (count == 1 ? " byte" : " bytes");

    private static string Hexadecimal(ReadOnlySpan<byte> bytes)
    {
        var text = new StringBuilder();
        foreach (byte value in bytes)
        {
            text.Append(text.Length > 0 ? " " : string.Empty).Append(value.ToString("X2", CultureInfo.InvariantCulture));
        }

        return text.ToString();
    }
}
