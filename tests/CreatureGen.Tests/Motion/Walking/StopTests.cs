using System;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

public sealed class StopTests
{
    private const int Rate = 60;

    /// <summary>Birds on wide hips, frogs that go over from leaps to their crawl, and a newt and turtles that took their weight farther aside than their legs reach.</summary>
    [Theory]
    [InlineData(130)]
    [InlineData(210, Explicit = true)]
    [InlineData(284, Explicit = true)]
    [InlineData(2161, Explicit = true)]
    [InlineData(2196, Explicit = true)]
    [InlineData(6, Explicit = true)]
    [InlineData(2033, Explicit = true)]
    [InlineData(7253, Explicit = true)]
    [InlineData(7286, Explicit = true)]
    [InlineData(2175, Explicit = true)]
    [InlineData(2245, Explicit = true)]
    [InlineData(7172)]
    public void A_walker_that_stops_from_its_top_speed_keeps_to_the_limits_of_its_joints(int seed)
    {
        var profile = new MotionProfile(Walkers.Any((ulong)seed));
        for (int place = 0; place < 6; place++)
        {
            var animator = new CreatureAnimator(profile);
            Walkers.Run(animator, 4f + (0.13f * place), Rate, new MotionInput(profile.Gaits!.TopSpeed), FlatGround.Level);
            MotionReport report = Walkers.Measure(animator, (int)(3 * Rate), Rate, default, FlatGround.Level);
            Assert.True(report.LimitExcess < 0.005f, $"{report.LimitExcess} rad of joint {report.WorstJoint}, stopped at place {place}");
        }
    }

    [Fact]
    public void A_body_sways_no_farther_than_its_hips_draw_their_legs_in()
    {
        for (ulong seed = 0; seed < 60; seed++)
        {
            if (new MotionProfile(Walkers.Any(seed)).Legs is not LeggedBody body)
            {
                continue;
            }

            foreach (LegRig leg in body.Legs)
            {
                float aside = body.MaxSway + ((1f - leg.MinTrack) * Math.Abs(leg.Home.X));
                Assert.True(leg.Lateral || MathF.Atan2(aside, leg.HipRest.Y) < leg.DrawsIn, $"{seed}: {aside} m");
            }
        }
    }
}
