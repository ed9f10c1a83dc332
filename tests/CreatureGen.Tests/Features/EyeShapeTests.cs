using System.Linq;
using System.Numerics;
using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Features;
using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Features;

public sealed class EyeShapeTests
{
    private static readonly Vector3 amber = new(0.55f, 0.28f, 0.03f);

    [Theory]
    [InlineData(EyeStyle.Round)]
    [InlineData(EyeStyle.Slit)]
    [InlineData(EyeStyle.Bar)]
    [InlineData(EyeStyle.Compound)]
    public void An_eye_is_closed_and_within_its_budget(EyeStyle style)
    {
        foreach (Vector3 gaze in Gazes())
        {
            Piece eye = Build(style, new EyeFrame(new Vector3(0.1f, 0.9f, 0.6f), 0.05f, gaze));
            PieceChecks.IsSound(eye);
            PieceChecks.NormalsFollowFaces(eye, 0.9);
            Assert.InRange(PieceChecks.TriangleCount(eye), 100, 300);
        }
    }

    [Theory]
    [InlineData(EyeStyle.Round)]
    [InlineData(EyeStyle.Slit)]
    public void A_pupil_is_dark_where_the_eye_looks_and_the_iris_surrounds_it(EyeStyle style)
    {
        var frame = new EyeFrame(Vector3.Zero, 1f, Vector3.UnitZ);
        Piece eye = Build(style, frame);
        Assert.True(ColourAlong(eye, Vector3.Normalize(new Vector3(0.02f, 0.03f, 1f))).Length() < 0.05f);
        Vector3 side = ColourAlong(eye, Vector3.Normalize(new Vector3(0.68f, 0f, 0.73f)));
        Assert.True(side.X > 0.2f && side.X > 3f * side.Z, "beside the pupil lies the amber iris");
        Assert.True(ColourAlong(eye, Vector3.Normalize(new Vector3(0.9f, 0f, -0.4f))).Length() < 0.1f);
    }

    [Fact]
    public void A_slit_is_upright_and_narrow()
    {
        Piece eye = Build(EyeStyle.Slit, new EyeFrame(Vector3.Zero, 1f, Vector3.UnitZ));
        Assert.True(ColourAlong(eye, Direction(0.01f, -0.5f)).Length() < 0.05f);
        Assert.True(ColourAlong(eye, Direction(0.4f, 0.02f)).X > 0.2f);
    }

    [Fact]
    public void A_bar_is_level_and_as_wide_at_its_ends_as_in_the_middle()
    {
        var frame = new EyeFrame(Vector3.Zero, 1f, Vector3.UnitZ);
        Piece eye = Build(EyeStyle.Bar, frame);
        Assert.True(ColourAlong(eye, Direction(-0.5f, 0.01f)).Length() < 0.05f);
        Assert.True(ColourAlong(eye, Direction(0.5f, -0.08f)).Length() < 0.05f);
        Assert.True(ColourAlong(eye, Direction(0.02f, -0.4f)).X > 0.2f);
        Assert.True(ColourAlong(eye, Direction(0.02f, -0.4f)).X > 0.2f);
        Piece tilted = Build(EyeStyle.Bar, frame.Rolled(0.4));
        Assert.True(ColourAlong(tilted, Direction(0.55f, -0.19f)).X > 0.2f, "the bar follows the frame");
    }

    [Fact]
    public void Rings_are_doubled_on_the_edges_of_colours()
    {
        Piece eye = Build(EyeStyle.Round, new EyeFrame(Vector3.Zero, 1f, Vector3.UnitZ));
        int doubled = eye.Positions.GroupBy(p => p).Count(g => g.Count() == 2);
        Assert.Equal(3 * 20, doubled);
    }

    [Fact]
    public void The_iris_is_darker_under_the_brow()
    {
        Piece eye = Build(EyeStyle.Round, new EyeFrame(Vector3.Zero, 1f, Vector3.UnitZ));
        Assert.True(ColourAlong(eye, Direction(0.1f, 0.75f)).X < 0.7f * ColourAlong(eye, Direction(0.1f, -0.75f)).X);
    }

    [Fact]
    public void A_compound_eye_is_dark_below_and_light_above()
    {
        Piece eye = Build(EyeStyle.Compound, new EyeFrame(Vector3.Zero, 1f, Vector3.UnitZ));
        Assert.True(ColourAlong(eye, Direction(0.03f, -0.9f)).X < 0.6f * ColourAlong(eye, Direction(0.03f, 0.9f)).X);
    }

