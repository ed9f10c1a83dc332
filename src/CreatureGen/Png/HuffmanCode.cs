using System;

namespace CreatureGen.Png;

/// <summary>A canonical prefix code (RFC 1951, 3.2.2) for given frequencies, no code longer than a limit.</summary>
internal sealed class HuffmanCode
{
    private const int LongestCode = 15;

    private readonly int[] leaves;
    private readonly int[] weights;
    private readonly int[] parents;

    public HuffmanCode(int symbols)
    {
        Lengths = new byte[symbols];
        Codes = new ushort[symbols];
        leaves = new int[symbols];
        weights = new int[symbols * 2];
        parents = new int[symbols * 2];
    }

    /// <summary>Bits of each symbol's code; 0 for symbols that have none.</summary>
    public byte[] Lengths { get; }

    /// <summary>Codes with their first bit lowest, ready for <see cref="BitSink"/>.</summary>
    public ushort[] Codes { get; }

    /// <summary>Makes the code for the frequencies (one per symbol, at least two symbols). With fewer than two symbols in use, two get codes of one bit, which decoders need.</summary>
    public void Build(ReadOnlySpan<int> frequencies, int longest)
    {
        Lengths.AsSpan().Clear();
        int used = 0;
        for (int i = 0; i < frequencies.Length; i++)
        {
            if (frequencies[i] > 0)
            {
                leaves[used++] = i;
            }
        }

        if (used < 2)
        {
            int only = used == 1 ? leaves[0] : 0;
            Lengths[only] = 1;
            Lengths[only == 0 ? 1 : 0] = 1;
        }
        else
        {
            AssignLengths(frequencies, used, longest);
        }

        AssignCodes(Lengths, Codes);
    }

    /// <summary>The canonical codes of the given lengths.</summary>
    public static void AssignCodes(ReadOnlySpan<byte> lengths, Span<ushort> codes)
    {
        Span<int> next = stackalloc int[LongestCode + 1];
        next.Clear();
        foreach (byte length in lengths)
        {
            next[length]++;
        }

        int code = 0;
        int shorter = 0;
        for (int bits = 1; bits <= LongestCode; bits++)
        {
            code = (code + shorter) << 1;
            shorter = next[bits];
            next[bits] = code;
        }

        for (int i = 0; i < lengths.Length; i++)
        {
            codes[i] = lengths[i] == 0 ? (ushort)0 : Reverse(next[lengths[i]]++, lengths[i]);
        }
    }

    // Huffman's tree by two queues: sorted leaves, and inner nodes, which come into being in order of weight.
    private void AssignLengths(ReadOnlySpan<int> frequencies, int used, int longest)
    {
        long[] keys = new long[used];
        for (int i = 0; i < used; i++)
        {
            keys[i] = ((long)frequencies[leaves[i]] << 16) | (uint)leaves[i];
        }

        Array.Sort(keys);
        for (int i = 0; i < used; i++)
        {
            leaves[i] = (int)(keys[i] & 0xFFFF);
            weights[i] = (int)(keys[i] >> 16);
        }

        int leaf = 0;
        int inner = used;
        for (int node = used; node < (2 * used) - 1; node++)
        {
            int first = leaf < used && (inner >= node || weights[leaf] <= weights[inner]) ? leaf++ : inner++;
            int second = leaf < used && (inner >= node || weights[leaf] <= weights[inner]) ? leaf++ : inner++;
            weights[node] = weights[first] + weights[second];
            parents[first] = node;
            parents[second] = node;
        }

        // Depths, counted by length; codes beyond the limit are counted at the limit.
        Span<int> count = stackalloc int[longest + 1];
        count.Clear();
        int root = (2 * used) - 2;
        weights[root] = 0;
        for (int node = root - 1; node >= 0; node--)
        {
            weights[node] = weights[parents[node]] + 1;
            if (node < used)
            {
                count[Math.Min(weights[node], longest)]++;
            }
        }

        Shorten(count, longest);
        int at = 0;
        for (int bits = longest; bits >= 1; bits--)
        {
            for (int i = 0; i < count[bits]; i++)
            {
                Lengths[leaves[at++]] = (byte)bits;
            }
        }
    }

    // Lengthens short codes until the code is a prefix code again (Kraft's sum is one).
    private static void Shorten(Span<int> count, int longest)
    {
        long sum = 0;
        for (int bits = 1; bits <= longest; bits++)
        {
            sum += (long)count[bits] << (longest - bits);
        }

        while (sum > 1L << longest)
        {
            int bits = longest - 1;
            while (count[bits] == 0)
            {
                bits--;
            }

            count[bits]--;
            count[bits + 1] += 2;
            count[longest]--;
            sum--;
        }
    }

    private static ushort Reverse(int code, int length)
    {
        int reversed = 0;
        for (int i = 0; i < length; i++)
        {
            reversed = (reversed << 1) | (code & 1);
            code >>= 1;
        }

        return (ushort)reversed;
    }
}
