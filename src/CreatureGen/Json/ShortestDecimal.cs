using System;

namespace CreatureGen.Json;

/// <summary>The shortest decimal number that reads back as the same binary one; of several, the one nearest to it.</summary>
/// <remarks>
/// Based on: R. Giulietti, "The Schubfach way to render doubles" (2020). Whole-number arithmetic alone, so that every runtime gives the same digits.
/// </remarks>
internal readonly struct ShortestDecimal
{
    private ShortestDecimal(ulong digits, int exponent)
    {
        while (digits != 0 && digits % 10 == 0)
        {
            digits /= 10;
            exponent++;
        }

        Digits = digits;
        Exponent = exponent;
    }

    /// <summary>The digits as a whole number of at most 17 digits that does not end in 0, or 0.</summary>
    public ulong Digits { get; }

    /// <summary>The number is digits · 10^exponent.</summary>
    public int Exponent { get; }

    /// <summary>The shortest decimal of the magnitude of a finite number.</summary>
    public static ShortestDecimal Of(double value)
    {
        ulong bits = (ulong)BitConverter.DoubleToInt64Bits(value);
        return Of(bits & 0x000FFFFFFFFFFFFF, (int)(bits >> 52) & 0x7FF, 52, 1075);
    }

    /// <summary>The shortest decimal of the magnitude of a finite number of single precision.</summary>
    public static ShortestDecimal Of(float value)
    {
        uint bits = (uint)BitConverter.SingleToInt32Bits(value);
        return Of(bits & 0x007FFFFF, (int)(bits >> 23) & 0xFF, 23, 150);
    }

    private static ShortestDecimal Of(ulong fraction, int biased, int fractionBits, int bias)
    {
        if (fraction == 0 && biased == 0)
        {
            return new ShortestDecimal(0, 0);
        }

        // The number is c · 2^q.
        ulong c = biased == 0 ? fraction : fraction | (1UL << fractionBits);
        int q = biased == 0 ? 1 - bias : biased - bias;
        if (q <= 0 && -q <= fractionBits && (c & ((1UL << -q) - 1)) == 0)
        {
            return new ShortestDecimal(c >> -q, 0);
        }

        // Below a power of two the neighbour is only half as far away.
        bool lowerIsCloser = fraction == 0 && biased > 1;
        ulong odd = c & 1;
        int k = ((q * 1262611) - (lowerIsCloser ? 524031 : 0)) >> 22;
        int h = q + PowersOfTen.FloorLog2(-k) + 1;
        ulong high = PowersOfTen.High(-k);
        ulong low = PowersOfTen.Low(-k);

        // Four times the number and the ends of its rounding interval, in units of 10^k. The ends belong to even numbers only.
        ulong lower = RoundToOdd(high, low, ((4 * c) - (lowerIsCloser ? 1UL : 2UL)) << h) + odd;
        ulong middle = RoundToOdd(high, low, (4 * c) << h);
        ulong upper = RoundToOdd(high, low, ((4 * c) + 2) << h) - odd;

        ulong s = middle / 4;
        if (s >= 10)
        {
            ulong tens = s / 10;
            bool belowFits = lower <= 40 * tens;
            bool aboveFits = (40 * tens) + 40 <= upper;
            if (belowFits != aboveFits)
            {
                return new ShortestDecimal(aboveFits ? tens + 1 : tens, k + 1);
            }
        }

        bool floorFits = lower <= 4 * s;
        bool ceilingFits = (4 * s) + 4 <= upper;
        if (floorFits != ceilingFits)
        {
            return new ShortestDecimal(ceilingFits ? s + 1 : s, k);
        }

        ulong half = (4 * s) + 2;
        bool up = middle > half || (middle == half && (s & 1) != 0);
        return new ShortestDecimal(up ? s + 1 : s, k);
    }

    /// <summary>The product shifted right by 128 bits, its last bit set when anything was lost.</summary>
    private static ulong RoundToOdd(ulong high, ulong low, ulong factor)
    {
        ulong carried = Multiply(low, factor, out _);
        ulong top = Multiply(high, factor, out ulong rest);
        rest = unchecked(rest + carried);
        if (rest < carried)
        {
            top++;
        }

        return rest > 1 ? top | 1 : top;
    }

    /// <summary>The upper and the lower half of a product.</summary>
    private static ulong Multiply(ulong a, ulong b, out ulong lower)
    {
        unchecked
        {
            ulong a0 = (uint)a;
            ulong a1 = a >> 32;
            ulong b0 = (uint)b;
            ulong b1 = b >> 32;
            ulong p00 = a0 * b0;
            ulong p10 = (a1 * b0) + (p00 >> 32);
            ulong p01 = (a0 * b1) + (uint)p10;
            lower = (p01 << 32) | (uint)p00;
            return (a1 * b1) + (p10 >> 32) + (p01 >> 32);
        }
    }
}
