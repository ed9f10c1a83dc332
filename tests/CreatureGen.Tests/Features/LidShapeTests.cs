using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using Xunit;

namespace CreatureGen.Tests.Features;

public sealed class LidShapeTests
{
    private static readonly EyeBlueprint calm = new(EyeStyle.Round, 9, 6, 1, 0.6, 0.4, 0.95, 1.15, 0);
    private static readonly EyeFrame ahead = new(Vector3.Zero, 1f, Vector3.UnitZ);

    [Fact]
    public void Lids_are_closed_shells_within_their_budget_at_every_opening_and_roll()
    {
        int most = 0;
        foreach (double upper in new[] { 0.0, 0.3, 0.7, 0.95, 1.2, 3.0 })
        {
            foreach (double lower in new[] { 0.4, 1.1, 1.3 })
            {
                foreach (double tilt in new[] { -0.5, 0.0, 0.4 })
                {
                    EyeBlueprint eye = calm with { UpperLid = upper, LowerLid = lower, LidTilt = tilt };
                    Piece top = Build(eye, LidPart.Upper, new EyeFrame(new Vector3(0.1f, 1f, 0.5f), 0.06f, Vector3.Normalize(new Vector3(0.7f, 0.2f, 0.6f))));
                    Piece bottom = Build(eye, LidPart.Lower, ahead);
                    PieceChecks.IsSound(top);
                    PieceChecks.IsSound(bottom);
                    PieceChecks.DoesNotCrossItself(top);
                    PieceChecks.DoesNotCrossItself(bottom);
                    most = Math.Max(most, PieceChecks.TriangleCount(top) + PieceChecks.TriangleCount(bottom));
                }
            }
        }

        Assert.InRange(most, 100, 256);
    }

    [Fact]
    public void Open_lids_leave_the_pupil_free_and_cover_the_ball_above_and_below()
    {
        Piece top = Build(calm, LidPart.Upper, ahead);
        Piece bottom = Build(calm, LidPart.Lower, ahead);
        foreach ((float x, float y) in new[] { (0f, 0f), (0.3f, 0.3f), (-0.5f, 0f), (0f, 0.85f), (0f, -1.05f) })
        {
            Vector3 look = ahead.Direction(new Vector2(x, y));
            Assert.False(Covers(top, look) || Covers(bottom, look), FormattableString.Invariant($"({x}, {y}) is free"));
        }

        Assert.True(Covers(top, ahead.Direction(new Vector2(0f, 1.1f))));
        Assert.True(Covers(bottom, ahead.Direction(new Vector2(0f, -1.3f))));
        Assert.True(Covers(top, ahead.Direction(new Vector2(0.5f, 1.2f))));
    }

    public static TheoryData<double, double, double> Moods => new() { { 0.95, 1.15, 0 }, { 0.6, 1.1, 0.4 }, { 1.2, 1.25, -0.4 }, { 0.7, 0.7, 0.2 }, { 1.25, 0.9, 0 } };

    [Theory]
    [MemberData(nameof(Moods))]
    public void Shut_lids_cover_the_whole_front_of_the_eyeball(double upper, double lower, double tilt)
    {
        EyeBlueprint eye = calm with { UpperLid = upper, LowerLid = lower, LidTilt = tilt };
        Piece top = Shut(eye, LidPart.Upper, 1);
        Piece bottom = Shut(eye, LidPart.Lower, 1);
        foreach (Vector3 look in Front(1.2f))
        {
            Assert.True(Covers(top, look) || Covers(bottom, look), FormattableString.Invariant($"{look} is covered"));
        }
    }

    [Theory]
    [MemberData(nameof(Moods))]
    public void Moving_lids_never_let_the_eyeball_through(double upper, double lower, double tilt)
    {
        EyeBlueprint eye = calm with { UpperLid = upper, LowerLid = lower, LidTilt = tilt };
        var builder = new PieceBuilder();
        EyeShape.Append(builder, ahead, EyeStyle.Round, Vector3.One);
        Piece ball = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
        for (int step = 0; step <= 4; step++)
        {
            Piece top = Shut(eye, LidPart.Upper, step / 4f);
            Piece bottom = Shut(eye, LidPart.Lower, step / 4f);
            foreach (Vector3 look in Front(1.1f))
            {
                float lid = Math.Max(Farthest(top, look), Farthest(bottom, look));
                float eyeball = Farthest(ball, look);
                Assert.True(lid == 0f || lid > eyeball - 0.01f, FormattableString.Invariant($"step {step}, {look}: lid at {lid}, ball at {eyeball}"));
            }
        }
    }

