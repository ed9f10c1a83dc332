using System.Linq;
using System.Numerics;
using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Features;
using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Features;

public sealed class InsectWingShapeTests
{
    private static readonly SurfacePoint back = new(new Vector3(0.05f, 0.5f, 0.1f), Vector3.Normalize(new Vector3(0.4f, 0.9f, 0f)));
    private static readonly Vector3 membrane = new(0.6f, 0.7f, 0.8f);
    private static readonly Vector3 vein = new(0.1f, 0.05f, 0.02f);

    [Fact]
    public void A_wing_is_a_closed_leaf_at_every_breadth_and_direction()
    {
        foreach (double aspect in new[] { 0.08, 0.14, 0.2, 0.3, 0.45, 0.7 })
        {
            foreach (double azimuth in new[] { -1.4, -0.6, 0.0, 0.5 })
            {
                foreach (double elevation in new[] { -0.3, 0.2, 0.9 })
                {
                    Piece wing = Build(new InsectWingBlueprint(26, 2.5, 0.8, 0.8 * aspect, azimuth, elevation));
                    PieceChecks.IsSound(wing);
                    PieceChecks.NormalsFollowFaces(wing, 0.95);
                    Assert.Equal(2 * 15 * 8 * 2, PieceChecks.TriangleCount(wing));
                }
            }
        }
    }

    [Theory]
    [InlineData(ThinWingStyle.DragonflyFore)]
    [InlineData(ThinWingStyle.DragonflyHind)]
    [InlineData(ThinWingStyle.ButterflyFore)]
    [InlineData(ThinWingStyle.ButterflyHind)]
    [InlineData(ThinWingStyle.MothFore)]
    [InlineData(ThinWingStyle.MothHind)]
    public void A_wing_of_a_family_is_a_closed_leaf_with_four_dozen_points_on_its_outline(ThinWingStyle style)
    {
        Piece wing = Build(new InsectWingBlueprint(26, 2.5, 0.8, 0.5, 0.1, 0.4, style));
        PieceChecks.IsSound(wing);
        PieceChecks.NormalsFollowFaces(wing, 0.8);
        Assert.Equal(2 * 22 * 8 * 2, PieceChecks.TriangleCount(wing));
        Assert.InRange(wing.Positions.Max(p => p.X) - back.Position.X, 0.4f, 0.82f);
    }

    /// <summary>Wings were sawn off at a quarter of their width.</summary>
    [Theory]
    [InlineData(0.12)]
    [InlineData(0.2)]
    [InlineData(0.3)]
    public void A_wing_without_a_family_runs_out_into_its_tip(double aspect)
    {
        Piece wing = Build(new InsectWingBlueprint(26, 2.5, 0.8, 0.8 * aspect, 0, 0));
        float tip = wing.Positions.Max(p => p.X);
        float[] end = wing.Positions.Where(p => p.X > tip - 1e-3f).Select(p => p.Z).ToArray();
        float[] all = wing.Positions.Select(p => p.Z).ToArray();
        Assert.InRange((end.Max() - end.Min()) / (all.Max() - all.Min()), 0f, 0.15f);
    }

    /// <summary>They were lances: broadest in the middle, with a point of .3 of that a tenth of their length before the tip.</summary>
    [Theory]
    [InlineData(0.12)]
    [InlineData(0.2)]
    [InlineData(0.3)]
    public void A_wing_without_a_family_is_narrow_at_its_hinge_and_round_at_its_tip(double aspect)
    {
        Piece wing = Build(new InsectWingBlueprint(26, 2.5, 0.8, 0.8 * aspect, 0, 0));
        float all = wing.Positions.Max(p => p.Z) - wing.Positions.Min(p => p.Z);
        Assert.InRange(WidthAt(wing, 0.13f) / all, 0f, 0.45f);
        Assert.InRange(WidthAt(wing, 0.9f) / all, 0.6f, 1f);
    }

    [Fact]
    public void A_wing_reaches_its_tip_and_is_about_as_wide_as_the_blueprint_says()
    {
        var blueprint = new InsectWingBlueprint(26, 2.5, 0.8, 0.2, 0, 0);
        Piece wing = Build(blueprint);
        Vector3[] joints = InsectWingShape.JointPoints(back, blueprint, 1f);
        Assert.Equal(3, joints.Length);
        Assert.Equal(0.8f, Vector3.Distance(joints[0], joints[2]), 5);
        Assert.Equal(joints[2].X, wing.Positions.Max(p => p.X), 0.02f);
        Assert.InRange(wing.Positions.Max(p => p.Z) - wing.Positions.Min(p => p.Z), 0.15f, 0.25f);
    }

