using System.Numerics;

namespace CreatureGen.Json;

/// <summary>The leading 128 bits of the powers of ten that the range of a double needs, rounded up.</summary>
internal static class PowersOfTen
{
    /// <summary>Least exponent.</summary>
    public const int Minimum = -292;

    /// <summary>Greatest exponent.</summary>
    public const int Maximum = 324;

    private static readonly ulong[] high = new ulong[Maximum - Minimum + 1];
    private static readonly ulong[] low = new ulong[Maximum - Minimum + 1];

    static PowersOfTen()
    {
        BigInteger power = BigInteger.One;
        for (int exponent = 0; exponent <= Maximum; exponent++)
        {
            int shift = 127 - FloorLog2(exponent);
            Store(exponent, shift >= 0 ? power << shift : -(-power >> -shift));
            if (exponent > 0 && -exponent >= Minimum)
            {
                Store(-exponent, (BigInteger.One << (127 - FloorLog2(-exponent))) / power + 1);
            }

            power *= 10;
        }
    }

    /// <summary>The greatest whole number not above log₂ 10^<paramref name="exponent"/>, for exponents within ±1233.</summary>
    public static int FloorLog2(int exponent) => (exponent * 1741647) >> 19;

    /// <summary>Bits 127..64 of ⌈10^exponent · 2^(127 − <see cref="FloorLog2"/>)⌉.</summary>
    public static ulong High(int exponent) => high[exponent - Minimum];

    /// <summary>Bits 63..0 of the same number.</summary>
    public static ulong Low(int exponent) => low[exponent - Minimum];

    private static void Store(int exponent, BigInteger bits)
    {
        high[exponent - Minimum] = (ulong)(bits >> 64);
        low[exponent - Minimum] = (ulong)(bits & ulong.MaxValue);
    }
}
