using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Pace;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Pace;

public sealed class FootInterferenceTests
{
    [Fact]
    public void In_a_tripod_a_stance_is_no_longer_than_from_one_foot_of_a_side_to_the_next()
    {
        foreach (LeggedBody body in Bodies(BodyPlan.Hexapod, 12).Where(body => body.Rows == 3))
        {
            float stance = FootInterference.LongestStance(body, GaitLibrary.Tripod);
            Assert.True(stance > 0.25f * body.LegLength);
            foreach ((LegRig hind, LegRig fore, float distance) in Neighbours(body))
            {
                Assert.True(stance <= Math.Max(distance, 0.35f * hind.Length), $"{stance} m of {distance} m between {hind.Row} and {fore.Row}");
            }
        }
    }

    [Fact]
    public void Feet_that_are_tucked_up_or_alone_on_their_side_bind_no_stance()
    {
        Assert.All(Bodies(BodyPlan.Hexapod, 4), body => Assert.Equal(float.MaxValue, FootInterference.LongestStance(body, GaitLibrary.Leap)));
        Assert.All(Bodies(BodyPlan.Theropod, 4), body => Assert.Equal(float.MaxValue, FootInterference.LongestStance(body, GaitLibrary.BipedRun)));
    }

    [Fact]
    public void Waves_to_the_rear_leave_neighbouring_feet_longer_stances_and_crowded_feet_choose_them()
    {
        int crowded = 0;
        foreach (LeggedBody body in Bodies(BodyPlan.ManyLegged, 12))
        {
            Assert.True(FootInterference.LongestStance(body, GaitLibrary.BackwardWave) > FootInterference.LongestStance(body, GaitLibrary.Wave));
            bool bound = SlopeStance.OnLevel(body, GaitLibrary.Wave) < SlopeStance.OnLevel(body, GaitLibrary.BackwardWave);
            Assert.Equal(bound ? "BackwardWave" : "Wave", new MotionProfile(body.Subject).Gaits!.Speeds[0].Gait.Name);
            crowded += bound ? 1 : 0;
        }

        Assert.InRange(crowded, 1, 11);
        Assert.All(Bodies(BodyPlan.Hexapod, 8).Where(body => body.Rows == 3), body => Assert.Equal("Wave", new MotionProfile(body.Subject).Gaits!.Speeds[0].Gait.Name));
    }

    [Fact]
    public void Feet_between_the_outer_pairs_are_no_nearer_to_one_neighbour_than_at_rest()
    {
        foreach (LeggedBody body in Bodies(BodyPlan.Hexapod, 12).Concat(Bodies(BodyPlan.ManyLegged, 6)).Where(body => body.Rows == 3))
        {
            float rest = Neighbours(body, leg => leg.Gathered).Min(pair => pair.Distance);
            float going = Neighbours(body).Min(pair => pair.Distance);
            Assert.True(going >= rest - 1e-5f, $"{going} m, {rest} m at rest");
        }
    }

    [Fact]
    public void Homes_of_left_and_right_feet_are_mirrored()
    {
        foreach (BodyPlan plan in new[] { BodyPlan.Hexapod, BodyPlan.Sprawling, BodyPlan.Theropod })
        {
            foreach (LeggedBody body in Bodies(plan, 4))
            {
                for (int i = 0; i < body.Legs.Length; i++)
                {
                    int other = Array.FindIndex(body.Legs, leg => leg.Row == body.Legs[i].Row && leg.Side != body.Legs[i].Side);
                    Vector3 mirrored = body.GoingHomes[other] * new Vector3(-1f, 1f, 1f);
                    Assert.True(Vector3.Distance(body.GoingHomes[i], mirrored) < 1e-4f * body.LegLength);
                }
            }
        }
    }

    [Fact]
    public void Tracks_are_as_wide_as_feet_that_go_past_each_other_and_the_higher_they_go_the_narrower()
    {
        foreach (LegRig leg in Bodies(BodyPlan.Theropod, 8).Concat(Bodies(BodyPlan.Plantigrade, 8)).SelectMany(body => body.Legs))
        {
            float aside = Math.Abs(leg.Gathered.X);
            Assert.True(leg.Track(0f, 0f) * aside >= Math.Min(leg.Breadth, aside) - 1e-6f);
            Assert.True(leg.Track(0f, 0f) <= 1f + 1e-6f);
            Assert.True(leg.Track(0f, 1.4f) <= leg.Track(0f, 0.9f));
            Assert.True(leg.Track(0f, 100f) == leg.MinTrack || leg.MinTrack < 0f);
            Assert.Equal(1.2f, leg.Track(1.2f, 1f));
        }
    }

    private static IEnumerable<LeggedBody> Bodies(BodyPlan plan, int count) =>
        Enumerable.Range(9000, count).Select(seed => new MotionProfile(Walkers.Of(plan, (ulong)seed)).Legs).OfType<LeggedBody>();

    private static IEnumerable<(LegRig Hind, LegRig Fore, float Distance)> Neighbours(LeggedBody body) =>
        Neighbours(body, leg => body.GoingHomes[Array.IndexOf(body.Legs, leg)]);

    private static IEnumerable<(LegRig Hind, LegRig Fore, float Distance)> Neighbours(LeggedBody body, Func<LegRig, Vector3> home) =>
        from hind in body.Legs
        from fore in body.Legs
        where fore.Row == hind.Row + 1 && fore.Side == hind.Side
        select (hind, fore, home(fore).Z - home(hind).Z);
}
