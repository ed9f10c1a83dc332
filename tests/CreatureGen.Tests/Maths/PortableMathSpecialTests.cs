using System;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Maths;

/// <summary>Zeros, infinities, NaN, symmetry and order.</summary>
public sealed class PortableMathSpecialTests
{
    private static readonly double[] Edges =
    {
        0.0, -0.0, 1, -1, 2, -2, 3, -3, 0.5, -0.5, double.Epsilon, -double.Epsilon, 2.2250738585072014e-308, 1e-20, 1e20, 1e300, -1e300,
        double.MaxValue, double.MinValue, double.PositiveInfinity, double.NegativeInfinity, double.NaN, 9007199254740993.0, 9007199254740991.0, -9007199254740991.0, 0.1,
    };

    [Fact]
    public void Circular_functions_keep_zeros_and_refuse_infinities()
    {
        Same(0.0, PortableMath.Sin(0.0));
        Same(-0.0, PortableMath.Sin(-0.0));
        Same(1, PortableMath.Cos(-0.0));
        Same(double.Epsilon, PortableMath.Sin(double.Epsilon));
        foreach (double x in new[] { double.NaN, double.PositiveInfinity, double.NegativeInfinity })
        {
            Same(double.NaN, PortableMath.Sin(x));
            Same(double.NaN, PortableMath.Cos(x));
            PortableMath.SinCos(x, out double sine, out double cosine);
            Same(double.NaN, sine);
            Same(double.NaN, cosine);
        }

        PortableMath.SinCos(-0.0, out double zero, out double one);
        Same(-0.0, zero);
        Same(1, one);
        Same(1, PortableMath.Sin(Math.PI / 2));
        Same(-1, PortableMath.Cos(Math.PI));
        Same(1.2246467991473532e-16, PortableMath.Sin(Math.PI));
    }

    [Fact]
    public void The_angle_of_every_pair_of_edges_is_that_of_the_standard()
    {
        foreach (double y in Edges)
        {
            foreach (double x in Edges)
            {
                Like(Math.Atan2(y, x), PortableMath.Atan2(y, x), $"Atan2({y:R}, {x:R})");
            }
        }
    }

    [Fact]
    public void The_power_of_every_pair_of_edges_is_that_of_the_standard()
    {
        foreach (double x in Edges)
        {
            foreach (double y in Edges)
            {
                Like(Math.Pow(x, y), PortableMath.Pow(x, y), $"Pow({x:R}, {y:R})");
            }
        }
    }

    [Fact]
    public void Other_functions_at_the_edges_are_those_of_the_standard()
    {
        foreach (double x in Edges)
        {
            Like(Math.Exp(x), PortableMath.Exp(x), $"Exp({x:R})");
            Like(Math.Log(x), PortableMath.Log(x), $"Log({x:R})");
            Like(Math.Cbrt(x), PortableMath.Cbrt(x), $"Cbrt({x:R})");
            Like(Math.Atan(x), PortableMath.Atan(x), $"Atan({x:R})");
            Like(Math.Asin(x), PortableMath.Asin(x), $"Asin({x:R})");
            Like(Math.Acos(x), PortableMath.Acos(x), $"Acos({x:R})");
        }

        Same(0, PortableMath.Log(1));
        Same(1, PortableMath.Exp(-0.0));
        Same(double.NaN, PortableMath.Acos(1.0000000000000002));
        Same(double.NaN, PortableMath.Asin(-1.0000000000000002));
        Same(0, PortableMath.Acos(1));
        Same(Math.PI, PortableMath.Acos(-1));
    }

    [Fact]
    public void The_exponential_fades_through_the_subnormals_and_ends_where_doubles_end()
    {
        Same(double.Epsilon, PortableMath.Exp(-745.1332191019411));
        Same(0, PortableMath.Exp(-745.1332191019412));
        Assert.True(PortableMath.Exp(709.782712893384) < double.PositiveInfinity);
        Same(double.PositiveInfinity, PortableMath.Exp(709.7827128933841));
        Assert.Equal(Math.Exp(-730), PortableMath.Exp(-730), 2 * double.Epsilon);
    }

    [Fact]
    public void Odd_functions_are_odd_and_even_ones_even_bit_for_bit()
    {
        var stream = new RandomStream(7);
        for (int i = 0; i < 5000; i++)
        {
            double x = stream.Uniform(-1, 1) * Math.Pow(10, stream.Uniform(-10, 10));
            double unit = stream.Uniform(-1, 1);
            double y = stream.Uniform(-5, 5);
            Same(-PortableMath.Sin(x), PortableMath.Sin(-x));
            Same(PortableMath.Cos(x), PortableMath.Cos(-x));
            Same(-PortableMath.Atan(x), PortableMath.Atan(-x));
            Same(-PortableMath.Asin(unit), PortableMath.Asin(-unit));
            Same(-PortableMath.Cbrt(x), PortableMath.Cbrt(-x));
            Same(-PortableMath.Atan2(y, x), PortableMath.Atan2(-y, x));
            Same(PortableMath.Atan2(y, 1), PortableMath.Atan(y));
        }
    }

    [Fact]
    public void Sine_and_cosine_rise_and_fall_only_where_they_should()
    {
        double before = -1;
        for (int i = -20_000; i <= 20_000; i++)
        {
            double x = i * (Math.PI / 40_000);
            double s = PortableMath.Sin(x);
            Assert.True(s >= before, $"the sine falls at {x:R}");
            Assert.True(Math.Abs(s) <= 1);
            Assert.Equal(1, (s * s) + (PortableMath.Cos(x) * PortableMath.Cos(x)), 4e-16);
            before = s;
        }
    }

    [Fact]
    public void Exponential_and_logarithm_never_fall()
    {
        double exp = 0;
        double log = double.NegativeInfinity;
        double arc = -2;
        for (int i = 0; i <= 50_000; i++)
        {
            double x = -3 + (i * 0.00012);
            Assert.True(PortableMath.Exp(x) >= exp, $"the exponential falls at {x:R}");
            Assert.True(PortableMath.Log(x + 3) >= log, $"the logarithm falls at {x + 3:R}");
            Assert.True(PortableMath.Atan(x) >= arc, $"the arc falls at {x:R}");
            exp = PortableMath.Exp(x);
            log = PortableMath.Log(x + 3);
            arc = PortableMath.Atan(x);
        }
    }

    private static void Same(double expected, double actual)
    {
        if (double.IsNaN(expected))
        {
            Assert.True(double.IsNaN(actual), $"{actual:R}; expected NaN");
            return;
        }

        Assert.Equal(BitConverter.DoubleToInt64Bits(expected), BitConverter.DoubleToInt64Bits(actual));
    }

    /// <summary>Zeros, ones, infinities and NaN bit for bit, others within an ulp.</summary>
    private static void Like(double expected, double actual, string what)
    {
        if (double.IsNaN(expected))
        {
            Assert.True(double.IsNaN(actual), $"{what} = {actual:R}; expected NaN");
        }
        else if (!double.IsFinite(expected) || expected == 0 || Math.Abs(expected) == 1)
        {
            Assert.True(BitConverter.DoubleToInt64Bits(expected) == BitConverter.DoubleToInt64Bits(actual), $"{what} = {actual:R}; expected {expected:R}");
        }
        else
        {
            double ulp = Math.BitIncrement(Math.Abs(expected)) - Math.Abs(expected);
            Assert.True(Math.Abs(actual - expected) <= ulp, $"{what} = {actual:R}; expected {expected:R}");
        }
    }
}
