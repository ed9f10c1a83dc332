using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Bodies;
using Xunit;

namespace CreatureGen.Tests.Bodies;

public sealed class TailRaysTests
{
    private const double Edge = BodyGrid.Rings - 1;
    private const double OnRay = 0;
    private const double BetweenRays = Math.PI / 16;
    private const double Size = 0.24;
    private const double Step = 0.033;

    /// <summary>Least depth of the scallops of a fan in its half height: shallower ones are not seen on a sheet of creatures.</summary>
    private const double Deep = 0.06;

    [Fact]
    public void The_edge_of_a_fan_is_drawn_in_between_its_rays_and_that_of_a_sharks_tail_less()
    {
        double fan = TailRays.DrawnInAt(TailStyle.Fan, Edge, BetweenRays, Size, Step);
        Assert.True(fan > Deep * Size);
        Assert.Equal(0, TailRays.DrawnInAt(TailStyle.Fan, Edge, OnRay, Size, Step), 12);
        Assert.InRange(TailRays.DrawnInAt(TailStyle.Heterocercal, Edge, BetweenRays, Size, Step), 0.2 * fan, 0.8 * fan);
    }

    [Fact]
    public void Rays_stand_out_where_a_fin_is_broad_and_thin_alone()
    {
        Assert.Equal(1, TailRays.ThicknessAt(Edge, OnRay, slimness: 1), 12);
        Assert.Equal(1, TailRays.ThicknessAt(Edge, BetweenRays, slimness: 1), 12);
        Assert.True(TailRays.ThicknessAt(Edge, OnRay, slimness: 30) > 1.2);
        Assert.True(TailRays.ThicknessAt(Edge, BetweenRays, slimness: 30) < 0.8);
    }
}
