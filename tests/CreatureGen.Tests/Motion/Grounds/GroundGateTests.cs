using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Grounds;
using Xunit;

namespace CreatureGen.Tests.Motion.Grounds;

public sealed class GroundGateTests
{
    [Fact]
    public void Each_update_counts_refused_hits_anew_over_the_same_ground_and_over_another()
    {
        var gate = new GroundGate();
        var lying = new LyingGround();
        foreach (IGround ground in new IGround[] { lying, lying, FlatGround.Level, lying })
        {
            CheckedGround open = gate.Open(ground);
            Assert.Equal(0, gate.Refused);
            open.Cast(Vector3.UnitY, -Vector3.UnitY, 2f, out _);
            Assert.Equal(ground == lying ? 1 : 0, gate.Refused);
        }
    }

    [Fact]
    public void A_ground_comes_in_as_what_it_is_each_time_and_what_it_promises_with_it()
    {
        var gate = new GroundGate();
        var tilted = new FlatGround(Vector3.Zero, Vector3.UnitY);
        var lying = new LyingGround();
        foreach (IGround ground in new IGround[] { tilted, tilted, lying, lying, tilted })
        {
            CheckedGround open = gate.Open(ground);
            Assert.Equal(ground == tilted, open is IPlaneGround);
            Assert.Equal(ground == lying, open.MayThrow);
        }
    }

    /// <summary>Its hits have no normal.</summary>
    private sealed class LyingGround : IGround
    {
        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            hit = default;
            return true;
        }
    }
}
