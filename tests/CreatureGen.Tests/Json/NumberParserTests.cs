using System;
using System.Globalization;
using System.Numerics;
using System.Text;
using CreatureGen.Json;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Json;

public sealed class NumberParserTests
{
    [Theory]
    [InlineData("0", 0x0000000000000000)]
    [InlineData("-0.000e5", 0x8000000000000000)]
    [InlineData("0e999999999999999999999", 0x0000000000000000)]
    [InlineData("1", 0x3ff0000000000000)]
    [InlineData("0.1", 0x3fb999999999999a)]
    [InlineData("9007199254740993", 0x4340000000000000)]
    [InlineData("9007199254740993.00000000000000000000000000000001", 0x4340000000000001)]
    [InlineData("9007199254740995", 0x4340000000000002)]
    [InlineData("1e23", 0x44b52d02c7e14af6)]
    [InlineData("8.41e21", 0x447c7e83209e90b2)]
    [InlineData("2.2250738585072011e-308", 0x000fffffffffffff)]
    [InlineData("2.2250738585072012e-308", 0x0010000000000000)]
    [InlineData("2.4703282292062327208e-324", 0x0000000000000000)]
    [InlineData("2.4703282292062328e-324", 0x0000000000000001)]
    [InlineData("4.9406564584124654e-324", 0x0000000000000001)]
    [InlineData("1e-400", 0x0000000000000000)]
    [InlineData("1e-99999999999999999999", 0x0000000000000000)]
    [InlineData("1.7976931348623157e308", 0x7fefffffffffffff)]
    [InlineData("1.7976931348623158e308", 0x7fefffffffffffff)]
    [InlineData("1.7976931348623159e308", 0x7ff0000000000000)]
    [InlineData("1e309", 0x7ff0000000000000)]
    [InlineData("-1e999999999999999999999", 0xfff0000000000000)]
    public void Text_is_read_as_the_nearest_double(string text, ulong bits) => Assert.Equal(bits, Parse(text));

    [Fact]
    public void A_digit_far_behind_a_tie_breaks_it()
    {
        // 1 + 2^-53 lies half way between 1 and the next double; its decimal text has 53 digits behind the point.
        string tie = "1.00000000000000011102230246251565404236316680908203125";
        Assert.Equal(0x3ff0000000000000UL, Parse(tie));
        Assert.Equal(0x3ff0000000000001UL, Parse(tie + new string('0', 5000) + "1"));
        Assert.Equal(0x3ff0000000000000UL, Parse(tie + new string('0', 5000)));
        Assert.Equal(0x3ff0000000000000UL, Parse(tie[..^1] + "4" + new string('9', 5000)));
    }

    [Fact]
    public void Zeros_without_end_neither_hang_nor_lose_the_exponent()
    {
        string zeros = new('0', 1_000_000);
        Assert.Equal(0x3ff0000000000000UL, Parse("1" + zeros + "e-1000000"));
        Assert.Equal(0x3ff0000000000000UL, Parse("0." + zeros + "1e1000001"));
        Assert.Equal(0x7ff0000000000000UL, Parse("1" + zeros));
        Assert.Equal(0UL, Parse("0." + zeros + "1"));
    }

    [Fact]
    public void Random_text_is_read_as_the_framework_reads_it()
    {
        RandomStream random = new Seed(3).Child("texts").Stream();
        for (int i = 0; i < Thoroughness.Of(200_000); i++)
        {
            var text = new StringBuilder(random.Chance(0.5) ? "-" : "");
            text.Append((char)('1' + random.Integer(0, 9)));
            AppendDigits(text, random.Integer(0, 25), random);
            text.Append('.');
            AppendDigits(text, random.Integer(1, 25), random);
            if (random.Chance(0.7))
            {
                text.Append('e').Append(random.Chance(0.5) ? random.Integer(-345, 330) : random.Integer(-30, 30));
            }

            ulong expected = BitConverter.DoubleToUInt64Bits(double.Parse(text.ToString(), CultureInfo.InvariantCulture));
            Assert.True(expected == Parse(text.ToString()), text.ToString());
        }
    }

    [Fact]
    public void The_middle_between_two_doubles_goes_to_the_even_one()
    {
        RandomStream random = new Seed(3).Child("ties").Stream();
        for (int i = 0; i < 20_000; i++)
        {
            // (2m + 1)·2^e lies half way between m·2^(e+1) and the next double.
            ulong mantissa = (1UL << 52) | (random.NextUInt64() >> 12);
            int exponent = random.Integer(-40, 200);
            BigInteger middle = ((BigInteger)mantissa * 2) + 1;
            string text = exponent >= 0
                ? (middle << exponent).ToString(CultureInfo.InvariantCulture)
                : (middle * BigInteger.Pow(5, -exponent)).ToString(CultureInfo.InvariantCulture) + "e" + exponent;
            double even = Math.ScaleB((mantissa & 1) == 0 ? mantissa : mantissa + 1, exponent + 1);
            Assert.Equal(BitConverter.DoubleToUInt64Bits(even), Parse(text));
        }
    }

    private static void AppendDigits(StringBuilder text, int count, RandomStream random)
    {
        for (int i = 0; i < count; i++)
        {
            text.Append((char)('0' + random.Integer(0, 10)));
        }
    }

    private static ulong Parse(string text) => BitConverter.DoubleToUInt64Bits(NumberParser.Parse(Encoding.ASCII.GetBytes(text)));
}
