using System;
using System.Globalization;
using System.Numerics;
using System.Text;
using CreatureGen.Json;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Json;

public sealed class NumberTextTests
{
    // RFC 8785, appendix B.
    [Theory]
    [InlineData(0x0000000000000000, "0")]
    [InlineData(0x8000000000000000, "0")]
    [InlineData(0x0000000000000001, "5e-324")]
    [InlineData(0x8000000000000001, "-5e-324")]
    [InlineData(0x7fefffffffffffff, "1.7976931348623157e+308")]
    [InlineData(0xffefffffffffffff, "-1.7976931348623157e+308")]
    [InlineData(0x4340000000000000, "9007199254740992")]
    [InlineData(0xc340000000000000, "-9007199254740992")]
    [InlineData(0x4430000000000000, "295147905179352830000")]
    [InlineData(0x44b52d02c7e14af5, "9.999999999999997e+22")]
    [InlineData(0x44b52d02c7e14af6, "1e+23")]
    [InlineData(0x44b52d02c7e14af7, "1.0000000000000001e+23")]
    [InlineData(0x444b1ae4d6e2ef4e, "999999999999999700000")]
    [InlineData(0x444b1ae4d6e2ef4f, "999999999999999900000")]
    [InlineData(0x444b1ae4d6e2ef50, "1e+21")]
    [InlineData(0x3eb0c6f7a0b5ed8c, "9.999999999999997e-7")]
    [InlineData(0x3eb0c6f7a0b5ed8d, "0.000001")]
    [InlineData(0x41b3de4355555553, "333333333.3333332")]
    [InlineData(0x41b3de4355555554, "333333333.33333325")]
    [InlineData(0x41b3de4355555555, "333333333.3333333")]
    [InlineData(0x41b3de4355555556, "333333333.3333334")]
    [InlineData(0x41b3de4355555557, "333333333.33333343")]
    [InlineData(0xbecbf647612f3696, "-0.0000033333333333333333")]
    [InlineData(0x43143ff3c1cb0959, "1424953923781206.2")]
    public void Doubles_are_written_as_RFC_8785_says(ulong bits, string expected) =>
        Assert.Equal(expected, NumberText.Of(BitConverter.UInt64BitsToDouble(bits)));

    [Theory]
    [InlineData(0f, "0")]
    [InlineData(0.1f, "0.1")]
    [InlineData(1f / 3f, "0.33333334")]
    [InlineData(16777216f, "16777216")]
    [InlineData(float.MaxValue, "3.4028235e+38")]
    [InlineData(float.Epsilon, "1e-45")]
    [InlineData(1.17549435e-38f, "1.1754944e-38")]
    [InlineData(-2.5e-7f, "-2.5e-7")]
    public void Numbers_of_single_precision_are_written_short(float value, string expected) => Assert.Equal(expected, Text(value));

    [Fact]
    public void Negative_zero_is_zero()
    {
        Assert.Equal("0", NumberText.Of(-0.0));
        Assert.Equal("0", Text(-0f));
    }

    [Theory]
    [InlineData(0L, "0")]
    [InlineData(-1L, "-1")]
    [InlineData(long.MaxValue, "9223372036854775807")]
    [InlineData(long.MinValue, "-9223372036854775808")]
    public void Whole_numbers_are_written_whole(long value, string expected)
    {
        Span<byte> text = stackalloc byte[NumberText.MaximumLength];
        Assert.Equal(expected, Encoding.ASCII.GetString(text[..NumberText.Write(value, text)]));
    }

