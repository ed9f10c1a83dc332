using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class QuadricTests
{
    [Fact]
    public void A_sum_of_planes_gives_the_sum_of_squared_distances()
    {
        var random = new Random(7);
        Vector3 Draw() => new((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f);
        for (int round = 0; round < 50; round++)
        {
            (Vector3 Normal, float Distance, float Weight)[] planes = Enumerable.Range(0, 6).Select(_ => (Vector3.Normalize(Draw()), Draw().X, (float)random.NextDouble())).ToArray();
            Quadric sum = planes.Aggregate(default(Quadric), (q, p) => q + Quadric.OfPlane(p.Normal, p.Distance, p.Weight));
            Vector3 way = Draw();
            double expected = planes.Sum(p => p.Weight * Math.Pow(p.Distance + Vector3.Dot(p.Normal, way), 2));
            Assert.Equal(expected, sum.At(way), 1e-5);
            Assert.Equal(planes.Sum(p => p.Weight), sum.Weight, 1e-5);
        }
    }

    [Fact]
    public void About_another_point_it_has_the_same_value_everywhere()
    {
        var random = new Random(8);
        Vector3 Draw() => new((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f);
        for (int round = 0; round < 50; round++)
        {
            Quadric here = Quadric.OfPlane(Vector3.Normalize(Draw()), Draw().X, 3f) + Quadric.OfPlane(Vector3.Normalize(Draw()), Draw().X, 2f);
            Vector3 there = Draw(), way = Draw();
            Assert.Equal(here.At(there + way), here.About(there).At(way), 1e-5);
        }
    }

    [Fact]
    public void A_point_of_the_plane_costs_nothing_and_never_less()
    {
        Quadric plane = Quadric.OfPlane(Vector3.UnitY, 1f, 5f);
        Assert.Equal(0f, plane.At(new Vector3(-7, -1, 9)));
        Assert.Equal(20f, plane.At(new Vector3(0, 1, 0)));
    }
}
