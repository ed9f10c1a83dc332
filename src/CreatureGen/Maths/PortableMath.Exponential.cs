using System;
using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <content>Exponential, logarithm, powers.</content>
internal static partial class PortableMath
{
    private const double OverLn2 = 1.4426950408889634;

    // ln 2 in two parts; the first has 42 bits, so that its product with an exponent is exact.
    private const double Ln2High = 0.6931471805598903;
    private const double Ln2Low = 5.497923018708371e-14;

    // Minimax polynomial (Remez exchange) on ±ln 2 / 2: (e^r − 1 − r) / r².
    private const double E0 = 0.5;
    private const double E1 = 0.16666666666666685;
    private const double E2 = 0.04166666666666673;
    private const double E3 = 0.008333333333316617;
    private const double E4 = 0.0013888888888858367;
    private const double E5 = 0.0001984126989736183;
    private const double E6 = 2.480158737386184e-05;
    private const double E7 = 2.7557233929644214e-06;
    private const double E8 = 2.7557233269697917e-07;
    private const double E9 = 2.511234837704785e-08;
    private const double E10 = 2.0926968620302314e-09;

    // Minimax polynomial (Remez exchange) on 0..(1/45)² in s²: (2 artanh s − 2s) / s³.
    private const double L0 = 0.6666666666666666;
    private const double L1 = 0.3999999999999968;
    private const double L2 = 0.28571428574415053;
    private const double L3 = 0.22222210077082316;
    private const double L4 = 0.18204235507187264;

    private const long OneBits = 0x3FF0000000000000L;
    private const long RootHalfBits = 0x3FE6A09E667F3BCDL;

    /// <summary>The logarithms of 11/16, 12/16, … 23/16 to 42 binary places, and below them what is missing.</summary>
    private static readonly double[] LogOfSixteenths =
    {
        -0.3746934494413381, -0.28768207245184385, -0.20763936477828793, -0.13353139262449076,
        -0.0645385211375924, 0, 0.06062462181648698, 0.11778303565643,
        0.17185025692674571, 0.22314355131425145, 0.2719337154835557, 0.31845373111855224,
        0.3629054936893681,
        -7.260466149925637e-14, 6.292357389008195e-14, 4.3425422595242564e-14, -3.1859736349078334e-14,
        2.1225608044809997e-14, 0, -5.213620639136504e-14, -4.654729747598445e-14,
        -8.649239607212071e-14, -4.169796584527195e-14, 8.604306772808733e-14, -1.7625431312172662e-14,
        3.6708569716349383e-16,
    };

    /// <summary>e to the power x, within 0.7 ulp; 0 below −745.13, infinity above 709.78.</summary>
    public static double Exp(double x)
    {
        if (!(x <= 710))
        {
            return x > 710 ? double.PositiveInfinity : double.NaN;
        }

        return x < -746 ? 0 : ExpOfSum(x, 0);
    }

    /// <summary>Natural logarithm, within 0.51 ulp; minus infinity at zero, NaN below.</summary>
    public static double Log(double x)
    {
        if (!(x > 0 && x <= double.MaxValue))
        {
            return x == 0 ? double.NegativeInfinity : x > 0 ? x : double.NaN;
        }

        return LogAsSum(x, out _);
    }

    /// <summary>x to the power y, within 0.8 ulp; whole powers of negative numbers included, other powers of them give NaN.</summary>
    /// <remarks>e to the power of y times the logarithm, the logarithm and the product held to some 100 bits. Powers that a double can hold exactly are exact.</remarks>
    public static double Pow(double x, double y)
    {
        if (y == 0 || x == 1)
        {
            return 1;
        }

        if (double.IsNaN(x) || double.IsNaN(y))
        {
            return double.NaN;
        }

        double magnitude = Math.Abs(x);
        double size = Math.Abs(y);
        bool negative = false;
        if (BitConverter.DoubleToInt64Bits(x) < 0)
        {
            bool whole = Math.Floor(size) == size;
            negative = whole && size < 9007199254740992.0 && ((long)size & 1) != 0;
            if (!whole && x < 0 && magnitude <= double.MaxValue)
            {
                return double.NaN;
            }
        }

        double result;
        if (magnitude == 1)
        {
            result = 1;
        }
        else if (magnitude == 0 || magnitude > double.MaxValue || size > 1e20)
        {
            result = magnitude > 1 == y > 0 ? double.PositiveInfinity : 0;
        }
        else if (size < 1e-20)
        {
            result = 1;
        }
        else
        {
            double log = LogAsSum(magnitude, out double logRest);
            double power = ErrorFree.Product(y, log, out double rest);
            rest += y * logRest;
            result = power > 710 ? double.PositiveInfinity : power < -746 ? 0 : ExpOfSum(power, rest);
        }

        return negative ? -result : result;
    }