    [Fact]
    public void The_eyeball_stays_within_its_bulge()
    {
        Piece eye = Build(EyeStyle.Round, new EyeFrame(new Vector3(1f, 2f, 3f), 0.5f, Vector3.UnitX));
        Assert.All(eye.Positions, p => Assert.InRange(Vector3.Distance(p, new Vector3(1f, 2f, 3f)), 0.4f, 0.5f * EyeShape.Bulge * 1.031f));
    }

    [Fact]
    public void The_other_eye_is_the_exact_mirror_image()
    {
        Piece left = Build(EyeStyle.Slit, new EyeFrame(new Vector3(0.1f, 0.9f, 0.6f), 0.05f, Vector3.Normalize(new Vector3(0.8f, 0.2f, 0.5f))));
        Piece right = PieceMirror.Mirror(left, PieceChecks.Anywhere);
        PieceChecks.IsSound(right);
        for (int v = 0; v < left.Positions.Length; v++)
        {
            Assert.Equal(new Vector3(-left.Positions[v].X, left.Positions[v].Y, left.Positions[v].Z), right.Positions[v]);
            Assert.Equal(new Vector3(-left.Normals[v].X, left.Normals[v].Y, left.Normals[v].Z), right.Normals[v]);
            Assert.Equal(left.Colours[v], right.Colours[v]);
        }
    }

    [Fact]
    public void A_frame_follows_the_blueprint()
    {
        var skin = new SurfacePoint(new Vector3(0.2f, 1f, 0.5f), Vector3.UnitX);
        var eye = new EyeBlueprint(EyeStyle.Round, 9, 6, 0.04, 0.5, 0.0, 0.9, 1.1, 0);
        EyeFrame straight = EyeFrame.On(skin, eye, Vector3.UnitZ, 2f);
        Assert.Equal(0.08f, straight.Radius);
        Assert.Equal(new Vector3(0.16f, 1f, 0.5f), straight.Centre);
        Assert.Equal(Vector3.UnitX, straight.Gaze);
        EyeFrame forward = EyeFrame.On(skin, eye with { Forward = 0.75 }, Vector3.UnitZ, 1f);
        Assert.True(Vector3.Distance(Vector3.Normalize(new Vector3(1f, 0f, 1f)), forward.Gaze) < 1e-6f);
        Assert.True(Vector3.Distance(Vector3.Normalize(new Vector3(1f, 0f, -1f)), forward.Outward) < 1e-6f);
        Assert.True(Vector3.Distance(Vector3.UnitY, forward.Up) < 1e-6f);
    }

    private static Vector3 Direction(float across, float up)
    {
        var frame = new EyeFrame(Vector3.Zero, 1f, Vector3.UnitZ);
        return frame.Direction(new Vector2(across, up));
    }

    private static Vector3[] Gazes() => new[]
    {
        Vector3.UnitX, Vector3.UnitZ, Vector3.Normalize(new Vector3(0.6f, 0.3f, 0.7f)), Vector3.Normalize(new Vector3(0.3f, 0.95f, 0.1f)), Vector3.UnitY,
    };

    private static Piece Build(EyeStyle style, EyeFrame frame)
    {
        var builder = new PieceBuilder();
        EyeShape.Append(builder, frame, style, amber);
        return builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
    }

    // Colour of the outermost triangle that a ray from the centre meets, interpolated; the glints are left out.
    private static Vector3 ColourAlong(Piece piece, Vector3 direction)
    {
        float best = 0f;
        Vector3 colour = default;
        for (int t = 0; t < piece.Triangles.Length; t += 3)
        {
            int i = piece.Triangles[t];
            int j = piece.Triangles[t + 1];
            int k = piece.Triangles[t + 2];
            if (piece.Colours[i] == Vector3.One)
            {
                continue;
            }

            if (RayCast.Hit(Vector3.Zero, direction, piece.Positions[i], piece.Positions[j], piece.Positions[k], out float distance, out float u, out float v) && distance > best)
            {
                best = distance;
                colour = (piece.Colours[i] * (1f - u - v)) + (piece.Colours[j] * u) + (piece.Colours[k] * v);
            }
        }

        Assert.True(best > 0f, "the ray meets the eye");
        return colour;
    }
}
