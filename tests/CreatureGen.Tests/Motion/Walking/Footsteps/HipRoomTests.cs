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
        Assert.All(Legs(), pair => Assert.InRange(HipRoom.Miss(pair.Body, pair.Leg, Rest(pair.Leg), Quaternion.Identity), 0f, 0.03f * pair.Leg.Length));

    [Fact]
    public void No_leg_out_to_the_side_goes_all_the_way_round_its_hip()
    {
        foreach ((LeggedBody body, LegRig leg) in Legs())
        {
            float most = Enumerable.Range(-6, 13).Max(i => HipRoom.Miss(body, leg, Rotation.Rotate(AxisRotation.Yaw(0.5f * i), Rest(leg)), Quaternion.Identity));
            Assert.InRange(most, 0.1f * leg.Length, 3f * leg.Length);
        }
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
                    float one = HipRoom.Miss(legs.Key, left, Rotation.Rotate(AxisRotation.Yaw(yaw), Rest(left)), Quaternion.Identity);
                    float other = HipRoom.Miss(legs.Key, right, Rotation.Rotate(AxisRotation.Yaw(-yaw), Rest(right)), Quaternion.Identity);
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
