using System;
using CreatureGen.Maths;
using Xunit;

namespace CreatureGen.Tests.Maths;

public sealed class CriticallyDampedSpringTests
{
    [Fact]
    public void It_agrees_with_the_differential_equation_in_tiny_steps()
    {
        var closed = new CriticallyDampedSpring { Value = 0.3, Rate = -2 };
        double integral = closed.Step(1.5, 7, 0.4);
        double x = 0.3;
        double v = -2;
        double sum = 0;
        const int Steps = 400000;
        const double H = 0.4 / Steps;
        for (int i = 0; i < Steps; i++)
        {
            double a = (49 * (1.5 - x)) - (14 * v);
            double middle = v + (0.5 * H * a);
            double next = x + (H * middle);
            sum += 0.5 * H * (x + next);
            v += H * ((49 * (1.5 - (x + (0.5 * H * v)))) - (14 * middle));
            x = next;
        }

        Assert.Equal(x, closed.Value, 6);
        Assert.Equal(v, closed.Rate, 5);
        Assert.Equal(sum, integral, 6);
    }

    [Theory]
    [InlineData(3)]
    [InlineData(17)]
    [InlineData(100)]
    public void Cutting_the_time_differently_changes_nothing(int parts)
    {
        var whole = new CriticallyDampedSpring { Value = -1, Rate = 4 };
        double once = whole.Step(2, 5, 0.25);
        var cut = new CriticallyDampedSpring { Value = -1, Rate = 4 };
        double sum = 0;
        for (int i = 0; i < parts; i++)
        {
            sum += cut.Step(2, 5, 0.25 / parts);
        }

        Assert.Equal(whole.Value, cut.Value, 12);
        Assert.Equal(whole.Rate, cut.Rate, 11);
        Assert.Equal(once, sum, 12);
    }

    [Fact]
    public void It_never_overshoots_from_rest()
    {
        var s = CriticallyDampedSpring.At(0);
        for (int i = 0; i < 500; i++)
        {
            s.Step(1, 9, 0.01);
            Assert.InRange(s.Value, 0, 1);
        }

        Assert.True(Math.Abs(s.Value - 1) < 1e-9);
    }

    [Fact]
    public void No_time_changes_nothing()
    {
        var s = new CriticallyDampedSpring { Value = 0.7, Rate = 3 };
        Assert.Equal(0, s.Step(5, 4, 0));
        Assert.Equal(0.7, s.Value);
        Assert.Equal(3, s.Rate);
    }
}
