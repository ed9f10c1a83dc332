using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

public sealed class LegSweepTests
{
    [Fact]
    public void A_sweep_is_the_root_at_the_hip_and_sole_and_swing_at_the_ground()
    {
        LegPlacement leg = Leg(0, 1, 0.1, 0.5);
        Assert.Equal((-0.1, 0.1), LegSweep.Interval(leg, 1));
        (double rear, double front) = LegSweep.Interval(leg, 0);
        Assert.Equal(-0.02 - 0.5, rear, 12);
        Assert.Equal(0.03 + 0.5, front, 12);
        (rear, front) = LegSweep.Interval(leg, 0.5);
        Assert.Equal(-0.05 - 0.01 - 0.25, rear, 12);
        Assert.Equal(0.05 + 0.015 + 0.25, front, 12);
    }

    [Fact]
    public void Pairs_may_share_half_of_their_swings_and_no_more()
    {
        // Soles 0.02 and 0.03, half the swings 0.25 each: clear from 0.55 on.
        LegPlacement front = Leg(0, 1, 0.1, 0.5);
        Assert.Equal(0.01, LegSweep.Overlap(front, Leg(0.54, 1, 0.1, 0.5)), 12);
        Assert.True(LegSweep.Crosses(front, Leg(0.54, 1, 0.1, 0.5)));
        Assert.False(LegSweep.Crosses(front, Leg(0.56, 1, 0.1, 0.5)));
    }

    [Fact]
    public void Thick_roots_may_not_touch_even_when_the_feet_are_clear()
    {
        LegPlacement front = Leg(0, 1, 0.3, 0.01);
        Assert.Equal(0.1, LegSweep.Overlap(front, Leg(0.5, 1, 0.3, 0.01)), 12);
        Assert.False(LegSweep.Crosses(front, Leg(0.61, 1, 0.3, 0.01)));
    }

    [Fact]
    public void A_large_pair_is_kept_further_from_a_small_one_than_another_small_one()
    {
        LegPlacement small = Leg(0, 0.3, 0.04, 0.15);
        Assert.False(LegSweep.Crosses(small, Leg(0.25, 0.3, 0.04, 0.15)));
        Assert.True(LegSweep.Crosses(small, Leg(0.25, 1.2, 0.15, 0.6)));
        Assert.True(LegSweep.Crosses(Leg(-0.25, 1.2, 0.15, 0.6), small));
        Assert.False(LegSweep.Crosses(small, Leg(0.7, 1.2, 0.15, 0.6)));
    }

    [Fact]
    public void A_short_leg_meets_a_long_one_where_the_long_one_is_still_thick()
    {
        // The short leg hangs in the air beside the thigh of the long one: only the heights that both fill count.
        LegPlacement tall = Leg(0, 1, 0.2, 0.6);
        LegPlacement hanging = Leg(0.33, 1, 0.1, 0.02) with { TipHeight = 0.8, Foot = new FootContact(0.2, -0.33, 0.05, 0.02, 0.03) };
        Assert.False(LegSweep.Crosses(tall, hanging));
        Assert.True(LegSweep.Crosses(tall, hanging with { TipHeight = 0 }));
    }

    [Fact]
    public void Fanned_feet_pass_where_parallel_ones_cross()
    {
        LegPlacement front = Leg(0, 0.4, 0.05, 0.3);
        LegPlacement rear = Leg(0.2, 0.4, 0.05, 0.3);
        Assert.True(LegSweep.Crosses(front, rear));
        Assert.False(LegSweep.Crosses(front.Corrected(0.1, 1), rear.Corrected(-0.1, 1)));
    }

    [Fact]
    public void Sockets_whose_cells_or_pads_overlap_cross()
    {
        LegPlacement a = Leg(0, 0.2, 0.01, 0.01);
        LegPlacement b = Leg(0.5, 0.2, 0.01, 0.01);
        Assert.False(LegSweep.Crosses(a with { Socket = new SocketBlueprint(24, 8, 4, 4) }, b with { Socket = new SocketBlueprint(29, 8, 4, 4) }));
        Assert.True(LegSweep.Crosses(a with { Socket = new SocketBlueprint(24, 8, 4, 4) }, b with { Socket = new SocketBlueprint(28, 8, 4, 4) }));
    }

    [Fact]
    public void Crossing_is_symmetric_and_nowhere_missed_between_top_and_bottom()
    {
        var stream = new RandomStream(8);
        for (int n = 0; n < 2000; n++)
        {
            LegPlacement a = Leg(0, stream.Uniform(0.2, 1.2), stream.Uniform(0.01, 0.2), stream.Uniform(0, 0.6)).Corrected(stream.Uniform(-0.1, 0.1), 1);
            LegPlacement b = Leg(stream.Uniform(0.01, 1), stream.Uniform(0.2, 1.2), stream.Uniform(0.01, 0.2), stream.Uniform(0, 0.6)).Corrected(stream.Uniform(-0.1, 0.1), 1);
            Assert.Equal(LegSweep.Overlap(a, b), LegSweep.Overlap(b, a));
            double overlap = LegSweep.Overlap(a, b);
            double top = Math.Min(a.RootHeight, b.RootHeight);
            for (int step = 0; step <= 10; step++)
            {
                // Full swings less the shared half of both.
                double height = top * step / 10;
                double shared = LegSweep.SharedSwing * ((a.Swing * (a.RootHeight - height) / a.Length) + (b.Swing * (b.RootHeight - height) / b.Length));
                double here = LegSweep.Interval(b, height).Front - LegSweep.Interval(a, height).Rear - shared;
                Assert.True(here <= overlap + 1e-9);
            }
        }
    }

    /// <summary>A leg whose root lies <paramref name="along"/> behind the front, of given length, with a sole of 0.02 behind and 0.03 before its centre.</summary>
    private static LegPlacement Leg(double along, double length, double radius, double swing) => new(
        0,
        new LimbSocket(27, 8, LimbArchetype.UnguligradeHind, 0.5, 0, 0, SocketBounds.Limb),
        new SocketBlueprint(along <= 0 ? 20 : 40, 8, 4, 4),
        along,
        -along,
        length,
        0,
        radius,
        0,
        swing,
        new FootContact(0.2, -along, 0.05, 0.02, 0.03),
        0);
}
