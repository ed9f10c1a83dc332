using System;
using System.Numerics;
using CreatureGen.Maths;
using Xunit;

namespace CreatureGen.Tests.Maths;

public sealed class SegmentDistanceTests
{
    [Fact]
    public void Known_distances_are_met()
    {
        var x = Vector3.UnitX;
        Assert.Equal(4f, SegmentDistance.Squared(-x, x, new Vector3(0f, 2f, -1f), new Vector3(0f, 2f, 1f)));
        Assert.Equal(9f, SegmentDistance.Squared(-x, x, x * 4f, x * 7f));
        Assert.Equal(1f, SegmentDistance.Squared(-x, x, new Vector3(-3f, 1f, 0f), new Vector3(3f, 1f, 0f)), 1e-6f);
    }

    [Fact]
    public void Segments_may_be_points()
    {
        var p = new Vector3(1f, 2f, 3f);
        Assert.Equal(14f, SegmentDistance.Squared(p, p, Vector3.Zero, Vector3.Zero));
        Assert.Equal(13f, SegmentDistance.Squared(p, p, Vector3.Zero, new Vector3(5f, 0f, 0f)));
        Assert.Equal(13f, SegmentDistance.Squared(Vector3.Zero, new Vector3(5f, 0f, 0f), p, p));
    }

    [Fact]
    public void No_two_points_of_the_segments_are_nearer_and_some_are_as_near()
    {
        var random = new Random(5);
        Vector3 Any() => new((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f);
        for (int round = 0; round < 200; round++)
        {
            (Vector3 a, Vector3 b, Vector3 c, Vector3 d) = (Any(), Any(), Any(), Any());
            float min = float.MaxValue;
            for (int i = 0; i <= 60; i++)
            {
                for (int k = 0; k <= 60; k++)
                {
                    min = Math.Min(min, (a + ((b - a) * (i / 60f)) - c - ((d - c) * (k / 60f))).Length());
                }
            }

            float distance = MathF.Sqrt(SegmentDistance.Squared(a, b, c, d));
            Assert.InRange(distance, min - 0.03f, min + 1e-5f);
            Assert.Equal(distance, MathF.Sqrt(SegmentDistance.Squared(d, c, b, a)), 1e-4f);
        }
    }
}