    [Theory]
    [InlineData(double.NaN, "NaN")]
    [InlineData(double.PositiveInfinity, "Infinity")]
    [InlineData(double.NegativeInfinity, "-Infinity")]
    public void What_is_not_finite_is_refused_by_name(double value, string name)
    {
        var refused = Assert.Throws<ArgumentException>(() => NumberText.Write(value, new byte[NumberText.MaximumLength]));
        Assert.StartsWith("the number is " + name + "; expected a finite number", refused.Message, StringComparison.Ordinal);
        refused = Assert.Throws<ArgumentException>(() => NumberText.Write((float)value, new byte[NumberText.MaximumLength]));
        Assert.StartsWith("the number is " + name + "; expected a finite number", refused.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(100_000)]
    [InlineData(1_000_000, Explicit = true)]
    public void Many_doubles_have_the_digits_of_the_framework_and_read_back(int samples)
    {
        RandomStream random = new Seed(1).Child("doubles").Stream();
        for (int i = 0; i < samples; i++)
        {
            // All bit patterns, numbers of everyday size, and numbers with few digits.
            double value = (i % 4) switch
            {
                0 => BitConverter.UInt64BitsToDouble(random.NextUInt64()),
                1 => random.Uniform(-4, 4),
                2 => random.Integer(-2_000_000, 2_000_000) / 1000.0,
                _ => (double)random.NextUInt64(),
            };
            if (!double.IsFinite(value) || IsPowerOfTwo(value))
            {
                continue;
            }

            string text = NumberText.Of(value);
            Assert.Equal(Digits(value.ToString("R", CultureInfo.InvariantCulture)), Digits(text));
            Assert.Equal(value, double.Parse(text, CultureInfo.InvariantCulture));
            Assert.Equal(value, NumberParser.Parse(Encoding.ASCII.GetBytes(text)));
        }
    }

    [Theory]
    [InlineData(100_000)]
    [InlineData(1_000_000, Explicit = true)]
    public void Many_numbers_of_single_precision_have_the_digits_of_the_framework_and_read_back(int samples)
    {
        RandomStream random = new Seed(1).Child("floats").Stream();
        for (int i = 0; i < samples; i++)
        {
            float value = i % 2 == 0 ? BitConverter.UInt32BitsToSingle((uint)random.NextUInt64()) : (float)random.Uniform(-4, 4);
            if (!float.IsFinite(value) || IsPowerOfTwo(value))
            {
                continue;
            }

            string text = Text(value);
            Assert.Equal(Digits(value.ToString("R", CultureInfo.InvariantCulture)), Digits(text));
            Assert.Equal(value, float.Parse(text, CultureInfo.InvariantCulture));
        }
    }

    // The framework's own text of 2^-958 does not read back, so powers of two have a reference of their own.
    [Fact]
    public void Every_power_of_two_is_as_short_and_as_near_as_an_exhaustive_search_finds()
    {
        for (int exponent = -1074; exponent < 1024; exponent++)
        {
            double value = Math.ScaleB(1, exponent);
            Assert.Equal(ShortestBySearch(value, text => double.Parse(text, CultureInfo.InvariantCulture) == value), Digits(NumberText.Of(value)));
        }

        for (int exponent = -149; exponent < 128; exponent++)
        {
            float value = MathF.ScaleB(1, exponent);
            Assert.Equal(ShortestBySearch(value, text => float.Parse(text, CultureInfo.InvariantCulture) == value), Digits(Text(value)));
        }
    }

    [Fact]
    public void Random_doubles_are_as_short_and_as_near_as_an_exhaustive_search_finds()
    {
        RandomStream random = new Seed(2).Stream();
        for (int i = 0; i < 2000; i++)
        {
            double value = Math.Abs(BitConverter.UInt64BitsToDouble(random.NextUInt64()));
            if (double.IsFinite(value))
            {
                Assert.Equal(ShortestBySearch(value, text => double.Parse(text, CultureInfo.InvariantCulture) == value), Digits(NumberText.Of(value)));
            }
        }
    }

    /// <summary>Tries the two decimals around the number with 1, 2, 3 … digits until one reads back; of two, takes the nearer.</summary>
    private static string ShortestBySearch(double value, Func<string, bool> readsBack)
    {
        long bits = BitConverter.DoubleToInt64Bits(value);
        int biased = (int)(bits >> 52);
        BigInteger numerator = (bits & 0xFFFFFFFFFFFFF) | (biased > 0 ? 1L << 52 : 0);
        BigInteger denominator = 1;
        int power = Math.Max(biased, 1) - 1075;
        numerator <<= Math.Max(power, 0);
        denominator <<= Math.Max(-power, 0);
        int magnitude = (int)Math.Floor(Math.Log10(value));
        for (int digits = 1; ; digits++)
        {
            // The number in units of the last digit.
            int unit = magnitude - digits + 1;
            BigInteger scaled = numerator * BigInteger.Pow(10, Math.Max(-unit, 0));
            BigInteger scale = denominator * BigInteger.Pow(10, Math.Max(unit, 0));
            BigInteger below = BigInteger.DivRem(scaled, scale, out BigInteger rest);
            bool belowFits = readsBack(below + "e" + unit);
            bool aboveFits = readsBack((below + 1) + "e" + unit);
            if (belowFits || aboveFits)
            {
                bool above = aboveFits && (!belowFits || rest * 2 > scale || (rest * 2 == scale && !below.IsEven));
                return Digits((above ? below + 1 : below).ToString(CultureInfo.InvariantCulture));
            }
        }
    }

    private static bool IsPowerOfTwo(double value) => (BitConverter.DoubleToInt64Bits(value) & 0xFFFFFFFFFFFFF) == 0;

    private static string Text(float value)
    {
        Span<byte> text = stackalloc byte[NumberText.MaximumLength];
        return Encoding.ASCII.GetString(text[..NumberText.Write(value, text)]);
    }

    private static string Digits(string number)
    {
        int exponent = number.IndexOfAny(['e', 'E']);
        string mantissa = (exponent < 0 ? number : number[..exponent]).Replace(".", "", StringComparison.Ordinal).Replace("-", "", StringComparison.Ordinal);
        return mantissa.TrimStart('0').TrimEnd('0');
    }
}