    [Fact]
    public void A_wing_is_thin()
    {
        Piece wing = Build(new InsectWingBlueprint(26, 2.5, 0.8, 0.2, 0.3, 0.5));
        Vector3 centre = wing.Positions.Aggregate(Vector3.Zero, (a, b) => a + b) / wing.Positions.Length;
        double volume = 0;
        double area = 0;
        for (int t = 0; t < wing.Triangles.Length; t += 3)
        {
            Vector3 a = wing.Positions[wing.Triangles[t]] - centre;
            Vector3 b = wing.Positions[wing.Triangles[t + 1]] - centre;
            Vector3 c = wing.Positions[wing.Triangles[t + 2]] - centre;
            volume += Vector3.Dot(a, Vector3.Cross(b, c)) / 6.0;
            area += Vector3.Cross(b - a, c - a).Length() / 2.0;
        }

        Assert.InRange(2.0 * volume / area, 0.002, 0.008);
    }

    [Fact]
    public void Veins_and_membrane_both_show()
    {
        Piece wing = Build(new InsectWingBlueprint(26, 2.5, 0.8, 0.16, 0, 0.3));
        Assert.True(wing.Colours.Count(c => c.X < 0.12f) > 30);
        Assert.True(wing.Colours.Count(c => c.X > 0.4f) > 60);
    }

    [Fact]
    public void A_folded_wing_lies_back_and_inward()
    {
        Piece wing = Build(new InsectWingBlueprint(26, 2.5, 0.7, 0.15, -1.2, 0.2));
        Assert.True(wing.Positions.Min(p => p.Z) < back.Position.Z - 0.55f);
        Assert.True(wing.Positions.Min(p => p.X) < back.Position.X);
    }

    /// <summary>Hind wings went .09 over the midline, and wings laid back .05, where they pushed through one another.</summary>
    [Theory]
    [InlineData(1.05, 0.82, -0.28, 0.66, ThinWingStyle.ButterflyHind)]
    [InlineData(0.74, 0.25, -1.26, 0.12, ThinWingStyle.Blade)]
    [InlineData(0.95, 0.24, -1.48, 0.03, ThinWingStyle.Blade)]
    public void Wings_that_are_raised_over_the_back_or_laid_on_it_keep_off_the_midline(double length, double width, double azimuth, double elevation, ThinWingStyle style)
    {
        Piece wing = Build(new InsectWingBlueprint(30, 2.5, length, width, azimuth, elevation, style));
        Assert.True(wing.Positions.Min(p => p.X) > 0f, FormattableString.Invariant($"{wing.Positions.Min(p => p.X)}"));
    }

    /// <summary>A tail of three points was a square bite beside it.</summary>
    [Fact]
    public void Outlines_of_hind_wings_of_butterflies_bend_one_way_all_round_their_tip()
    {
        ThinWingForm form = ThinWingForm.Of(ThinWingStyle.ButterflyHind)!;
        WingPoint[] rim = [.. Enumerable.Range(8, form.Rows - 8).Select(row => form.At(row, 0)), .. Enumerable.Range(8, form.Rows - 8).Reverse().Select(row => form.At(row, 1))];
        for (int i = 2; i < rim.Length; i++)
        {
            double turn = ((rim[i - 1].X - rim[i - 2].X) * (rim[i].Y - rim[i - 1].Y)) - ((rim[i - 1].Y - rim[i - 2].Y) * (rim[i].X - rim[i - 1].X));
            Assert.True(turn < 1e-4, FormattableString.Invariant($"it turns back at {rim[i - 1].X}, {rim[i - 1].Y}"));
        }
    }

    /// <summary>Extent from front to rear at a share of the length, metres.</summary>
    private static float WidthAt(Piece wing, float share)
    {
        float[] across = wing.Positions.Where(p => Math.Abs(p.X - back.Position.X - (0.8f * share)) < 0.02f).Select(p => p.Z).ToArray();
        return across.Max() - across.Min();
    }

    private static Piece Build(InsectWingBlueprint blueprint)
    {
        var builder = new PieceBuilder();
        InsectWingShape.Append(builder, back, blueprint, 1f, membrane, vein);
        return builder.ToPiece(MaterialKind.Membrane, PieceChecks.Anywhere);
    }
}
