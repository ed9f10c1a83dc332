using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Falling;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

public sealed class DriftTests
{
    /// <summary>A shove of 2 m/s dies away over τ = 0.3 s: 0.6 m in all, however the time is cut.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(7)]
    [InlineData(600)]
    public void A_shove_carries_a_body_by_its_speed_times_its_time_constant(int steps)
    {
        var drift = default(Drift);
        drift.Push(new Vector3(2f, 0f, 0f));
        RootPlace place = RootPlace.Identity;
        for (int i = 0; i < steps; i++)
        {
            place = drift.Carry(place, 6f / steps, 0.3f);
        }

        Assert.Equal(0.6f, place.Position.X, 1e-3f);
    }
}
