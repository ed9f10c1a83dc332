using System;
using System.Linq;
using CreatureGen.Maths;
using Xunit;

namespace CreatureGen.Tests.Maths;

public sealed class BernsteinTests
{
    [Fact]
    public void The_weights_add_up_to_one_and_none_is_negative()
    {
        for (int degree = 0; degree <= 20; degree++)
        {
            for (int i = 0; i <= 100; i++)
            {
                double[] basis = At(degree, i / 100.0);
                Assert.Equal(1, basis.Sum(), 1e-15 * (degree + 1));
                Assert.All(basis, weight => Assert.True(weight >= 0));
            }
        }
    }

    [Fact]
    public void They_are_binomials_times_powers()
    {
        for (int degree = 0; degree <= 12; degree++)
        {
            double binomial = 1;
            for (int k = 0; k <= degree; k++)
            {
                foreach (double t in new[] { 0.03, 0.25, 0.5, 0.8, 0.999, -0.3, 1.4 })
                {
                    double expected = binomial * Math.Pow(t, k) * Math.Pow(1 - t, degree - k);
                    Assert.Equal(expected, At(degree, t)[k], 1e-13 * Math.Max(1, Math.Pow(3, degree)));
                }

                binomial = binomial * (degree - k) / (k + 1);
            }
        }
    }

    [Fact]
    public void At_the_ends_only_the_end_weighs()
    {
        double[] first = At(10, 0);
        double[] last = At(10, 1);
        for (int k = 0; k <= 10; k++)
        {
            Assert.Equal(k == 0 ? 1 : 0, first[k]);
            Assert.Equal(k == 10 ? 1 : 0, last[k]);
        }
    }

    [Fact]
    public void Evenly_spaced_control_points_give_the_parameter_back()
    {
        for (int i = -20; i <= 120; i++)
        {
            double t = i / 100.0;
            double[] basis = At(10, t);
            Assert.Equal(t, basis.Select((weight, k) => weight * k / 10).Sum(), 1e-13);
        }
    }

    [Fact]
    public void The_weights_at_t_are_those_at_one_minus_t_backwards()
    {
        for (int i = 0; i <= 64; i++)
        {
            // 1 − t is exact for sixty-fourths, so the symmetry is too, up to the order of two factors.
            double[] here = At(10, i / 64.0);
            double[] there = At(10, 1 - (i / 64.0));
            for (int k = 0; k <= 10; k++)
            {
                Assert.Equal(here[k], there[10 - k]);
            }
        }
    }

    [Fact]
    public void A_basis_without_room_is_refused() =>
        Assert.Throws<ArgumentException>(() => Bernstein.Evaluate(0.5, []));

    private static double[] At(int degree, double t)
    {
        var basis = new double[degree + 1];
        Bernstein.Evaluate(t, basis);
        return basis;
    }
}
