using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Bodies;

public sealed class RingCurveTests
{
    [Fact]
    public void Curves_through_stations_have_the_bits_of_the_monotone_cubic()
    {
        double[] knots = Array.ConvertAll(BodyGrid.StationRings.ToArray(), ring => (double)ring);
        RandomStream random = new Seed(11).Stream();
        for (int round = 0; round < 50; round++)
        {
            double[] stations = knots.Select(_ => random.Uniform(-2, 3)).ToArray();
            double[] slopes = new double[knots.Length];
            double[] rings = new double[BodyGrid.Rings];
            MonotoneCubic.Slopes(knots, stations, slopes);
            RingCurve.Through(stations, rings);
            for (int i = 0; i < rings.Length; i++)
            {
                int interval = Math.Min(Array.FindLastIndex(knots, knot => knot <= i), knots.Length - 2);
                Assert.Equal(MonotoneCubic.Evaluate(knots, stations, slopes, interval, i), rings[i]);
            }
        }
    }
}
