using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Sampling;
using CreatureGen.Tests.Creatures;
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

    /// <summary>One of each plan that walks on legs, at its natural size; feet had gone on stepping for 1.4 s in the median, all of them once more.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(7)]
    [InlineData(8)]
    [InlineData(11, Explicit = true)]
    [InlineData(15, Explicit = true)]
    public void Once_a_runner_has_come_to_rest_its_feet_stand_within_a_second(int seed)
    {
        var profile = new MotionProfile(GrownCreatures.Of(9_920_000 + (ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        var animator = new CreatureAnimator(profile);
        Walkers.Run(animator, 3f, Rate, new MotionInput(profile.Gaits!.Speeds[profile.Gaits.Speeds.Count - 1].Comfortable), FlatGround.Level);
        var places = new Vector3[5 * Rate];
        int lastStep = 0;
        for (int i = 0; i < places.Length; i++)
        {
            animator.Update(1f / Rate, default, FlatGround.Level);
            places[i] = animator.Root.Position;
            foreach (MotionEvent moment in animator.Events)
            {
                lastStep = moment.Kind == MotionEventKind.FootDown ? i : lastStep;
            }
        }

        float near = 0.03f * profile.LegLength;
        int rest = 1 + Array.FindLastIndex(places, place => Vector3.Distance(place, places[places.Length - 1]) > near);
        Assert.True(lastStep - rest < Rate, $"the last foot came down {(lastStep - rest) / (float)Rate} s after the body had come to rest");
    }

    /// <summary>On treads where feet cannot come home, one had stepped on the spot for as long as its body stood.</summary>
    [Theory]
    [InlineData(9970037)]
    [InlineData(9920002, Explicit = true)]
    [InlineData(9920010, Explicit = true)]
    public void Feet_that_have_come_to_rest_on_stairs_do_not_try_again_to_come_home(int seed)
    {
        var profile = new MotionProfile(GrownCreatures.Of((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CourseScript script = CourseScripts.Runner(profile, 8f);
        var simulation = new CourseSimulation(profile, script, CourseGround.Stairs, CourseRate.Of(Rate));
        double seconds = 0;
        int lifted = 0;
        foreach (float dt in simulation.Updates())
        {
            seconds += dt;
            foreach (MotionEvent moment in simulation.Animator.Events)
            {
                lifted += moment.Kind == MotionEventKind.FootUp && seconds > script.Seconds - 1 ? 1 : 0;
            }
        }

        Assert.Equal(0, lifted);
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
                Assert.True(leg.Lateral || MathF.Atan2(aside, leg.HipRest.Y) < leg.Limits.DrawsIn, $"{seed}: {aside} m");
            }
        }
    }
}
