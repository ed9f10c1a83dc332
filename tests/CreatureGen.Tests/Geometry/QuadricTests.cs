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
            (Vector3 Normal, Vector3 Point, double Weight)[] planes = Enumerable.Range(0, 6).Select(_ => (Vector3.Normalize(Draw()), Draw(), random.NextDouble())).ToArray();
            Quadric sum = planes.Aggregate(default(Quadric), (q, p) => q + Quadric.OfPlane(p.Normal, p.Point, p.Weight));
            Vector3 at = Draw();
            double expected = planes.Sum(p =>
            {
                Vector3 d = at - p.Point;
                double distance = ((double)p.Normal.X * d.X) + ((double)p.Normal.Y * d.Y) + ((double)p.Normal.Z * d.Z);
                return p.Weight * distance * distance;
            });
            Assert.Equal(expected, sum.At(at), 1e-6);
        }
    }

    [Fact]
    public void A_point_of_the_plane_costs_nothing_and_never_less()
    {
        Quadric plane = Quadric.OfPlane(Vector3.UnitY, new Vector3(3, 2, 1), 5);
        Assert.Equal(0, plane.At(new Vector3(-7, 2, 9)));
        Assert.Equal(20, plane.At(new Vector3(0, 4, 0)));
    }
}
