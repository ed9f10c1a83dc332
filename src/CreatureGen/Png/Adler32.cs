using System;

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
            foreach (byte value in bytes[..run])
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
}
