using System;

namespace CreatureGen.Maths;

/// <summary>Takes multiples of π/2 from an angle so that at most π/4 is left.</summary>
internal static class AngleReduction
{
    private const double TwoOverPi = 0.6366197723675814;

    // π/2 in three parts; the first two have 33 bits, so that their products with a whole number below 2^20 are exact.
    private const double HalfPi1 = 1.5707963267341256;
    private const double HalfPi2 = 6.077100506303966e-11;
    private const double HalfPi3 = 2.0222662487959506e-21;

    private const double HalfPi = 1.5707963267948966;
    private const double HalfPiRest = 6.123233995736766e-17;

    private const double RoundingShift = 6755399441055744.0;

    // 2^20 · π/2 is the end of the exact products; what is left of a smaller angle must keep 2^−30 for its rest to have all its bits.
    private const double PartsEnd = 1.6e6;
    private const double PartsMin = 1.0 / (1 << 30);

    /// <summary>64 zero bits, then the first 1216 binary digits of 2/π.</summary>
    private static readonly ulong[] TwoOverPiDigits =
    {
        0,
        0xA2F9836E4E441529UL, 0xFC2757D1F534DDC0UL, 0xDB6295993C439041UL, 0xFE5163ABDEBBC561UL,
        0xB7246E3A424DD2E0UL, 0x06492EEA09D1921CUL, 0xFE1DEB1CB129A73EUL, 0xE88235F52EBB4484UL,
        0xE99C7026B45F7E41UL, 0x3991D639835339F4UL, 0x9C845F8BBDF9283BUL, 0x1FF897FFDE05980FUL,
        0xEF2F118B5A0A6D1FUL, 0x6D367ECF27CB09B7UL, 0x4F463F669E5FEA2DUL, 0x7527BAC7EBE5F17BUL,
        0x3D0739F78A5292EAUL, 0x6BFB5FB11F8D5D08UL, 0x56033046FC7B6BABUL,
    };

    /// <summary>The quarter turns nearest to <paramref name="x"/>, of which the low two bits count, and what is left of x as the sum of a number and its small rest.</summary>
    /// <param name="x">A finite angle of more than π/4 on either side, radians.</param>
    /// <param name="left">x less the quarter turns, −π/4..π/4.</param>
    /// <param name="rest">What the exact difference has beyond <paramref name="left"/>.</param>
    /// <remarks>Based on: W. J. Cody and W. Waite, "Software Manual for the Elementary Functions" (1980), for angles up to 1.6e6 that are not next to a multiple of π/2; the others go through all digits of 2/π.</remarks>
    internal static int Quarters(double x, out double left, out double rest)
    {
        if (Math.Abs(x) < PartsEnd)
        {
            double n = ((x * TwoOverPi) + RoundingShift) - RoundingShift;
            double high = ErrorFree.Sum(x - (n * HalfPi1), -(n * HalfPi2), out double low);
            if (Math.Abs(high) >= PartsMin)
            {
                left = ErrorFree.OrderedSum(high, -(n * HalfPi3), out rest);
                rest += low;
                return (int)n;
            }
        }

        return QuartersByDigits(x, out left, out rest);
    }

    /// <summary>The same for any finite angle of at least 2^−10, slower.</summary>
    /// <remarks>Based on: M. Payne and R. Hanek, "Radian reduction for trigonometric functions" (1983): only those digits of 2/π are multiplied that lie between whole turns and noise.</remarks>
    internal static int QuartersByDigits(double x, out double left, out double rest)
    {
        long bits = BitConverter.DoubleToInt64Bits(x);
        int exponent = (int)((bits >> 52) & 0x7FF) - 1075;
        ulong significand = (ulong)(bits & 0xFFFFFFFFFFFFF) | 0x10000000000000UL;

        // |x| = significand · 2^exponent. Digit i of 2/π weighs 2^−i: up to i = exponent − 2 its product is a multiple of 4 quarter turns.
        // The window starts at digit exponent − 1, and the lowest of the product's 192 bits weighs 2^−190.
        int start = exponent + 62;
        ulong a = Digits(start);
        ulong b = Digits(start + 64);
        ulong c = Digits(start + 128);

        ulong w0 = Multiply(c, significand, out ulong carry0);
        ulong w1 = Multiply(b, significand, out ulong carry1);
        ulong w2;
        unchecked
        {
            w1 += carry0;
            carry1 += w1 < carry0 ? 1UL : 0UL;
            w2 = (a * significand) + carry1;
        }

        int quarters = (int)(w2 >> 62);
        w2 &= 0x3FFFFFFFFFFFFFFFUL;
        bool above = (w2 >> 61) != 0;
        if (above)
        {
            quarters++;
            unchecked
            {
                w0 = ~w0 + 1;
                w1 = ~w1 + (w0 == 0 ? 1UL : 0UL);
                w2 = (~w2 + (w0 == 0 && w1 == 0 ? 1UL : 0UL)) & 0x3FFFFFFFFFFFFFFFUL;
            }
        }

        double fraction = 0;
        double fractionRest = 0;
        Add(w2 >> 32, Power(-30), ref fraction, ref fractionRest);
        Add(w2 & 0xFFFFFFFFUL, Power(-62), ref fraction, ref fractionRest);
        Add(w1 >> 32, Power(-94), ref fraction, ref fractionRest);
        Add(w1 & 0xFFFFFFFFUL, Power(-126), ref fraction, ref fractionRest);
        Add(w0 >> 32, Power(-158), ref fraction, ref fractionRest);
        Add(w0 & 0xFFFFFFFFUL, Power(-190), ref fraction, ref fractionRest);

        left = ErrorFree.Product(fraction, HalfPi, out rest);
        rest += (fraction * HalfPiRest) + (fractionRest * HalfPi);
        left = ErrorFree.OrderedSum(left, rest, out rest);
        if (above)
        {
            left = -left;
            rest = -rest;
        }

        if (bits < 0)
        {
            left = -left;
            rest = -rest;
            quarters = -quarters;
        }

        return quarters;
    }

    /// <summary>64 digits from the given place of <see cref="TwoOverPiDigits"/>.</summary>
    private static ulong Digits(int place)
    {
        int word = place >> 6;
        int shift = place & 63;
        ulong digits = TwoOverPiDigits[word] << shift;
        return shift == 0 ? digits : digits | (TwoOverPiDigits[word + 1] >> (64 - shift));
    }

    /// <summary>The low 64 bits of a product, and the high ones.</summary>
    private static ulong Multiply(ulong a, ulong b, out ulong high)
    {
        unchecked
        {
            ulong low = (a & 0xFFFFFFFFUL) * (b & 0xFFFFFFFFUL);
            ulong middle = ((a >> 32) * (b & 0xFFFFFFFFUL)) + (low >> 32);
            ulong other = ((a & 0xFFFFFFFFUL) * (b >> 32)) + (middle & 0xFFFFFFFFUL);
            high = ((a >> 32) * (b >> 32)) + (middle >> 32) + (other >> 32);
            return a * b;
        }
    }

    private static double Power(int exponent) => BitConverter.Int64BitsToDouble((long)(exponent + 1023) << 52);

    private static void Add(ulong digits, double weight, ref double sum, ref double rest)
    {
        sum = ErrorFree.OrderedSum(sum, (uint)digits * weight, out double error);
        rest += error;
    }
}
