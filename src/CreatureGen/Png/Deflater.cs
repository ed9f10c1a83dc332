using System;
using System.Buffers.Binary;

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

    // Steps along a chain, and the match length with which the search is content: size against time, measured on pictures.
    private const int LongestChain = 8;
    private const int GoodMatch = 130;

    private readonly int[] heads = new int[1 << HashBits];
    private readonly int[] previous = new int[WindowSize];

    // A literal is its byte; a match is length << 16 | distance − 1, which is never below 1 << 16.
    private readonly int[] tokens = new int[TokensPerBlock];
    private readonly DeflateBlock block = new();
    private int tokenCount;

    /// <summary>The zlib stream of <paramref name="bytes"/>.</summary>
    public static BitSink Compress(ReadOnlySpan<byte> bytes)
    {
        var sink = new BitSink((bytes.Length / 4) + 64);
        sink.Append([0x78, 0x9C]);
        new Deflater().Compress(bytes, sink);
        sink.Align();
        sink.AppendBigEndian(Adler32.Of(bytes));
        return sink;
    }

    private void Compress(ReadOnlySpan<byte> bytes, BitSink sink)
    {
        Array.Fill(heads, -1);
        int blockStart = 0;
        int at = 0;
        int inserted = 0;
        int pendingLength = 0;
        int pendingDistance = 0;
        while (at < bytes.Length)
        {
            Insert(bytes, ref inserted, at);
            int length = Match(bytes, at, pendingLength, out int distance);
            inserted = Link(bytes, at);
            if (pendingLength >= ShortestMatch && length <= pendingLength)
            {
                tokens[tokenCount++] = (pendingLength << 16) | (pendingDistance - 1);
                at += pendingLength - 1;
                pendingLength = 0;
            }
            else
            {
                if (pendingLength > 0)
                {
                    tokens[tokenCount++] = bytes[at - 1];
                }

                if (length >= GoodMatch)
                {
                    tokens[tokenCount++] = (length << 16) | (distance - 1);
                    at += length;
                    pendingLength = 0;
                }
                else if (length >= ShortestMatch)
                {
                    pendingLength = length;
                    pendingDistance = distance;
                    at++;
                }
                else
                {
                    tokens[tokenCount++] = bytes[at];
                    pendingLength = 0;
                    at++;
                }
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

        Flush(bytes[blockStart..], sink, DeflateBlockPlace.Last);
    }

    // Enters the positions that a match has stepped over.
    private void Insert(ReadOnlySpan<byte> bytes, ref int inserted, int at)
    {
        while (inserted < at)
        {
            inserted = Link(bytes, inserted);
        }
    }

    private int Link(ReadOnlySpan<byte> bytes, int at)
    {
        if (at + ShortestMatch <= bytes.Length)
        {
            int hash = Hash(bytes, at);
            previous[at & (WindowSize - 1)] = heads[hash];
            heads[hash] = at;
        }

        return at + 1;
    }

    private int Match(ReadOnlySpan<byte> bytes, int at, int atLeast, out int distance)
    {
        distance = 0;
        int most = Math.Min(LongestMatch, bytes.Length - at);
        int best = Math.Max(atLeast, ShortestMatch - 1);
        if (most <= best)
        {
            return 0;
        }

        int found = 0;
        int candidate = heads[Hash(bytes, at)];
        ReadOnlySpan<byte> here = bytes.Slice(at, most);
        for (int step = 0; step < LongestChain && candidate >= 0 && at - candidate <= WindowSize; step++)
        {
            ReadOnlySpan<byte> there = bytes.Slice(candidate, most);
            if (there[best] == here[best] && there[0] == here[0])
            {
                int length = CommonPrefix(here, there);
                if (length > best)
                {
                    best = length;
                    found = length;
                    distance = at - candidate;
                    if (length >= GoodMatch || length == most)
                    {
                        break;
                    }
                }
            }

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

    private static int Hash(ReadOnlySpan<byte> bytes, int at)
    {
        uint four = (uint)(bytes[at] | (bytes[at + 1] << 8) | (bytes[at + 2] << 16) | (bytes[at + 3] << 24));
        return (int)((four * 2654435761u) >> (32 - HashBits));
    }

    /// <summary>How many bytes two spans of equal length have in common from their start.</summary>
    private static int CommonPrefix(ReadOnlySpan<byte> a, ReadOnlySpan<byte> b)
    {
        int i = 0;
        while (i + 8 <= a.Length && BinaryPrimitives.ReadUInt64LittleEndian(a.Slice(i)) == BinaryPrimitives.ReadUInt64LittleEndian(b.Slice(i)))
        {
            i += 8;
        }

        while (i < a.Length && a[i] == b[i])
        {
            i++;
        }

        return i;
    }
}
