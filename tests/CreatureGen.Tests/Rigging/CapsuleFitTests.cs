using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Rigging;

public sealed class CapsuleFitTests
{
    [Fact]
    public void A_cylinder_gets_its_own_axis_and_radius()
    {
        CapsuleFit fit = Fit(Cylinder(0.1f, 1f), new Vector3(0.3f, 5f, 0f), Vector3.UnitY);
        Assert.Equal(0.1f, fit.Radius, 1e-5f);
        Assert.True(Vec.Distance(fit.Start, new Vector3(0.2f, 0.1f, 0.4f)) < 0.04f, $"{fit.Start}");
        Assert.True(Vec.Distance(fit.End, new Vector3(0.2f, 0.9f, 0.4f)) < 0.04f, $"{fit.End}");
    }

    [Fact]
    public void A_few_far_points_do_not_blow_it_up()
    {
        List<Vector3> points = Cylinder(0.1f, 1f);
        float before = Fit(points, Vector3.Zero, Vector3.UnitY).Radius;
        for (int i = 0; i < points.Count / 40; i++)
        {
            points.Add(new Vector3(0.2f, 0.5f, 0.4f + (0.6f * (i % 2 == 0 ? 1f : -1f))));
        }

        Assert.Equal(before, Fit(points, Vector3.Zero, Vector3.UnitY).Radius, 0.005f);
    }

    [Fact]
    public void A_ball_becomes_a_ball()
    {
        List<Vector3> points = Cylinder(0.5f, 0.4f);
        CapsuleFit fit = Fit(points, Vector3.Zero, Vector3.UnitY);
        Assert.Equal(fit.Start, fit.End);
    }

    [Fact]
    public void Percentiles_agree_with_sorting()
    {
        var random = new CreatureGen.Seeding.Seed(5).Stream();
        for (int n = 1; n < 60; n++)
        {
            float[] values = new float[n];
            for (int i = 0; i < n; i++)
            {
                values[i] = random.Integer(0, 20) / 4f;
            }

            float[] sorted = (float[])values.Clone();
            Array.Sort(sorted);
            foreach (double fraction in new[] { 0, 0.03, 0.25, 0.5, 0.7, 0.97, 1 })
            {
                Assert.Equal(sorted[(int)((fraction * (n - 1)) + 0.5)], Selection.Percentile((float[])values.Clone(), fraction));
            }
        }
    }

    private static CapsuleFit Fit(List<Vector3> points, Vector3 origin, Vector3 direction) =>
        CapsuleFit.Around(points.ToArray(), origin, direction, median: false, new float[2 * points.Count]);

    private static List<Vector3> Cylinder(float radius, float length)
    {
        var points = new List<Vector3>();
        for (int i = 0; i <= 40; i++)
        {
            for (int k = 0; k < 16; k++)
            {
                double a = PortableMath.Tau * k / 16;
                points.Add(new Vector3(0.2f + (radius * (float)PortableMath.Cos(a)), length * i / 40, 0.4f + (radius * (float)PortableMath.Sin(a))));
            }
        }

        return points;
    }
}
