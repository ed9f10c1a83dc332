using System;

namespace CreatureGen.Png;

/// <summary>Where a block stands in its stream.</summary>
internal enum DeflateBlockPlace
{
    /// <summary>More blocks follow.</summary>
    Inner,

    /// <summary>The stream ends with it.</summary>
    Last,
}

/// <summary>Writes the tokens of one deflate block in the smallest of the three forms.</summary>
internal sealed class DeflateBlock
{
    private const int LongestStored = 65535;
    private const int LongestCode = 15;
    private const int LongestCodeOfLengths = 7;

    private readonly int[] literalCounts = new int[DeflateTables.LiteralSymbols];
    private readonly int[] distanceCounts = new int[DeflateTables.DistanceSymbols];
    private readonly int[] lengthCounts = new int[19];
    private readonly HuffmanCode literals = new(DeflateTables.LiteralSymbols);
    private readonly HuffmanCode distances = new(DeflateTables.DistanceSymbols);
    private readonly HuffmanCode codeLengths = new(19);

    // Run-length coded code lengths: symbol, and the value of its extra bits.
    private readonly byte[] runSymbols = new byte[DeflateTables.LiteralSymbols + DeflateTables.DistanceSymbols];
    private readonly byte[] runExtras = new byte[DeflateTables.LiteralSymbols + DeflateTables.DistanceSymbols];
    private int runCount;

    /// <summary>Writes the block. <paramref name="source"/> is what the tokens stand for.</summary>
    public void Write(ReadOnlySpan<int> tokens, ReadOnlySpan<byte> source, BitSink sink, DeflateBlockPlace place)
    {
        CountSymbols(tokens);
        literals.Build(literalCounts, LongestCode);
        distances.Build(distanceCounts, LongestCode);
        int literalUsed = LastUsed(literals.Lengths, 257);
        int distanceUsed = LastUsed(distances.Lengths, 1);
        CodeRuns(literalUsed, distanceUsed);
        codeLengths.Build(lengthCounts, LongestCodeOfLengths);
        int lengthsUsed = 19;
        while (lengthsUsed > 4 && codeLengths.Lengths[DeflateTables.CodeLengthOrder[lengthsUsed - 1]] == 0)
        {
            lengthsUsed--;
        }

        long extra = ExtraBits();
        long dynamicBits = 14 + (3 * lengthsUsed) + RunBits() + extra + BodyBits(literals.Lengths, distances.Lengths);
        long fixedBits = extra + BodyBits(DeflateTables.FixedLiteralLengths, DeflateTables.FixedDistanceLengths);
        long storedBits = (source.Length * 8L) + (40L * (1 + (source.Length / LongestStored)));
        sink.Reserve(Math.Min(Math.Min(dynamicBits, fixedBits), storedBits) + 64);
        uint last = place == DeflateBlockPlace.Last ? 1u : 0u;
        if (storedBits < Math.Min(dynamicBits, fixedBits))
        {
            WriteStored(source, sink, last);
        }
        else if (fixedBits <= dynamicBits)
        {
            sink.Write(last | (1u << 1), 3);
            var literalCodes = new ushort[288];
            var distanceCodes = new ushort[DeflateTables.DistanceSymbols];
            HuffmanCode.AssignCodes(DeflateTables.FixedLiteralLengths, literalCodes);
            HuffmanCode.AssignCodes(DeflateTables.FixedDistanceLengths, distanceCodes);
            WriteBody(tokens, sink, DeflateTables.FixedLiteralLengths, literalCodes, DeflateTables.FixedDistanceLengths, distanceCodes);
        }
        else
        {
            sink.Write(last | (2u << 1), 3);
            WriteHeader(sink, literalUsed, distanceUsed, lengthsUsed);
            WriteBody(tokens, sink, literals.Lengths, literals.Codes, distances.Lengths, distances.Codes);
        }
    }

    /// <summary>Writes an inner block of no bytes, after which the stream goes on at a whole byte.</summary>
    public static void WriteNothing(BitSink sink)
    {
        sink.Reserve(64);
        WriteStored(default, sink, 0);
    }

    private static int LastUsed(ReadOnlySpan<byte> lengths, int min)
    {
        int used = lengths.Length;
        while (used > min && lengths[used - 1] == 0)
        {
            used--;
        }

        return used;
    }

    private static void WriteStored(ReadOnlySpan<byte> source, BitSink sink, uint last)
    {
        do
        {
            int length = Math.Min(source.Length, LongestStored);
            sink.Write(length == source.Length ? last : 0, 3);
            sink.Align();
            sink.Append([(byte)length, (byte)(length >> 8), (byte)~length, (byte)(~length >> 8)]);
            sink.Append(source[..length]);
            source = source[length..];
        }
        while (source.Length > 0);
    }

