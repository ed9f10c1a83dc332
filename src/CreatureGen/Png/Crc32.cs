using System;

namespace CreatureGen.Png;

/// <summary>The checksum of PNG chunks: CRC-32 of ISO 3309, polynomial 0xEDB88320 (reflected).</summary>
internal static class Crc32
{
    private static readonly uint[] Table = MakeTable();

    /// <summary>Checksum before any byte.</summary>
    public const uint Start = 0xFFFFFFFF;

    /// <summary>The running checksum after more bytes.</summary>
    public static uint Append(uint running, ReadOnlySpan<byte> bytes)
    {
        foreach (byte value in bytes)
        {
            running = Table[(byte)(running ^ value)] ^ (running >> 8);
        }

        return running;
    }

    /// <summary>The checksum as it is stored.</summary>
    public static uint Finish(uint running) => ~running;

    private static uint[] MakeTable()
    {
        var table = new uint[256];
        for (uint i = 0; i < 256; i++)
        {
            uint value = i;
            for (int bit = 0; bit < 8; bit++)
            {
                value = (value & 1) != 0 ? 0xEDB88320 ^ (value >> 1) : value >> 1;
            }

            table[i] = value;
        }

        return table;
    }
}
