using System;
using System.Buffers.Binary;

namespace CreatureGen.Png;

/// <summary>The checksum of PNG chunks: CRC-32 of ISO 3309, polynomial 0xEDB88320 (reflected).</summary>
internal static class Crc32
{
    /// <summary>Bytes that are taken at once: each is looked up in a table of its own, so that none waits for the one before.</summary>
    private const int Stride = 4;

    /// <summary>Of each byte what it makes of the checksum, then the same with one, two and three zeros after it.</summary>
    private static readonly uint[] Table = MakeTable();

    /// <summary>Checksum before any byte.</summary>
    public const uint Start = 0xFFFFFFFF;

    /// <summary>The running checksum after more bytes.</summary>
    public static uint Append(uint running, ReadOnlySpan<byte> bytes)
    {
        uint[] table = Table;
        for (; bytes.Length >= Stride; bytes = bytes.Slice(Stride))
        {
            running ^= BinaryPrimitives.ReadUInt32LittleEndian(bytes);
            running = table[768 + (byte)running] ^ table[512 + (byte)(running >> 8)] ^ table[256 + (byte)(running >> 16)] ^ table[running >> 24];
        }

        foreach (byte value in bytes)
        {
            running = table[(byte)(running ^ value)] ^ (running >> 8);
        }

        return running;
    }

    /// <summary>The checksum as it is stored.</summary>
    public static uint Finish(uint running) => ~running;

    private static uint[] MakeTable()
    {
        var table = new uint[256 * Stride];
        for (uint i = 0; i < 256; i++)
        {
            uint value = i;
            for (int bit = 0; bit < 8; bit++)
            {
                value = (value & 1) != 0 ? 0xEDB88320 ^ (value >> 1) : value >> 1;
            }

            table[i] = value;
        }

        for (int i = 256; i < table.Length; i++)
        {
            table[i] = table[(byte)table[i - 256]] ^ (table[i - 256] >> 8);
        }

        return table;
    }
}
