using System;
using System.Buffers.Binary;
#if NET
using System.Numerics;
#endif
using CreatureGen.Concurrency;

namespace CreatureGen.Png;

/// <summary>
/// Compresses bytes to a zlib stream (RFC 1950 around RFC 1951). The same bytes in give the same bytes out on every platform, which the
/// runtime's own compressor does not promise.
/// </summary>
/// <remarks>Matches are found by chains of equal hashes of four bytes, with one step of lazy evaluation; each block takes the smallest of stored, fixed and dynamic codes.</remarks>
internal sealed class Deflater
{
    private const int WindowSize = 32768;
    private const int ShortestMatch = 4;
    private const int LongestMatch = 258;
    private const int HashBits = 15;
    private const int TokensPerBlock = 32768;

    /// <summary>From so many bytes on, two halves are compressed side by side. The second finds no matches in the first, which costs less than a hundredth.</summary>
    private const int ShortestParted = 1 << 20;

    // Steps along a chain; how few of them are left for what follows a good match; and the length after which nothing better is looked for: size against time, measured on pictures.
    private const int LongestChain = 8;
    private const int ShortChain = 2;
    private const int GoodMatch = 6;
    private const int LongMatch = 16;

    // That of the last stream of this thread: its tables are large, and as long as those of the next one.
    [ThreadStatic]
    private static Deflater? spare;

    private readonly int[] heads = new int[1 << HashBits];
    private readonly int[] previous = new int[WindowSize];

    // A literal is its byte; a match is length << 16 | distance − 1, which is never below 1 << 16.
    private readonly int[] tokens = new int[TokensPerBlock];
    private readonly DeflateBlock block = new();
    private int tokenCount;

    /// <summary>The zlib stream of <paramref name="bytes"/>, to be disposed of.</summary>
    public static BitSink Compress(ReadOnlyMemory<byte> bytes)
    {
        var sink = new BitSink((bytes.Length / 4) + 64);
        sink.Append([0x78, 0x9C]);
        if (bytes.Length < ShortestParted)
        {
            CompressPart(bytes.Span, sink, DeflateBlockPlace.Last);
            sink.AppendBigEndian(Adler32.Of(bytes.Span));
            return sink;
        }

        ReadOnlyMemory<byte> upper = bytes[..(bytes.Length / 2)];
        ReadOnlyMemory<byte> lower = bytes[upper.Length..];
        using var rest = new BitSink((lower.Length / 4) + 64);
        uint upperSum = 0;
        uint lowerSum = 0;
        IndependentParts.Run(2, part =>
        {
            if (part == 0)
            {
                CompressPart(upper.Span, sink, DeflateBlockPlace.Inner);
                upperSum = Adler32.Of(upper.Span);
            }
            else
            {
                CompressPart(lower.Span, rest, DeflateBlockPlace.Last);
                lowerSum = Adler32.Of(lower.Span);
            }
        });
        sink.Append(rest.Bytes);
        sink.AppendBigEndian(Adler32.Joined(upperSum, lowerSum, lower.Length));
        return sink;
    }

    /// <summary>Compresses bytes that know nothing of what comes before them, up to a whole byte.</summary>
    private static void CompressPart(ReadOnlySpan<byte> bytes, BitSink sink, DeflateBlockPlace place)
    {
        (spare ??= new Deflater()).Compress(bytes, sink, place);
        if (place == DeflateBlockPlace.Inner)
        {
            DeflateBlock.WriteNothing(sink);
        }

        sink.Align();
    }

