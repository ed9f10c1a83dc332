using System;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Maths;

public sealed class MonotoneCubicTests
{
    private readonly RandomStream stream = new(31);

    [Fact]
    public void Knots_are_reproduced_bit_for_bit()
    {
        for (int trial = 0; trial < 300; trial++)
        {
            Curve curve = Random(stream.Integer(2, 12));
            for (int i = 0; i < curve.Knots.Length; i++)
            {
                Assert.Equal(curve.Values[i], curve.At(curve.Knots[i]));
                if (i > 0)
                {
                    Assert.Equal(curve.Values[i], MonotoneCubic.Evaluate(curve.Knots, curve.Values, curve.Slopes, i - 1, curve.Knots[i]), 1e-15);
                }
            }
        }
    }

    [Fact]
    public void Between_two_knots_the_curve_stays_between_their_values()
    {
        for (int trial = 0; trial < 500; trial++)
        {
            Curve curve = Random(stream.Integer(2, 12));
            for (int i = 1; i < curve.Knots.Length; i++)
            {
                double low = Math.Min(curve.Values[i - 1], curve.Values[i]);
                double high = Math.Max(curve.Values[i - 1], curve.Values[i]);
                for (int k = 0; k <= 40; k++)
                {
                    double y = curve.At(Scalar.Lerp(curve.Knots[i - 1], curve.Knots[i], k / 40.0));
                    Assert.InRange(y, low - 1e-13, high + 1e-13);
                }
            }
        }
    }

    [Fact]
    public void Monotone_data_stay_monotone()
    {
        for (int trial = 0; trial < 500; trial++)
        {
            Curve curve = Random(stream.Integer(2, 12));
            Array.Sort(curve.Values);
            curve.Fit();
            double before = double.NegativeInfinity;
            for (int k = 0; k <= 500; k++)
            {
                double y = curve.At(Scalar.Lerp(curve.Knots[0], curve.Knots[^1], k / 500.0));
                Assert.True(y >= before - 1e-13, $"trial {trial}: {y:R} after {before:R}");
                before = y;
            }
        }
    }

    [Fact]
    public void Data_on_a_line_give_the_line()
    {
        for (int trial = 0; trial < 300; trial++)
        {
            double slope = stream.Uniform(-3, 3);
            double offset = stream.Uniform(-3, 3);
            Curve curve = Random(stream.Integer(2, 12));
            for (int i = 0; i < curve.Knots.Length; i++)
            {
                curve.Values[i] = offset + (slope * curve.Knots[i]);
            }

            curve.Fit();
            for (int k = 0; k <= 60; k++)
            {
                double x = Scalar.Lerp(curve.Knots[0], curve.Knots[^1], k / 60.0);
                Assert.Equal(offset + (slope * x), curve.At(x), 1e-12);
            }
        }
    }

    [Fact]
    public void A_peak_and_a_plateau_have_flat_knots()
    {
        var curve = new Curve([0, 1, 2, 3, 4], [0, 1, 0, 0, 2]);
        Assert.Equal(0, curve.Slopes[1]);
        Assert.Equal(0, curve.Slopes[2]);
        Assert.Equal(0, curve.Slopes[3]);
        Assert.Equal(0, curve.At(2.5));
    }

    [Fact]
    public void An_inner_slope_is_the_weighted_harmonic_mean_of_its_neighbours()
    {
        // Steps 1 and 2, secants 2 and 0.5: weights 2·2 + 1 = 5 and 2 + 2·1 = 4; (5 + 4) / (5/2 + 4/0.5) = 9 / 10.5.
        var curve = new Curve([0, 1, 3], [0, 2, 3]);
        Assert.Equal(9 / 10.5, curve.Slopes[1], 1e-15);
    }

    [Fact]
    public void Beyond_its_ends_the_curve_keeps_the_end_values()
    {
        var curve = new Curve([-1, 0, 2], [5, 6, 9]);
        Assert.Equal(5, curve.At(-100));
        Assert.Equal(9, curve.At(100));
    }

    [Fact]
    public void Turning_the_data_upside_down_or_round_turns_the_curve()
    {
        for (int trial = 0; trial < 100; trial++)
        {
            Curve curve = Random(stream.Integer(2, 9));
            int n = curve.Knots.Length;
            var down = new Curve(curve.Knots, Array.ConvertAll(curve.Values, v => -v));
            var back = new Curve(new double[n], new double[n], fit: false);
            for (int i = 0; i < n; i++)
            {
                back.Knots[i] = -curve.Knots[n - 1 - i];
                back.Values[i] = curve.Values[n - 1 - i];
            }

            back.Fit();
            for (int k = 0; k <= 30; k++)
            {
                double x = Scalar.Lerp(curve.Knots[0], curve.Knots[^1], k / 30.0);
                Assert.Equal(-curve.At(x), down.At(x));
                Assert.Equal(curve.At(x), back.At(-x), 1e-12);
            }
        }
    }

    [Fact]
    public void Bad_knots_are_refused_with_their_place()
    {
        Assert.Contains("knots[2]", Assert.Throws<ArgumentException>(() => new Curve([0, 1, 1], [0, 1, 2])).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => new Curve([0, 1, double.NaN], [0, 1, 2]));
        Assert.Throws<ArgumentException>(() => new Curve([0], [0]));
        Assert.Throws<ArgumentException>(() => new Curve([0, 1, 2], [0, 1]));
    }

    private Curve Random(int count)
    {
        var curve = new Curve(new double[count], new double[count], fit: false);
        double x = stream.Uniform(-2, 2);
        for (int i = 0; i < count; i++)
        {
            curve.Knots[i] = x;
            curve.Values[i] = stream.Chance(0.2) && i > 0 ? curve.Values[i - 1] : stream.Uniform(-1, 1);
            x += stream.Uniform(0.01, 2);
        }

        curve.Fit();
        return curve;
    }

    private sealed class Curve
    {
        public Curve(double[] knots, double[] values, bool fit = true)
        {
            Knots = knots;
            Values = values;
            Slopes = new double[knots.Length];
            if (fit)
            {
                Fit();
            }
        }

        public double[] Knots { get; }

        public double[] Values { get; }

        public double[] Slopes { get; }

        public void Fit() => MonotoneCubic.Slopes(Knots, Values, Slopes);

        public double At(double x) => MonotoneCubic.Evaluate(Knots, Values, Slopes, x);
    }
}
