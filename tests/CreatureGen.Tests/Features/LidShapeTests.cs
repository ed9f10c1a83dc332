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

    [Fact]
    public void A_turn_about_the_hinge_blinks()
    {
        EyeBlueprint eye = calm with { LidTilt = 0.3 };
        Vector3 hinge = LidShape.Hinge(ahead, eye);
        Piece top = Build(eye, LidPart.Upper, ahead);
        for (int v = 0; v < top.Positions.Length; v++)
        {
            top.Positions[v] = Vec.Rotate(top.Positions[v], hinge, 1.5);
        }

        foreach ((float x, float y) in new[] { (0f, 0f), (0.5f, 0.2f), (-0.5f, 0f), (0f, 0.9f), (0f, -0.4f) })
        {
            Assert.True(Covers(top, ahead.Direction(new Vector2(x, y))), FormattableString.Invariant($"({x}, {y}) is covered"));
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
        return builder.ToPiece(MaterialKind.Skin);
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
