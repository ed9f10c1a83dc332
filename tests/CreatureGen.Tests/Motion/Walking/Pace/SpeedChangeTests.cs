using System;
using CreatureGen.Motion.Walking.Pace;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Pace;

public sealed class SpeedChangeTests
{
    private static readonly SpeedBounds bounds = new(1f, 4f, 0.01f);

    /// <summary>From 2 m/s ahead to 1 m/s back: half a second of braking, then a second of gaining.</summary>
    [Fact]
    public void A_change_of_sides_brakes_first_and_then_gains_speed_as_from_rest()
    {
        IntendedSpeed momentum = IntendedSpeed.At(2f);
        momentum.Ask(-1f);
        momentum.Advance(0.5f, bounds);
        Assert.Equal(0f, momentum.Speed, 0.05f);
        momentum.Advance(0.5f, bounds);
        Assert.Equal(-0.5f, momentum.Speed, 0.05f);
        momentum.Advance(0.7f, bounds);
        Assert.Equal(-1f, momentum.Speed, 0.01f);
    }

    [Fact]
    public void The_way_is_the_mean_times_the_time_however_it_is_cut()
    {
        IntendedSpeed whole = IntendedSpeed.At(2f);
        whole.Ask(-1f);
        IntendedSpeed cut = whole;
        float way = 1.2f * whole.Advance(1.2f, bounds);
        float sum = 0f;
        for (int i = 0; i < 12; i++)
        {
            sum += 0.1f * cut.Advance(0.1f, bounds);
        }

        Assert.Equal(way, sum, 1e-4f);
        Assert.Equal(whole.Speed, cut.Speed, 1e-4f);
    }
}
