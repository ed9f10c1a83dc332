using System;
using System.Numerics;

namespace CreatureGen.Tests.Maths;

/// <summary>Elementary functions to 300 and more bits in whole-number arithmetic, and the error of a double against them.</summary>
internal readonly struct Reference
{
    /// <summary>Places after the binary point of all fixed-point numbers here.</summary>
    private const int Places = 360;

    private static readonly BigInteger One = BigInteger.One << Places;
    private static readonly BigInteger Ln2 = 2 * ArtanhOfInverse(3, Places);

    /// <summary>π to 1600 places: enough to take all turns from the largest double.</summary>
    private static readonly BigInteger LongPi = 4 * ((4 * ArctanOfInverse(5, 1600)) - ArctanOfInverse(239, 1600));

    private static readonly BigInteger Pi = LongPi >> (1600 - Places);

    private readonly BigInteger value;
    private readonly int exponent;

    /// <summary>value · 2^exponent.</summary>
    private Reference(BigInteger value, int exponent)
    {
        this.value = value;
        this.exponent = exponent;
    }

    /// <summary>How far the number is from this, in units of the number's last place.</summary>
    public double UlpsTo(double number)
    {
        if (!double.IsFinite(number))
        {
            return double.PositiveInfinity;
        }

        Split(number, out BigInteger significand, out int power);
        int shift = power - exponent;
        Assert(shift is > 20 and < 1000);
        return Math.Abs((double)((significand << shift) - value)) / Math.Pow(2, shift);
    }

    public static Reference Sin(double x)
    {
        int quarters = Reduce(x, out BigInteger left);
        BigInteger result = (quarters & 1) == 0 ? SinSeries(left) : CosSeries(left);
        return new Reference((quarters & 2) == 0 ? result : -result, -Places);
    }

    public static Reference Cos(double x)
    {
        int quarters = Reduce(x, out BigInteger left);
        BigInteger result = (quarters & 1) == 0 ? CosSeries(left) : SinSeries(left);
        return new Reference(((quarters + 1) & 2) == 0 ? result : -result, -Places);
    }

    public static Reference Exp(double x) => ExpOf(Fixed(x));

    public static Reference Log(double x) => new(LogOf(x), -Places);

    public static Reference Pow(double x, double y)
    {
        Split(y, out BigInteger significand, out int power);
        BigInteger product = LogOf(x) * significand;
        return ExpOf(power >= 0 ? product << power : product >> -power);
    }

    public static Reference Atan2(double y, double x)
    {
        Split(y, out BigInteger ys, out int yp);
        Split(x, out BigInteger xs, out int xp);
        int min = Math.Min(yp, xp);
        return new Reference(AngleOf(ys << (yp - min), xs << (xp - min), Math.Atan2(y, x)), -Places);
    }

    public static Reference Asin(double x)
    {
        BigInteger a = Fixed(x);
        return new Reference(AngleOf(a, Root((One * One) - (a * a)), Math.Asin(x)), -Places);
    }

    public static Reference Acos(double x)
    {
        BigInteger a = Fixed(x);
        return new Reference(AngleOf(Root((One * One) - (a * a)), a, Math.Acos(x)), -Places);
    }

    public static Reference Cbrt(double x)
    {
        Split(x, out BigInteger significand, out int power);
        int down = (((power % 3) + 3) % 3) + 900;
        BigInteger cube = BigInteger.Abs(significand) << down;
        BigInteger root = BigInteger.One << ((int)(cube.GetBitLength() / 3) + 1);
        while (true)
        {
            BigInteger next = ((2 * root) + (cube / (root * root))) / 3;
            if (next >= root)
            {
                break;
            }

            root = next;
        }

        return new Reference(root * significand.Sign, (power - down) / 3);
    }

    /// <summary>x is left + n·π/2; returns n mod 4.</summary>
    private static int Reduce(double x, out BigInteger left)
    {
        Split(x, out BigInteger significand, out int power);
        BigInteger angle = power + 1600 >= 0 ? significand << (power + 1600) : significand >> -(power + 1600);
        BigInteger turns = BigInteger.Divide((2 * angle * 2) + LongPi, 2 * LongPi);
        if ((2 * angle * 2) + LongPi < 0)
        {
            turns -= 1;
        }

        left = (angle - ((turns * LongPi) >> 1)) >> (1600 - Places);
        return (int)(((turns % 4) + 4) % 4);
    }

    private static BigInteger SinSeries(BigInteger x) => Alternating(x, x, 2);

    private static BigInteger CosSeries(BigInteger x) => Alternating(One, x, 1);

    private static BigInteger Alternating(BigInteger term, BigInteger x, int divisor)
    {
        BigInteger square = (x * x) >> Places;
        BigInteger sum = 0;
        while (!term.IsZero && term != -1)
        {
            sum += term;
            term = -(((term * square) >> Places) / (divisor * (divisor + 1)));
            divisor += 2;
        }

        return sum;
    }

    private static Reference ExpOf(BigInteger x)
    {
        int n = (int)BigInteger.Divide((2 * x) + (x.Sign * Ln2), 2 * Ln2);
        BigInteger r = x - (n * Ln2);
        BigInteger term = One;
        BigInteger sum = 0;
        for (int k = 1; !term.IsZero && term != -1; k++)
        {
            sum += term;
            term = ((term * r) >> Places) / k;
        }

        return new Reference(sum, n - Places);
    }

    private static BigInteger LogOf(double x)
    {
        Split(x, out BigInteger significand, out int power);
        BigInteger m = significand << (Places - 52);
        power += 52;
        if (m > (One * 7) / 5)
        {
            m >>= 1;
            power++;
        }

        BigInteger s = ((m - One) << Places) / (m + One);
        BigInteger square = (s * s) >> Places;
        BigInteger sum = 0;
        BigInteger term = s;
        for (int k = 1; !term.IsZero && term != -1; k += 2)
        {
            sum += term / k;
            term = (term * square) >> Places;
        }

        return (2 * sum) + (power * Ln2);
    }

    /// <summary>The angle of (x, y), any common scale, from a guess that misses it by some 1e-15: guess + arctan of the point turned back by it.</summary>
    private static BigInteger AngleOf(BigInteger y, BigInteger x, double guess)
    {
        int quarters = Reduce(guess, out BigInteger left);
        BigInteger s = (quarters & 1) == 0 ? SinSeries(left) : CosSeries(left);
        BigInteger c = (quarters & 1) == 0 ? CosSeries(left) : -SinSeries(left);
        if ((quarters & 2) != 0)
        {
            s = -s;
            c = -c;
        }

        BigInteger d = (((y * c) - (x * s)) << Places) / ((x * c) + (y * s));
        Assert(BigInteger.Abs(d) < One >> 40);
        BigInteger d3 = (((d * d) >> Places) * d) >> Places;
        BigInteger d5 = (((d3 * d) >> Places) * d) >> Places;
        BigInteger d7 = (((d5 * d) >> Places) * d) >> Places;
        return Fixed(guess) + d - (d3 / 3) + (d5 / 5) - (d7 / 7);
    }

    private static BigInteger Root(BigInteger square)
    {
        BigInteger root = BigInteger.One << (int)((square.GetBitLength() / 2) + 1);
        while (true)
        {
            BigInteger next = (root + (square / root)) >> 1;
            if (next >= root)
            {
                return root;
            }

            root = next;
        }
    }

    private static BigInteger ArctanOfInverse(int n, int places)
    {
        BigInteger term = (BigInteger.One << (places + 20)) / n;
        BigInteger sum = 0;
        for (int k = 1; !term.IsZero; k += 2)
        {
            sum += k % 4 == 1 ? term / k : -(term / k);
            term /= n * n;
        }

        return sum >> 20;
    }

    private static BigInteger ArtanhOfInverse(int n, int places)
    {
        BigInteger term = (BigInteger.One << (places + 20)) / n;
        BigInteger sum = 0;
        for (int k = 1; !term.IsZero; k += 2)
        {
            sum += term / k;
            term /= n * n;
        }

        return sum >> 20;
    }

    private static BigInteger Fixed(double x)
    {
        Split(x, out BigInteger significand, out int power);
        return power + Places >= 0 ? significand << (power + Places) : significand >> -(power + Places);
    }

    /// <summary>x = significand · 2^power with 53 bits in the significand.</summary>
    private static void Split(double x, out BigInteger significand, out int power)
    {
        long bits = BitConverter.DoubleToInt64Bits(x);
        power = (int)((bits >> 52) & 0x7FF) - 1075;
        long m = bits & 0xFFFFFFFFFFFFF;
        if (power == -1075)
        {
            power++;
        }
        else
        {
            m |= 1L << 52;
        }

        significand = bits < 0 ? -m : m;
    }

    private static void Assert(bool holds)
    {
        if (!holds)
        {
            throw new InvalidOperationException("the reference was asked for a number outside its range");
        }
    }
}
