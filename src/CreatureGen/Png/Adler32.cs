using System;
using System.Buffers.Binary;

namespace CreatureGen.Png;

/// <summary>The checksum of a zlib stream (RFC 1950).</summary>
internal static class Adler32
{
    private const uint Modulus = 65521;

    // The most bytes after which neither sum can have passed 2³².
    private const int LongestRun = 5552;

    /// <summary>The checksum of all bytes.</summary>
    public static uint Of(ReadOnlySpan<byte> bytes)
    {
        uint a = 1;
        uint b = 0;
        while (bytes.Length > 0)
        {
            int run = Math.Min(bytes.Length, LongestRun);
            AddWords(bytes[..run], ref a, ref b);
            foreach (byte value in bytes[(run & ~7)..run])
            {
                a += value;
                b += a;
            }

            a %= Modulus;
            b %= Modulus;
            bytes = bytes[run..];
        }

        return (b << 16) | a;
    }

    /// <summary>The checksum of bytes followed by others.</summary>
    /// <param name="first">Checksum of the former.</param>
    /// <param name="second">Checksum of the latter.</param>
    /// <param name="secondLength">How many the latter are.</param>
    public static uint Joined(uint first, uint second, int secondLength)
    {
        // The second sum begins with the first sum's total less one, once for each of its bytes.
        uint carried = ((first & 0xFFFF) + Modulus - 1) % Modulus;
        uint a = (carried + (second & 0xFFFF)) % Modulus;
        ulong b = (first >> 16) + (second >> 16) + ((ulong)carried * (uint)secondLength);
        return ((uint)(b % Modulus) << 16) | a;
    }

    /// <summary>Adds all whole words of eight bytes: the sum of the bytes of a word, and of its first byte eight times, of its second seven times and so on, in the highest of four lanes of a product each.</summary>
    private static void AddWords(ReadOnlySpan<byte> bytes, ref uint a, ref uint b)
    {
        const ulong Lanes = 0x00FF00FF00FF00FF;
        for (; bytes.Length >= sizeof(ulong); bytes = bytes[sizeof(ulong)..])
        {
            ulong word = BinaryPrimitives.ReadUInt64LittleEndian(bytes);
            ulong even = word & Lanes;
            ulong odd = (word >> 8) & Lanes;
            b += (8 * a) + (uint)(((even * 0x0008000600040002) + (odd * 0x0007000500030001)) >> 48);
            a += (uint)(((even + odd) * 0x0001000100010001) >> 48);
        }
    }
}
