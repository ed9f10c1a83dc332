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

public sealed class HornShapeTests
{
    private static readonly Vector3 bone = new(0.5f, 0.45f, 0.35f);
    private static readonly SurfacePoint shoulder = new(new Vector3(0.1f, 1f, 0.4f), Vector3.Normalize(new Vector3(0.5f, 0.8f, 0.1f)));

    public static TheoryData<FeatureKind, int, int> Budgets() => new()
    {
        { FeatureKind.Horn, 60, 150 },
        { FeatureKind.Spike, 18, 30 },
        { FeatureKind.Tusk, 30, 90 },
        { FeatureKind.Tuft, 30, 60 },
        { FeatureKind.Mandible, 30, 80 },
        { FeatureKind.Antenna, 60, 150 },
    };

    [Theory]
    [MemberData(nameof(Budgets))]
    public void Every_kind_is_closed_within_its_budget_over_many_shapes(FeatureKind kind, int fewest, int most)
    {
        RandomStream random = new Seed(7).Child(kind.ToString()).Stream();
        for (int n = 0; n < 60; n++)
        {
            var feature = new FeatureBlueprint(
                kind, 13, 3, random.Uniform(0.03, 0.6), random.Uniform(0.004, 0.06),
                random.Uniform(0, 1), random.Uniform(-0.5, 1), random.Uniform(-1, 1), random.Uniform(-0.2, 1),
                random.Uniform(-0.6, 0.6), random.Uniform(-0.6, 0.6), random.Uniform(-0.6, 0.6), random.Uniform(0.35, 1.2), random.Uniform(0.4, 1.5));
            Piece piece = Build(feature, shoulder);
            PieceChecks.IsSound(piece);
            Assert.InRange(PieceChecks.TriangleCount(piece), fewest, most);
        }
    }

    [Fact]
    public void The_root_is_covered_by_the_skin_and_the_tip_is_where_the_blueprint_puts_it()
    {
        foreach (double sideward in new[] { 0.0, 0.5, 1.5 })
        {
            FeatureBlueprint feature = Feature(FeatureKind.Horn) with { Outward = 1, Upward = 0, Sideward = sideward, BendUp = 0, BendForward = 0.4, BendSide = 0 };
            Piece piece = Build(feature, shoulder);
            for (int k = 0; k < 8; k++)
            {
                Assert.True(Vector3.Dot(piece.Positions[k] - shoulder.Position, shoulder.Normal) < -0.004f, "the rim of the root lies below the skin");
            }

            Vector3 direction = Vector3.Normalize(shoulder.Normal + (Vector3.UnitX * (float)sideward));
            Vector3 tip = shoulder.Position + (direction * 0.2f) + (Vector3.UnitZ * (0.4f * 0.2f));
            Assert.Contains(piece.Positions, p => Vector3.Distance(p, tip) < 1e-5f);
        }
    }

    [Theory]
    [InlineData(FeatureKind.Horn)]
    [InlineData(FeatureKind.Spike)]
    [InlineData(FeatureKind.Tuft)]
    public void A_part_on_the_midline_is_its_own_mirror_image(FeatureKind kind)
    {
        // The point and the directions lean a little to the side; a part of segment 0 does not follow them.
        var crown = new SurfacePoint(new Vector3(1e-4f, 1.1f, 0.6f), Vector3.Normalize(new Vector3(0.01f, 0.9f, 0.3f)));
        Piece piece = Build(Feature(kind) with { Segment = 0, Outward = 1, Upward = 0.3, Forward = 0.4, BendForward = -0.3, BendUp = 0.2, Flatness = 0.5 }, crown);
        PieceChecks.IsSymmetric(piece);
    }

    [Fact]
    public void Flatness_thins_a_part_across_the_body()
    {
        var crown = new SurfacePoint(new Vector3(0f, 1f, 0f), Vector3.UnitY);
        FeatureBlueprint feature = Feature(FeatureKind.Tuft) with { Outward = 1, Upward = 0, Sideward = 0, BendSide = 0, BendForward = 0, BendUp = 0, Flatness = 0.4 };
        Piece piece = Build(feature, crown);
        float across = piece.Positions.Max(p => p.X) - piece.Positions.Min(p => p.X);
        float along = piece.Positions.Max(p => p.Z) - piece.Positions.Min(p => p.Z);
        Assert.InRange(across / along, 0.3f, 0.5f);
    }