    [Fact]
    public void Half_shut_lids_cover_half_of_the_pupil()
    {
        Piece top = Shut(calm, LidPart.Upper, 0.5f);
        Assert.True(Covers(top, ahead.Direction(new Vector2(0f, 0.4f))));
        Assert.False(Covers(top, ahead.Direction(new Vector2(0f, -0.3f))));
    }

    [Fact]
    public void The_rim_of_a_lid_lies_in_its_direction()
    {
        EyeBlueprint eye = calm with { LidTilt = 0.3 };
        foreach (LidPart part in new[] { LidPart.Upper, LidPart.Lower })
        {
            Vector3 rim = LidShape.RimDirection(ahead, eye, part);
            Assert.Equal(1f, rim.Length(), 1e-5f);
            Assert.Equal(0f, Vector3.Dot(rim, LidShape.Hinge(ahead, eye)), 1e-5f);
            Assert.Equal(part == LidPart.Upper, Vector3.Dot(rim, Vector3.UnitY) > 0f);
            Assert.Contains(Build(eye, part, ahead).Positions, p => Vector3.Distance(Vector3.Normalize(p), rim) < 0.03f);
        }
    }

    [Fact]
    public void A_positive_tilt_frowns()
    {
        // The left eye looks ahead: its inner corner lies towards −X.
        Piece level = Build(calm, LidPart.Upper, ahead);
        Piece frown = Build(calm with { LidTilt = 0.4 }, LidPart.Upper, ahead);
        Vector3 inner = ahead.Direction(new Vector2(-0.6f, 0.78f));
        Vector3 outer = ahead.Direction(new Vector2(0.6f, 0.88f));
        Assert.False(Covers(level, inner));
        Assert.True(Covers(frown, inner));
        Assert.True(Covers(level, outer));
        Assert.False(Covers(frown, outer));
    }

    [Fact]
    public void The_rim_is_darker_than_the_lid()
    {
        var skin = new Vector3(0.4f, 0.3f, 0.2f);
        Piece top = Build(calm, LidPart.Upper, ahead);
        Assert.Contains(top.Colours, c => c == skin);
        Assert.True(top.Colours.Count(c => c.X < 0.2f * skin.X) > 20);
    }

    private static Piece Build(EyeBlueprint eye, LidPart part, EyeFrame frame)
    {
        var builder = new PieceBuilder();
        LidShape.Append(builder, frame, eye, part, new Vector3(0.4f, 0.3f, 0.2f));
        return builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
    }

    /// <summary>A lid turned by a share of its closing angle.</summary>
    private static Piece Shut(EyeBlueprint eye, LidPart part, float share)
    {
        Piece lid = Build(eye, part, ahead);
        double turn = share * LidShape.Closing(eye, part) * (part == LidPart.Upper ? 1 : -1);
        for (int v = 0; v < lid.Positions.Length; v++)
        {
            lid.Positions[v] = Vec.Rotate(lid.Positions[v], LidShape.Hinge(ahead, eye), turn);
        }

        return lid;
    }

    private static IEnumerable<Vector3> Front(float angle)
    {
        for (int ring = 0; ring <= 8; ring++)
        {
            for (int k = 0; k < 24; k++)
            {
                double around = Math.Tau * (k + 0.37) / 24;
                yield return ahead.Direction(new Vector2((float)Math.Cos(around), (float)Math.Sin(around)) * (angle * ring / 8f));
            }
        }
    }

    /// <summary>Where a ray from the centre leaves a piece, 0 when it misses it.</summary>
    private static float Farthest(Piece piece, Vector3 direction)
    {
        float farthest = 0f;
        for (int t = 0; t < piece.Triangles.Length; t += 3)
        {
            if (RayCast.Hit(Vector3.Zero, direction, piece.Positions[piece.Triangles[t]], piece.Positions[piece.Triangles[t + 1]], piece.Positions[piece.Triangles[t + 2]], out float distance, out _, out _))
            {
                farthest = Math.Max(farthest, distance);
            }
        }

        return farthest;
    }

    private static bool Covers(Piece lid, Vector3 direction)
    {
        for (int t = 0; t < lid.Triangles.Length; t += 3)
        {
            if (RayCast.Hit(Vector3.Zero, direction, lid.Positions[lid.Triangles[t]], lid.Positions[lid.Triangles[t + 1]], lid.Positions[lid.Triangles[t + 2]], out float distance, out _, out _)
                && distance > 1f)
            {
                return true;
            }
        }

        return false;
    }
}
