using System;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Footsteps;

public sealed class SwingClearanceTests
{
    private const float Length = 2f;

    private static readonly float spacing = Length / (SwingClearance.Knots + 1);

    [Fact]
    public void Level_ground_asks_for_no_rise()
    {
        SwingClearance way = Over(_ => 0f);
        Assert.All(new[] { 0f, 0.3f, 0.71f, 1f }, along => Assert.Equal(0f, way.Rise(along)));
    }

    [Fact]
    public void A_copy_rises_as_what_it_was_taken_from()
    {
        SwingClearance hill = Over(along => 0.2f * along * (1f - along));
        var copy = new SwingClearance();
        copy.CopyFrom(hill);
        Assert.All(new[] { 0.1f, 0.5f, 0.9f }, along => Assert.Equal(hill.Rise(along), copy.Rise(along)));
        Assert.True(copy.Rise(0.5f) > 0.04f);
    }

    [Fact]
    public void Hollows_ask_for_no_rise()
    {
        SwingClearance way = Over(along => -0.3f * along * (1f - along));
        Assert.All(new[] { 0.1f, 0.5f, 0.9f }, along => Assert.Equal(0f, way.Rise(along)));
    }

    [Fact]
    public void One_bump_makes_one_arc_from_end_to_end()
    {
        SwingClearance way = Over(along => Math.Abs(along - 0.5f) < 0.01f ? 0.1f : 0f);
        Assert.Equal(0.1f, way.Rise(0.5f), 5);
        Assert.Equal(0f, way.Rise(0f), 6);
        Assert.Equal(0f, way.Rise(1f), 6);
        float last = 0f;
        for (float along = 0.02f; along <= 0.5f; along += 0.02f)
        {
            float rise = way.Rise(along);
            Assert.True(rise > last, $"falls at {along}");
            Assert.Equal(rise, way.Rise(1f - along), 4);
            last = rise;
        }
    }

    [Fact]
    public void The_foot_clears_all_that_was_felt_without_dips_and_without_jerks()
    {
        var random = new RandomStream(11);
        for (int n = 0; n < 200; n++)
        {
            var heights = new float[SwingClearance.Knots];
            for (int i = 0; i < heights.Length; i++)
            {
                heights[i] = (float)random.Uniform(-0.1, 0.1);
            }

            SwingClearance way = Over(along => heights[(int)Math.Round((along * (SwingClearance.Knots + 1)) - 1)]);
            bool falls = false;
            float slope = float.NaN;
            for (int i = 0; i < heights.Length; i++)
            {
                Assert.True(way.Rise(SwingClearance.At(i)) >= heights[i] - 1e-6f, $"knot {i} of way {n} sticks out");
            }

            for (float along = 0.005f; along < 1f; along += 0.005f)
            {
                float now = (way.Rise(along) - way.Rise(along - 0.005f)) / 0.005f;
                Assert.True(float.IsNaN(slope) || Math.Abs(now - slope) < 0.25f, $"jerk at {along} of way {n}: from {slope} to {now}");
                Assert.False(falls && now > 0.02f, $"way {n} rises again at {along}");
                falls |= now < -0.02f;
                slope = now;
            }
        }
    }

    [Fact]
    public void An_edge_right_before_the_foot_is_cleared_at_once()
    {
        SwingClearance up = Over(along => 0.2f * (1f - along));
        SwingClearance down = Over(along => 0.2f * along);
        float early = 0.3f * SwingClearance.At(0);
        Assert.True(up.Rise(early) > 0.6f * up.Rise(SwingClearance.At(0)), $"{up.Rise(early)}");
        Assert.Equal(up.Rise(early), down.Rise(1f - early), 5);
    }

    [Fact]
    public void An_edge_between_two_knots_counts_on_both_sides_of_it()
    {
        SwingClearance way = Over(along => along > 0.55f ? 0.9f * spacing : 0f);
        Assert.True(way.Rise(0.5f) >= 0.9f * spacing - 1e-6f);
    }

    [Fact]
    public void A_sole_is_lifted_over_what_its_toes_may_reach()
    {
        SwingClearance way = Over(along => Math.Abs(along - 0.5f) < 0.01f ? 0.02f : 0f);
        var wide = new SwingClearance();
        Fill(wide, along => Math.Abs(along - 0.5f) < 0.01f ? 0.02f : 0f);
        wide.Span(Length, spacing, 0f, 0f);
        Assert.True(wide.Rise(0.375f) > 1.2f * way.Rise(0.375f), $"{wide.Rise(0.375f)} over {way.Rise(0.375f)}");
    }

    [Fact]
    public void What_is_felt_again_is_taken_up_by_the_share_asked_for()
    {
        var way = new SwingClearance();
        way.Feel(3, 0.1f, 1f);
        way.Feel(3, 0.2f, 0.5f);
        way.Span(Length, 0f, 0f, 0f);
        Assert.Equal(0.15f, way.Rise(0.5f), 5);
        way.Clear();
        way.Span(Length, 0f, 0f, 0f);
        Assert.Equal(0f, way.Rise(0.5f));
    }

    [Fact]
    public void Mirrored_ground_gives_the_mirrored_arc()
    {
        SwingClearance there = Over(along => 0.1f * along * along);
        SwingClearance back = Over(along => 0.1f * (1f - along) * (1f - along));
        for (float along = 0f; along <= 1f; along += 0.05f)
        {
            Assert.True(Math.Abs(there.Rise(along) - back.Rise(1f - along)) < 1e-6f, $"at {along}");
        }
    }

    private static SwingClearance Over(Func<float, float> ground)
    {
        var way = new SwingClearance();
        Fill(way, ground);
        way.Span(Length, 0f, 0f, 0f);
        return way;
    }

    private static void Fill(SwingClearance way, Func<float, float> ground)
    {
        for (int i = 0; i < SwingClearance.Knots; i++)
        {
            way.Feel(i, ground(SwingClearance.At(i)), 1f);
        }
    }
}
