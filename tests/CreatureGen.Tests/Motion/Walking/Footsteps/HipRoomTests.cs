using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Footsteps;

/// <summary>What is foreseen of a hip between two poses.</summary>
public sealed class HipRoomTests
{
    [Fact]
    public void No_leg_misses_the_place_at_which_it_stands_at_rest() =>
        Assert.All(Legs(), pair => Assert.InRange(HipRoom.Miss(pair.Body, pair.Leg, Quaternion.Identity, Rest(pair.Leg)), 0f, 0.03f * pair.Leg.Length));

    [Fact]
    public void No_leg_out_to_the_side_goes_all_the_way_round_its_hip()
    {
        foreach ((LeggedBody body, LegRig leg) in Legs())
        {
            float most = Enumerable.Range(-6, 13).Max(i => HipRoom.Miss(body, leg, Quaternion.Identity, Rotation.Rotate(AxisRotation.Yaw(0.5f * i), Rest(leg))));
            Assert.InRange(most, 0.1f * leg.Length, 3f * leg.Length);
        }
    }

    [Fact]
    public void A_folded_leg_that_keeps_its_bend_goes_no_farther_round_its_hip_than_a_stretched_one()
    {
        foreach ((LeggedBody body, LegRig leg) in Legs())
        {
            float most = Enumerable.Range(-6, 13).Max(i => HipRoom.Miss(body, leg, Quaternion.Identity, Rotation.Rotate(AxisRotation.Yaw(0.5f * i), Rest(leg)) * (0.45f * leg.Reach / Vec.Length(Rest(leg)))));
            Assert.InRange(most, 0.1f * leg.Length, 2f * leg.Length);
        }
    }

    [Fact]
    public void A_leg_ends_as_far_from_a_place_as_it_misses_it_and_hardly_misses_where_it_ends()
    {
        foreach ((LeggedBody body, LegRig leg) in Legs())
        {
            foreach (float yaw in new[] { -1.2f, 0.8f })
            {
                Vector3 chord = Rotation.Rotate(AxisRotation.Yaw(yaw), Rest(leg));
                float miss = HipRoom.Miss(body, leg, Quaternion.Identity, chord);
                Vector3 end = HipRoom.Nearest(body, leg, Quaternion.Identity, chord, Quaternion.Identity);
                Assert.True(end == chord || Math.Abs(Vec.Distance(end, chord) - miss) < 1e-5f * leg.Length);
                Assert.InRange(HipRoom.Miss(body, leg, Quaternion.Identity, end), 0f, Math.Max(0.25f * miss, 0.03f * leg.Length));
            }
        }
    }

    [Fact]
    public void A_hip_on_a_turned_trunk_reaches_what_is_turned_with_it()
    {
        Quaternion carrier = AxisRotation.Yaw(0.7f);
        Assert.All(Legs(), pair => Assert.Equal(
            HipRoom.Miss(pair.Body, pair.Leg, Quaternion.Identity, Rotation.Rotate(AxisRotation.Yaw(0.9f), Rest(pair.Leg))),
            HipRoom.Miss(pair.Body, pair.Leg, carrier, Rotation.Rotate(AxisRotation.Yaw(1.6f), Rest(pair.Leg))),
            0.002f * pair.Leg.Length));
    }

    [Fact]
    public void Left_and_right_miss_mirrored_places_alike()
    {
        foreach (IGrouping<LeggedBody, (LeggedBody Body, LegRig Leg)> legs in Legs().GroupBy(pair => pair.Body))
        {
            foreach (LegRig left in legs.Select(pair => pair.Leg).Where(leg => leg.Side == Side.Left))
            {
                LegRig right = legs.Select(pair => pair.Leg).Single(leg => leg.Side == Side.Right && leg.Row == left.Row);
                for (float yaw = -1.8f; yaw <= 1.8f; yaw += 0.3f)
                {
                    float one = HipRoom.Miss(legs.Key, left, Quaternion.Identity, Rotation.Rotate(AxisRotation.Yaw(yaw), Rest(left)));
                    float other = HipRoom.Miss(legs.Key, right, Quaternion.Identity, Rotation.Rotate(AxisRotation.Yaw(-yaw), Rest(right)));
                    Assert.Equal(one, other, 0.002f * left.Length);
                }
            }
        }
    }

    private static Vector3 Rest(LegRig leg) => leg.Parts.Upper + leg.Shank;

    private static IEnumerable<(LeggedBody Body, LegRig Leg)> Legs() =>
        from plan in new[] { BodyPlan.Sprawling, BodyPlan.Hexapod }
        from seed in Enumerable.Range(1, 4)
        let body = new MotionProfile(Walkers.Of(plan, (ulong)seed)).Legs!
        from leg in body.Legs
        where leg.Lateral
        select (body, leg);
}
