using System;
using System.Numerics;

namespace CreatureGen.Json;

/// <summary>Reads decimal numbers as the nearest double, ties to even, on every runtime alike.</summary>
/// <remarks>
/// Based on: W. D. Clinger, "How to read floating point numbers accurately" (1990): few digits and a small power of ten need one correctly rounded operation;
/// all else is an exact division of whole numbers.
/// </remarks>
internal static class NumberParser
{
    /// <summary>Digits beyond these can only break ties (a double and its halfway points have at most 767).</summary>
    private const int SignificantDigits = 800;

    private const ulong ExactWhole = 1UL << 53;

    private static readonly double[] exactPowers =
    {
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
    };

    /// <summary>Powers of ten that numbers of seventeen digits, as blueprints are full of, are divided by.</summary>
    private static readonly BigInteger[] smallPowers = Powers(40);

    /// <summary>The double nearest to a number; infinite when it is beyond the range of a double.</summary>
    /// <param name="text">ASCII text that follows the grammar of numbers in JSON; not checked here.</param>
    public static double Parse(ReadOnlySpan<byte> text)
    {
        bool negative = text[0] == (byte)'-';
        int at = negative ? 1 : 0;
        ulong leading = 0;
        int digitCount = 0;
        int firstDigit = -1;
        long exponent = 0;
        bool fraction = false;
        for (; at < text.Length; at++)
        {
            byte character = text[at];
            if (character == (byte)'.')
            {
                fraction = true;
                continue;
            }

            if (character < (byte)'0' || character > (byte)'9')
            {
                break;
            }

            exponent -= fraction ? 1 : 0;
            if (firstDigit < 0 && character == (byte)'0')
            {
                continue;
            }

            firstDigit = firstDigit < 0 ? at : firstDigit;
            digitCount++;
            if (digitCount <= 19)
            {
                leading = (leading * 10) + (ulong)(character - '0');
            }
        }

        int endOfDigits = at;
        exponent += at < text.Length ? Exponent(text.Slice(at + 1)) : 0;
        double magnitude = digitCount switch
        {
            0 => 0,
            <= 19 => Magnitude(leading, exponent),
            _ => Magnitude(text.Slice(firstDigit, endOfDigits - firstDigit), digitCount, exponent),
        };
        return negative ? -magnitude : magnitude;
    }

    private static long Exponent(ReadOnlySpan<byte> text)
    {
        bool negative = text[0] == (byte)'-';
        long exponent = 0;
        for (int i = negative || text[0] == (byte)'+' ? 1 : 0; i < text.Length; i++)
        {
            // Far beyond the length of any text, so that digits cannot bring the number back into range.
            exponent = Math.Min(1L << 40, (exponent * 10) + (text[i] - '0'));
        }

        return negative ? -exponent : exponent;
    }

    private static double Magnitude(ulong whole, long exponent)
    {
        if (whole <= ExactWhole && exponent >= -22 && exponent <= 22)
        {
            double exact = (long)whole;
            return exponent < 0 ? exact / exactPowers[-exponent] : exact * exactPowers[exponent];
        }

        return Scale(whole, 19, exponent);
    }

    private static double Magnitude(ReadOnlySpan<byte> digits, int count, long exponent)
    {
        BigInteger whole = BigInteger.Zero;
        ulong group = 0;
        ulong groupSize = 1;
        int taken = 0;
        bool more = false;
        foreach (byte character in digits)
        {
            if (character == (byte)'.')
            {
                continue;
            }

            if (taken == SignificantDigits)
            {
                more |= character != (byte)'0';
                continue;
            }

            taken++;
            group = (group * 10) + (ulong)(character - '0');
            groupSize *= 10;
            if (groupSize == 1_000_000_000_000_000_000)
            {
                whole = (whole * groupSize) + group;
                group = 0;
                groupSize = 1;
            }
        }

        whole = (whole * groupSize) + group;
        exponent += count - taken;
        return more ? Scale((whole * 10) + 1, taken + 1, exponent - 1) : Scale(whole, taken, exponent);
    }

    /// <summary>The double nearest to whole · 10^exponent, where whole is positive and has at most the given number of digits.</summary>
    private static double Scale(BigInteger whole, int digits, long exponent)
    {
        if (exponent > 309)
        {
            return double.PositiveInfinity;
        }

        if (digits + exponent < -325)
        {
            return 0;
        }

        return exponent >= 0
            ? Divide(whole * PowerOfTen((int)exponent), BigInteger.One)
            : Divide(whole, PowerOfTen((int)-exponent));
    }

    private static BigInteger PowerOfTen(int exponent) => exponent < smallPowers.Length ? smallPowers[exponent] : BigInteger.Pow(10, exponent);

    private static BigInteger[] Powers(int count)
    {
        var powers = new BigInteger[count];
        for (int i = 0; i < count; i++)
        {
            powers[i] = BigInteger.Pow(10, i);
        }

        return powers;
    }

    private static double Divide(BigInteger numerator, BigInteger denominator)
    {
        // A quotient of 55 or 56 bits: 53 for the mantissa and at least two to round by.
        int shift = 55 - (BitLength(numerator) - BitLength(denominator));
        BigInteger quotient = BigInteger.DivRem(
            shift > 0 ? numerator << shift : numerator,
            shift < 0 ? denominator << -shift : denominator,
            out BigInteger remainder);
        ulong bits = (ulong)quotient;
        int length = bits >> 55 != 0 ? 56 : 55;
        int exponent = Math.Max(length - 53 - shift, -1074);
        int dropped = exponent + shift;
        if (dropped > 57)
        {
            return 0;
        }

        ulong mantissa = bits >> dropped;
        ulong rest = bits & ((1UL << dropped) - 1);
        ulong half = 1UL << (dropped - 1);
        if (rest > half || (rest == half && (!remainder.IsZero || (mantissa & 1) != 0)))
        {
            mantissa++;
        }

        if (mantissa == ExactWhole)
        {
            mantissa >>= 1;
            exponent++;
        }

        if (exponent > 971)
        {
            return double.PositiveInfinity;
        }

        bool normal = mantissa >= ExactWhole >> 1;
        ulong encoded = normal ? ((ulong)(exponent + 1075) << 52) | (mantissa & ((ExactWhole >> 1) - 1)) : mantissa;
        return BitConverter.Int64BitsToDouble((long)encoded);
    }

    private static int BitLength(BigInteger positive)
    {
        byte[] bytes = positive.ToByteArray();
        int last = bytes.Length - 1;
        int length = last * 8;
        for (int top = bytes[last]; top != 0; top >>= 1)
        {
            length++;
        }

        return length;
    }
}
