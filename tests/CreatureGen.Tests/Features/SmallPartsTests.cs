using System.Linq;
using System.Numerics;
using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Features;

public sealed class SmallPartsTests
{
    private static readonly Vector3 ivory = new(0.8f, 0.75f, 0.6f);

    [Fact]
    public void A_claw_is_closed_small_and_never_below_the_floor()
    {
        RandomStream random = new Seed(3).Stream();
        for (int n = 0; n < 60; n++)
        {
            Vector3 direction = Vector3.Normalize(new Vector3((float)random.Uniform(-1, 1), (float)random.Uniform(-0.9, 0.4), (float)random.Uniform(0.05, 1)));
            float radius = (float)random.Uniform(0.006, 0.03);
            var builder = new PieceBuilder();
            ClawShape.Append(builder, new Vector3(0.2f, radius * 0.6f, 0.1f), direction, radius, radius * (float)random.Uniform(0.5, 3), 0f, ivory);
            Piece claw = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
            PieceChecks.IsSound(claw);
            Assert.InRange(PieceChecks.TriangleCount(claw), 10, 30);
            Assert.All(claw.Positions, p => Assert.InRange(p.Y, -1e-6f, 1f));
        }
    }

    [Fact]
    public void A_claw_of_a_hanging_foot_can_point_straight_down()
    {
        var builder = new PieceBuilder();
        ClawShape.Append(builder, new Vector3(0.2f, 0.5f, 0.1f), new Vector3(0f, -1f, 0f), 0.01f, 0.02f, float.NegativeInfinity, ivory);
        Piece claw = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
        PieceChecks.IsSound(claw);
        Assert.True(claw.Positions.Min(p => p.Y) < 0.485f);
    }

    [Fact]
    public void A_claw_reaches_as_far_as_its_length()
    {
        var builder = new PieceBuilder();
        ClawShape.Append(builder, new Vector3(0f, 0.5f, 0f), Vector3.UnitZ, 0.01f, 0.03f, float.NegativeInfinity, ivory);
        Assert.Equal(0.03f, builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere).Positions.Max(p => p.Z), 5);
    }

    [Fact]
    public void A_nail_is_closed_and_stands_on_the_floor()
    {
        var builder = new PieceBuilder();
        NailShape.Append(builder, new Vector3(0.1f, 0.02f, 0.3f), Vector3.Normalize(new Vector3(0.4f, 0.1f, 0.9f)), 0.03f, 0f, ivory);
        Piece nail = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
        PieceChecks.IsSound(nail);
        Assert.InRange(PieceChecks.TriangleCount(nail), 30, 80);
        Assert.Equal(0f, nail.Positions.Min(p => p.Y), 5);
    }

    /// <summary>By .56 of its half width it was a ball on the toe.</summary>
    [Fact]
    public void A_nail_lies_on_its_toe()
    {
        var builder = new PieceBuilder();
        NailShape.Append(builder, Vector3.Zero, Vector3.UnitZ, 1f, -9f, ivory);
        Assert.InRange(builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere).Positions.Max(p => p.Z), 0.15f, 0.35f);
    }

    [Fact]
    public void A_lure_is_a_thin_rod_with_a_small_leaf_that_is_palest_at_its_tip()
    {
        var feature = new FeatureBlueprint(FeatureKind.Lure, Ring: 11, Segment: 0, Length: 0.5, Radius: 0.018, Outward: 0, Upward: 1, Forward: 0.25, Sideward: 0, BendUp: -0.42, BendForward: 0.75, BendSide: 0, Flatness: 1.6, Taper: 0.5);
        var curve = new FeatureCurve(feature, new SurfacePoint(Vector3.UnitY, Vector3.UnitY), Vector3.UnitZ, Vector3.UnitY, 1f);
        var builder = new PieceBuilder();
        LureShape.Append(builder, feature, curve, 0.1f * ivory, 0.4f * ivory, ivory);
        Piece lure = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
        PieceChecks.IsSound(lure);
        PieceChecks.IsSymmetric(lure);
        PieceChecks.DoesNotCrossItself(lure);
        Assert.InRange(2 * lure.Positions.Max(p => p.X), 0.02, 0.13 * feature.Length);
        Vector3 tip = curve.Point(1f);
        Assert.Equal(lure.Colours.Max(c => c.X), lure.Colours[Array.FindIndex(lure.Positions, p => Vector3.Distance(p, tip) < 1e-5f)].X, 4);
    }

    [Fact]
    public void A_nostril_is_closed_dark_within_and_lies_close_to_the_skin()
    {
        var builder = new PieceBuilder();
        var at = new SurfacePoint(new Vector3(0.02f, 1f, 0.8f), Vector3.Normalize(new Vector3(0.4f, 0.2f, 0.9f)));
        NostrilShape.Append(builder, at, Vector3.UnitY, 0.01f, 1.5f, ivory);
        Piece nostril = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
        PieceChecks.IsSound(nostril);
        Assert.InRange(PieceChecks.TriangleCount(nostril), 30, 130);
        Assert.All(nostril.Positions, p => Assert.InRange(Vector3.Dot(p - at.Position, at.Normal), -0.004f, 0.002f));
        Assert.True(nostril.Colours.Last().Length() < 0.02f);
    }
}
