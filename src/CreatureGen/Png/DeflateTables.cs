using System;

namespace CreatureGen.Png;

/// <summary>The fixed tables of deflate (RFC 1951): symbols of match lengths and distances, and the code without a header.</summary>
internal static class DeflateTables
{
    public const int LiteralSymbols = 286;
    public const int DistanceSymbols = 30;
    public const int EndOfBlock = 256;

    private static readonly ushort[] LengthStart = [3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258];
    private static readonly byte[] LengthBits = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0];
    private static readonly ushort[] DistanceStart = [1, 2, 3, 4, 5, 7, 9, 13, 17, 25, 33, 49, 65, 97, 129, 193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577];
    private static readonly byte[] DistanceBits = [0, 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13];

    // Distances up to NearDistances have an entry each in the table of their symbols; of farther ones FarStep in a row have the same symbol and share one.
    private const int NearDistances = 256;
    private const int FarStep = 128;

    private static readonly byte[] LengthToIndex = MakeLengthToIndex();
    private static readonly byte[] DistanceToSymbol = MakeDistanceToSymbol();

    /// <summary>The order in which the lengths of the code of code lengths are stored.</summary>
    public static ReadOnlySpan<byte> CodeLengthOrder => [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];

    /// <summary>Code lengths of a block with fixed codes.</summary>
    public static byte[] FixedLiteralLengths { get; } = MakeFixedLiteralLengths();

    /// <summary>Code lengths of distances of a block with fixed codes.</summary>
    public static byte[] FixedDistanceLengths { get; } = MakeFixedDistanceLengths();

    /// <summary>Index of the symbol of a match length 3..258; the symbol is 257 more.</summary>
    public static int LengthIndex(int length) => LengthToIndex[length];

    /// <summary>Extra bits of a length symbol.</summary>
    public static int ExtraLengthBits(int index) => LengthBits[index];

    /// <summary>Shortest length of a length symbol.</summary>
    public static int ShortestLength(int index) => LengthStart[index];

    /// <summary>Symbol of a distance 1..32768.</summary>
    public static int DistanceSymbol(int distance) =>
        distance <= NearDistances ? DistanceToSymbol[distance - 1] : DistanceToSymbol[NearDistances + ((distance - 1) / FarStep)];

    /// <summary>Extra bits of a distance symbol.</summary>
    public static int ExtraDistanceBits(int symbol) => DistanceBits[symbol];

    /// <summary>Shortest distance of a distance symbol.</summary>
    public static int ShortestDistance(int symbol) => DistanceStart[symbol];

    private static byte[] MakeLengthToIndex()
    {
        var table = new byte[259];
        int index = 0;
        for (int length = 3; length <= 258; length++)
        {
            while (index + 1 < LengthStart.Length && LengthStart[index + 1] <= length)
            {
                index++;
            }

            table[length] = (byte)index;
        }

        return table;
    }

    private static byte[] MakeDistanceToSymbol()
    {
        var table = new byte[NearDistances + (32768 / FarStep)];
        int symbol = 0;
        for (int distance = 1; distance <= 32768; distance++)
        {
            while (symbol + 1 < DistanceSymbols && DistanceStart[symbol + 1] <= distance)
            {
                symbol++;
            }

            table[distance <= NearDistances ? distance - 1 : NearDistances + ((distance - 1) / FarStep)] = (byte)symbol;
        }

        return table;
    }

    private static byte[] MakeFixedLiteralLengths()
    {
        var lengths = new byte[288];
        for (int i = 0; i < lengths.Length; i++)
        {
            lengths[i] = (byte)(i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8);
        }

        return lengths;
    }

    private static byte[] MakeFixedDistanceLengths()
    {
        var lengths = new byte[DistanceSymbols];
        Array.Fill(lengths, (byte)5);
        return lengths;
    }
}