    /// <summary>Cube root of any number, within 0.51 ulp.</summary>
    /// <remarks>Two of Halley's steps from a guess made of the argument's bits, then one of Newton's with the cube held to twice the bits.</remarks>
    public static double Cbrt(double x)
    {
        double magnitude = Math.Abs(x);
        if (x == 0 || !(magnitude <= double.MaxValue))
        {
            return x;
        }

        int third = 0;
        if (magnitude < 1e-300)
        {
            magnitude *= 1L << 54;
            third = -18;
        }

        long bits = BitConverter.DoubleToInt64Bits(magnitude);
        int exponent = (int)(bits >> 52) - 1023;
        int whole = (exponent + 1200) / 3 - 400;
        double m = BitConverter.Int64BitsToDouble(bits - ((long)(whole * 3) << 52));
        third += whole;

        double t = BitConverter.Int64BitsToDouble((BitConverter.DoubleToInt64Bits(m) / 3) + 0x2A9F74BC6A7EFA00L);
        double cube = t * t * t;
        t *= (cube + (2 * m)) / ((2 * cube) + m);
        cube = t * t * t;
        t *= (cube + (2 * m)) / ((2 * cube) + m);

        double square = ErrorFree.Square(t, out double squareRest);
        cube = ErrorFree.Product(square, t, out double cubeRest);
        t += ((m - cube) - (cubeRest + (squareRest * t))) / (3 * square);
        t *= PowerOfTwo(third);
        return x < 0 ? -t : t;
    }

    /// <summary>e to the power x + rest, x from −746 to 710.</summary>
    private static double ExpOfSum(double x, double rest)
    {
        double n = ((x * OverLn2) + RoundingShift) - RoundingShift;
        double high = x - (n * Ln2High);
        double low = n * Ln2Low;
        double r = high - low;
        r = ErrorFree.OrderedSum(r, ((high - r) - low) + rest, out double rRest);

        double r2 = r * r;
        double r4 = r2 * r2;
        double p = ((E0 + (r * E1)) + (r2 * (E2 + (r * E3))))
            + (r4 * (((E4 + (r * E5)) + (r2 * (E6 + (r * E7)))) + (r4 * ((E8 + (r * E9)) + (r2 * E10)))));
        double sum = ErrorFree.OrderedSum(1, r, out double sumRest);
        return Scale(sum + (sumRest + ((r2 * p) + (rRest * sum))), (int)n);
    }

    /// <summary>Natural logarithm of a positive finite number, and what it has beyond a double, some 65 bits together at the least.</summary>
    /// <remarks>The exponent and the nearest sixteenth c are taken from the argument m; the rest is ln(m/c) = 2 artanh((m − c)/(m + c)).</remarks>
    private static double LogAsSum(double x, out double rest)
    {
        int exponent = 0;
        if (x < 2.2250738585072014e-308)
        {
            x *= 1L << 54;
            exponent = -54;
        }

        long bits = BitConverter.DoubleToInt64Bits(x);
        long shift = (bits - RootHalfBits) >> 52;
        exponent += (int)shift;
        double m = BitConverter.Int64BitsToDouble(bits - (shift << 52));
        int sixteenths = (int)((m * 16) + 0.5);
        double c = sixteenths * 0.0625;

        double f = m - c;
        double divisor = ErrorFree.OrderedSum(2 * c, f, out double divisorRest);
        double s = f / divisor;
        double product = ErrorFree.Product(s, divisor, out double productRest);
        double sRest = (((f - product) - productRest) - (s * divisorRest)) / divisor;

        double w = s * s;
        double series = s * w * ((L0 + (w * L1)) + (w * w * ((L2 + (w * L3)) + (w * w * L4))));
        double whole = (exponent * Ln2High) + LogOfSixteenths[sixteenths - 11];
        whole = ErrorFree.OrderedSum(whole, 2 * s, out double wholeRest);
        wholeRest += ((exponent * Ln2Low) + LogOfSixteenths[sixteenths + 2]) + (series + (2 * sRest));
        return ErrorFree.OrderedSum(whole, wholeRest, out rest);
    }

    /// <summary>x · 2^power rounded once, for x near 1 and powers from −1080 to 1024.</summary>
    private static double Scale(double x, int power)
    {
        if (power > 1023)
        {
            return x * PowerOfTwo(1023) * 2;
        }

        return power >= -1022 ? x * PowerOfTwo(power) : x * PowerOfTwo(-1000) * PowerOfTwo(power + 1000);
    }

    /// <summary>2^power, power from −1022 to 1023.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double PowerOfTwo(int power) => BitConverter.Int64BitsToDouble(OneBits + ((long)power << 52));
}
