using System;
using System.Linq;
using CreatureGen.Lattices;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Lattices;

public sealed class RingLatticeTests
{
    private const int Slices = 11;

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(7)]
    [InlineData(55)]
    public void Rings_have_the_bits_of_each_ring_alone(int rings)
    {
        RandomStream random = new Seed(5).Stream();
        double[] widths = Draw();
        double[] heights = Draw();
        double[] lengths = Draw();
        double[] positions = new double[Slices];
        SliceScaling.Positions(lengths, positions);
        double[] t = Enumerable.Range(0, rings).Select(i => i == 0 ? 0 : i == rings - 1 ? 1 : random.Uniform()).ToArray();
        double[] width = new double[rings];
        double[] height = new double[rings];
        double[] place = new double[rings];
        RingLattice.Evaluate(widths, heights, lengths, t, width, height, place);
        double[] weights = new double[Slices];
        for (int i = 0; i < rings; i++)
        {
            Bernstein.Evaluate(t[i], weights);
            Assert.Equal(Sum(weights, widths), width[i]);
            Assert.Equal(Sum(weights, heights), height[i]);
            Assert.Equal(Sum(weights, positions), place[i]);
        }

        double[] Draw() => Enumerable.Range(0, Slices).Select(_ => random.Uniform(0.5, 2)).ToArray();
    }

    private static double Sum(double[] weights, double[] values)
    {
        double sum = 0;
        for (int k = 0; k < weights.Length; k++)
        {
            sum += weights[k] * values[k];
        }

        return sum;
    }
}