    private static void WriteBody(ReadOnlySpan<int> tokens, BitSink sink, ReadOnlySpan<byte> literalLengths, ReadOnlySpan<ushort> literalCodes, ReadOnlySpan<byte> distanceLengths, ReadOnlySpan<ushort> distanceCodes)
    {
        foreach (int token in tokens)
        {
            if (token < 1 << 16)
            {
                sink.Write(literalCodes[token], literalLengths[token]);
                continue;
            }

            int length = token >> 16;
            int index = DeflateTables.LengthIndex(length);
            int symbol = 257 + index;
            ulong bits = literalCodes[symbol];
            int count = literalLengths[symbol];
            bits |= (ulong)(uint)(length - DeflateTables.ShortestLength(index)) << count;
            count += DeflateTables.ExtraLengthBits(index);
            int distance = (token & 0xFFFF) + 1;
            symbol = DeflateTables.DistanceSymbol(distance);
            bits |= (ulong)distanceCodes[symbol] << count;
            count += distanceLengths[symbol];
            bits |= (ulong)(uint)(distance - DeflateTables.ShortestDistance(symbol)) << count;
            sink.Write(bits, count + DeflateTables.ExtraDistanceBits(symbol));
        }

        sink.Write(literalCodes[DeflateTables.EndOfBlock], literalLengths[DeflateTables.EndOfBlock]);
    }

    private void CountSymbols(ReadOnlySpan<int> tokens)
    {
        literalCounts.AsSpan().Clear();
        distanceCounts.AsSpan().Clear();
        foreach (int token in tokens)
        {
            if (token < 1 << 16)
            {
                literalCounts[token]++;
            }
            else
            {
                literalCounts[257 + DeflateTables.LengthIndex(token >> 16)]++;
                distanceCounts[DeflateTables.DistanceSymbol((token & 0xFFFF) + 1)]++;
            }
        }

        literalCounts[DeflateTables.EndOfBlock] = 1;
    }

    private void CodeRuns(int literalUsed, int distanceUsed)
    {
        lengthCounts.AsSpan().Clear();
        runCount = 0;
        int total = literalUsed + distanceUsed;
        for (int i = 0; i < total;)
        {
            byte value = LengthAt(i, literalUsed);
            int run = 1;
            while (i + run < total && LengthAt(i + run, literalUsed) == value)
            {
                run++;
            }

            i += run;
            if (value == 0)
            {
                while (run >= 11)
                {
                    int part = Math.Min(run, 138);
                    AddRun(18, part - 11);
                    run -= part;
                }

                if (run >= 3)
                {
                    AddRun(17, run - 3);
                    run = 0;
                }
            }
            else
            {
                AddRun(value, 0);
                run--;
                while (run >= 3)
                {
                    int part = Math.Min(run, 6);
                    AddRun(16, part - 3);
                    run -= part;
                }
            }

            for (; run > 0; run--)
            {
                AddRun(value, 0);
            }
        }
    }

    private byte LengthAt(int i, int literalUsed) => i < literalUsed ? literals.Lengths[i] : distances.Lengths[i - literalUsed];

    private void AddRun(int symbol, int extra)
    {
        runSymbols[runCount] = (byte)symbol;
        runExtras[runCount++] = (byte)extra;
        lengthCounts[symbol]++;
    }

    private long RunBits()
    {
        long bits = (2L * lengthCounts[16]) + (3L * lengthCounts[17]) + (7L * lengthCounts[18]);
        for (int i = 0; i < lengthCounts.Length; i++)
        {
            bits += (long)lengthCounts[i] * codeLengths.Lengths[i];
        }

        return bits;
    }

    private long ExtraBits()
    {
        long bits = 0;
        for (int i = 257; i < literalCounts.Length; i++)
        {
            bits += (long)literalCounts[i] * DeflateTables.ExtraLengthBits(i - 257);
        }

        for (int i = 0; i < distanceCounts.Length; i++)
        {
            bits += (long)distanceCounts[i] * DeflateTables.ExtraDistanceBits(i);
        }

        return bits;
    }

    private long BodyBits(ReadOnlySpan<byte> literalLengths, ReadOnlySpan<byte> distanceLengths)
    {
        long bits = 3;
        for (int i = 0; i < literalCounts.Length; i++)
        {
            bits += (long)literalCounts[i] * literalLengths[i];
        }

        for (int i = 0; i < distanceCounts.Length; i++)
        {
            bits += (long)distanceCounts[i] * distanceLengths[i];
        }

        return bits;
    }

    private void WriteHeader(BitSink sink, int literalUsed, int distanceUsed, int lengthsUsed)
    {
        sink.Write((uint)(literalUsed - 257), 5);
        sink.Write((uint)(distanceUsed - 1), 5);
        sink.Write((uint)(lengthsUsed - 4), 4);
        for (int i = 0; i < lengthsUsed; i++)
        {
            sink.Write(codeLengths.Lengths[DeflateTables.CodeLengthOrder[i]], 3);
        }

        for (int i = 0; i < runCount; i++)
        {
            int symbol = runSymbols[i];
            sink.Write(codeLengths.Codes[symbol], codeLengths.Lengths[symbol]);
            sink.Write(runExtras[i], symbol switch { 16 => 2, 17 => 3, 18 => 7, _ => 0 });
        }
    }
}
