using System;
using System.Numerics;
using CreatureGen.Motion.Walking.Legs;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Legs;

public sealed class ToeTipTests
{
    private const float BallHeight = 0.05f;

    [Theory]
    [InlineData(0.1f, 0.03f)]
    [InlineData(0.2f, 0.005f)]
    public void The_circle_of_round_toes_is_found(float ahead, float radius)
    {
        ToeTip tip = Round(ahead, radius).Fit(ahead + radius);
        Assert.Equal(ahead, tip.Ahead, 1e-3f);
        Assert.Equal(radius, tip.Radius, 1e-3f);
    }

    [Fact]
    public void Toes_that_end_in_an_edge_and_those_of_which_nothing_was_seen_have_no_radius()
    {
        var edge = new ToeTip.Profile();
        edge.Add(0.1f, 0f);
        edge.Add(0.1f, 0.04f);
        Assert.Equal(new ToeTip(0.1f, 0f), new ToeTip(MathF.Round(edge.Fit(0.1f).Ahead, 4), edge.Fit(0.1f).Radius));
        Assert.Equal(new ToeTip(0.3f, 0f), default(ToeTip.Profile).Fit(0.3f));
    }

    [Fact]
    public void A_foot_that_rolls_over_round_toes_touches_the_ground_with_a_point_that_does_not_move()
    {
        const float Step = 1e-3f;
        var tip = new ToeTip(0.1f, 0.03f);
        for (float pitch = 0.1f; pitch < 0.9f; pitch += 0.1f)
        {
            // What touches is below the middle of the circle.
            var touches = new Vector2(tip.Ahead + (tip.Radius * MathF.Sin(pitch)), tip.Radius - (tip.Radius * MathF.Cos(pitch)));
            Assert.Equal(0f, Place(tip, touches, pitch).Y, 1e-5f);
            Assert.Equal(0f, (Place(tip, touches, pitch + Step) - Place(tip, touches, pitch - Step)).Length() / (2f * Step), 1e-4f);
        }
    }

    private static ToeTip.Profile Round(float ahead, float radius)
    {
        var profile = new ToeTip.Profile();
        for (int i = 0; i <= 90; i++)
        {
            float angle = i * MathF.PI / 180f;
            profile.Add(ahead + (radius * MathF.Sin(angle)), radius - (radius * MathF.Cos(angle)));
        }

        return profile;
    }

    /// <summary>Where a point of a foot that lies with its ball over the origin is as it is turned down.</summary>
    private static Vector2 Place(ToeTip tip, Vector2 point, float pitch)
    {
        Vector2 ball = tip.BallAt(pitch, BallHeight);
        Vector2 from = point - new Vector2(0f, BallHeight);
        return ball + new Vector2((from.X * MathF.Cos(pitch)) + (from.Y * MathF.Sin(pitch)), (from.Y * MathF.Cos(pitch)) - (from.X * MathF.Sin(pitch)));
    }
}