    [Fact]
    public void A_low_taper_exponent_is_blunt()
    {
        FeatureBlueprint feature = Feature(FeatureKind.Tusk) with { BendUp = 0, BendForward = 0, BendSide = 0 };
        Assert.True(Volume(Build(feature with { Taper = 0.5 }, shoulder)) > 1.3 * Volume(Build(feature with { Taper = 1.0 }, shoulder)));
    }

    [Fact]
    public void Moving_the_skin_moves_the_part()
    {
        Piece here = Build(Feature(FeatureKind.Horn), shoulder);
        var shift = new Vector3(0.5f, -0.25f, 1f);
        Piece there = Build(Feature(FeatureKind.Horn), new SurfacePoint(shoulder.Position + shift, shoulder.Normal));
        for (int v = 0; v < here.Positions.Length; v++)
        {
            Assert.True(Vector3.Distance(here.Positions[v] + shift, there.Positions[v]) < 1e-5f);
        }
    }

    [Fact]
    public void Scale_enlarges_the_whole_part()
    {
        FeatureBlueprint feature = Feature(FeatureKind.Spike);
        double one = Volume(Build(feature, shoulder, 1f));
        double two = Volume(Build(feature, shoulder, 2f));
        Assert.InRange(two / one, 6.0, 9.0);
    }

    [Fact]
    public void A_part_without_length_is_refused_instead_of_leaving_as_not_a_number()
    {
        InvalidOperationException error = Assert.Throws<InvalidOperationException>(() => Build(Feature(FeatureKind.Horn) with { Length = 0 }, shoulder));
        Assert.Contains("expected finite numbers", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Joints_of_an_antenna_are_root_middle_and_tip_of_its_curve()
    {
        var curve = new FeatureCurve(Feature(FeatureKind.Antenna) with { BendUp = -0.5 }, shoulder, Vector3.UnitZ, Vector3.UnitY, 1f);
        Vector3[] joints = curve.JointPoints();
        Assert.Equal(3, joints.Length);
        Assert.Equal(shoulder.Position, joints[0]);
        Assert.Equal(curve.Point(0.5f), joints[1]);
        Assert.Equal(curve.Point(1f), joints[2]);
    }

    [Fact]
    public void The_knob_of_an_antenna_has_a_colour_of_its_own()
    {
        var knob = new Vector3(0.9f, 0.1f, 0.5f);
        FeatureBlueprint feature = Feature(FeatureKind.Antenna);
        var builder = new PieceBuilder();
        AntennaShape.Append(builder, feature, new FeatureCurve(feature, shoulder, Vector3.UnitZ, Vector3.UnitY, 1f), 1f, bone, knob);
        Piece piece = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
        Assert.Contains(knob, piece.Colours);
        Assert.Contains(bone, piece.Colours);
    }

    private static FeatureBlueprint Feature(FeatureKind kind) =>
        new(kind, 13, 3, 0.2, 0.02, 0.5, 1, 0, 0.3, 0.1, 0.2, -0.1, 1, 1);

    private static Piece Build(FeatureBlueprint feature, SurfacePoint skin, float scale = 1f)
    {
        var builder = new PieceBuilder();
        var curve = new FeatureCurve(feature, skin, Vector3.UnitZ, Vector3.UnitY, scale);
        if (feature.Kind == FeatureKind.Antenna)
        {
            AntennaShape.Append(builder, feature, curve, scale, bone, bone);
        }
        else
        {
            HornShape.Append(builder, feature, curve, scale, bone);
        }

        return builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
    }

    private static double Volume(Piece piece)
    {
        double sum = 0;
        Vector3 origin = piece.Positions[0];
        for (int t = 0; t < piece.Triangles.Length; t += 3)
        {
            Vector3 a = piece.Positions[piece.Triangles[t]] - origin;
            sum += Vector3.Dot(a, Vector3.Cross(piece.Positions[piece.Triangles[t + 1]] - origin, piece.Positions[piece.Triangles[t + 2]] - origin)) / 6.0;
        }

        return sum;
    }
}
