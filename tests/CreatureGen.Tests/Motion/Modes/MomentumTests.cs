using System;
using CreatureGen.Motion.Modes;
using Xunit;

namespace CreatureGen.Tests.Motion.Modes;

public sealed class MomentumTests
{
    private static readonly MomentumLimits Fish = new(1.1, 0.46, 0.1, 4);

    [Fact]
    public void Thrust_and_drag_agree_on_a_top_speed()
    {
        Momentum momentum = After(Fish, 100, 60, 60);
        Assert.Equal(Math.Sqrt(Fish.Thrust / Fish.Drag), momentum.Speed, 1e-3);
    }

    [Fact]
    public void A_body_without_brakes_loses_half_of_its_speed_on_069_over_its_drag()
    {
        MomentumLimits glider = Fish with { Braking = 0, Jerk = 1e4 };
        var momentum = Momentum.At(2);
        double way = 0;
        while (momentum.Speed > 1)
        {
            way += momentum.Step(0, glider, 1.0 / 480);
        }

        Assert.Equal(Math.Log(2) / glider.Drag, way, 0.05);
    }

    [Fact]
    public void It_comes_to_its_goal_and_never_goes_beyond_nor_faster_than_its_bounds()
    {
        var momentum = default(Momentum);
        const double Step = 1.0 / 240;
        foreach (double goal in new[] { 1.3, 0.2, 2, 0, -0.8, 1 })
        {
            double min = Math.Min(momentum.Speed, goal) - 0.02;
            double max = Math.Max(momentum.Speed, goal) + 0.02;
            for (int i = 0; i < 240 * 6; i++)
            {
                double before = momentum.Acceleration;
                momentum.Step(goal, Fish, Step);
                Assert.InRange(momentum.Speed, min, max);
                Assert.InRange(Math.Abs(momentum.Acceleration), 0, Fish.Thrust + (Fish.Drag * 4));
                Assert.InRange(Math.Abs(momentum.Acceleration - before), 0, (Fish.Jerk * Step) + 1e-9);
            }

            Assert.Equal(goal, momentum.Speed, 1e-3);
        }
    }

    /// <summary>Swimmers that were told to stop in the middle of their first strokes got faster for .7 s.</summary>
    [Fact]
    public void A_body_that_is_to_stop_lets_go_of_its_push_at_once()
    {
        MomentumLimits swimmer = Fish with { LettingGo = 4 };
        Momentum momentum = After(swimmer, 1.3, 0.4, 60);
        Assert.InRange(momentum.Acceleration, 0.8 * Fish.Thrust, Fish.Thrust);
        momentum.Step(0, swimmer.Quickened(1), 0.1);
        Assert.InRange(momentum.Acceleration, -Fish.Thrust, 0);
    }

    [Fact]
    public void The_mirrored_goal_gives_the_mirrored_way()
    {
        Momentum a = default;
        Momentum b = default;
        for (int i = 0; i < 100; i++)
        {
            Assert.Equal(a.Step(0.9, Fish, 0.016), -b.Step(-0.9, Fish, 0.016));
        }
    }

    [Theory]
    [InlineData(30)]
    [InlineData(144)]
    [InlineData(4)]
    public void Cutting_the_time_differently_changes_the_way_by_less_than_a_thousandth(int hertz)
    {
        double way = 0;
        double reference = 0;
        After(Fish, 1.3, 3, hertz, ref way);
        After(Fish, 1.3, 3, 960, ref reference);
        Assert.Equal(1, way / reference, 1e-3);
    }

    [Theory]
    [InlineData(2)]
    [InlineData(7)]
    public void A_plan_that_is_gone_through_in_pieces_ends_where_it_does_in_one(int pieces)
    {
        const double Period = 1.0 / 240;
        Momentum whole = default;
        Momentum cut = default;
        double way = 0;
        double sum = 0;
        for (int i = 0; i < 480; i++)
        {
            double goal = i < 240 ? 1.3 : -0.4;
            whole.Plan(goal, Fish, Period);
            cut.Plan(goal, Fish, Period);
            way += whole.Advance(Period);
            for (int k = 0; k < pieces; k++)
            {
                sum += cut.Advance(Period / pieces);
            }
        }

        Assert.InRange(way, 0.1, 2);
        Assert.Equal(way, sum, 1e-12);
        Assert.Equal(whole.Speed, cut.Speed, 1e-12);
    }

    [Fact]
    public void No_time_changes_nothing()
    {
        Momentum momentum = After(Fish, 1.3, 0.4, 60);
        Momentum before = momentum;
        Assert.Equal(0, momentum.Step(0, Fish, 0));
        Assert.Equal(before, momentum);
    }

    private static Momentum After(in MomentumLimits limits, double goal, double seconds, int hertz)
    {
        double way = 0;
        return After(limits, goal, seconds, hertz, ref way);
    }

    private static Momentum After(in MomentumLimits limits, double goal, double seconds, int hertz, ref double way)
    {
        Momentum momentum = default;
        for (int i = 0; i < (int)(seconds * hertz); i++)
        {
            way += momentum.Step(goal, limits, 1.0 / hertz);
        }

        return momentum;
    }
}