    private void Compress(ReadOnlySpan<byte> bytes, BitSink sink, DeflateBlockPlace place)
    {
        Array.Fill(heads, -WindowSize);
        tokenCount = 0;
        int blockStart = 0;
        int at = 0;
        int pendingLength = 0;
        int pendingDistance = 0;
        int searched = bytes.Length - ShortestMatch;
        while (at < bytes.Length)
        {
            int length = 0;
            int distance = 0;
            if (at <= searched)
            {
                int candidate = Link(bytes, at);
                if (pendingLength < LongMatch)
                {
                    length = Match(bytes, at, candidate, pendingLength, out distance);
                }
            }

            if (pendingLength > 0 && length <= pendingLength)
            {
                tokens[tokenCount++] = (pendingLength << 16) | (pendingDistance - 1);
                int end = at - 1 + pendingLength;
                for (at++; at < Math.Min(end, searched + 1); at++)
                {
                    Link(bytes, at);
                }

                at = end;
                pendingLength = 0;
            }
            else
            {
                if (pendingLength > 0)
                {
                    tokens[tokenCount++] = bytes[at - 1];
                }

                if (length == 0)
                {
                    tokens[tokenCount++] = bytes[at];
                }

                pendingLength = length;
                pendingDistance = distance;
                at++;
            }

            if (tokenCount >= TokensPerBlock - 2)
            {
                int end = pendingLength > 0 ? at - 1 : at;
                Flush(bytes[blockStart..end], sink, DeflateBlockPlace.Inner);
                blockStart = end;
            }
        }

        if (pendingLength > 0)
        {
            tokens[tokenCount++] = (pendingLength << 16) | (pendingDistance - 1);
        }

        Flush(bytes[blockStart..], sink, place);
    }

    /// <summary>Enters a position into the chain of its four bytes and returns the one before it there.</summary>
    private int Link(ReadOnlySpan<byte> bytes, int at)
    {
        uint hash = (BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(at)) * 2654435761u) >> (32 - HashBits);
        int before = heads[hash];
        previous[at & (WindowSize - 1)] = before;
        heads[hash] = at;
        return before;
    }

    /// <summary>The longest match that is longer than another, as far as the chain is followed; 0 for none.</summary>
    private int Match(ReadOnlySpan<byte> bytes, int at, int candidate, int atLeast, out int distance)
    {
        distance = 0;
        ReadOnlySpan<byte> here = bytes.Slice(at, Math.Min(LongestMatch, bytes.Length - at));
        int best = Math.Max(atLeast, ShortestMatch - 1);
        if (here.Length <= best)
        {
            return 0;
        }

        int found = 0;
        int oldest = Math.Max(at - WindowSize, 0);
        uint start = BinaryPrimitives.ReadUInt32LittleEndian(here);
        uint end = BinaryPrimitives.ReadUInt32LittleEndian(here.Slice(best - 3));
        for (int left = atLeast >= GoodMatch ? ShortChain : LongestChain; left > 0 && candidate >= oldest; left--)
        {
            ReadOnlySpan<byte> there = bytes.Slice(candidate, here.Length);
            if (BinaryPrimitives.ReadUInt32LittleEndian(there.Slice(best - 3)) == end && BinaryPrimitives.ReadUInt32LittleEndian(there) == start)
            {
                int length = CommonPrefix(here, there);
                if (length > best)
                {
                    best = length;
                    found = length;
                    distance = at - candidate;
                    if (length >= LongMatch || length == here.Length)
                    {
                        break;
                    }

                    end = BinaryPrimitives.ReadUInt32LittleEndian(here.Slice(best - 3));
                }
            }

            // What a place of the ring held before is older than all that is left in the chain.
            int next = previous[candidate & (WindowSize - 1)];
            if (next >= candidate)
            {
                break;
            }

            candidate = next;
        }

        return found;
    }

    private void Flush(ReadOnlySpan<byte> source, BitSink sink, DeflateBlockPlace place)
    {
        block.Write(tokens.AsSpan(0, tokenCount), source, sink, place);
        tokenCount = 0;
    }

    /// <summary>How many bytes two spans of equal length have in common from their start.</summary>
    private static int CommonPrefix(ReadOnlySpan<byte> a, ReadOnlySpan<byte> b)
    {
        int i = 0;
        for (; i + 8 <= a.Length; i += 8)
        {
            ulong apart = BinaryPrimitives.ReadUInt64LittleEndian(a.Slice(i)) ^ BinaryPrimitives.ReadUInt64LittleEndian(b.Slice(i));
            if (apart != 0)
            {
#if NET
                // Where they part is counted, not looked for: a processor that guesses the length of a match guesses wrong. A ninth of the time of a picture.
                return i + (BitOperations.TrailingZeroCount(apart) >> 3);
#else
                break;
#endif
            }
        }

        while (i < a.Length && a[i] == b[i])
        {
            i++;
        }

        return i;
    }
}
