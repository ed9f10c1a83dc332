using System;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Footsteps;

/// <summary>How far the body comes down, or up, for its legs.</summary>
public sealed class LegRoomTests
{
    /// <summary>At the shore of a lake a leg that was let go in the middle of its stance let the body spring up by .08 leg in one update, and another's knee turned by 256 rad/s.</summary>
    [Fact]
    public void A_stretched_leg_that_is_let_go_in_mid_stance_does_not_let_a_folded_one_raise_the_body_at_once()
    {
        LeggedBody body = new MotionProfile(Walkers.Any(42)).Legs!;
        var feet = new Foot[body.Legs.Length];
        feet[0].Plan.Phase = FootPhase.Stance;
        feet[0].Plan.Stance = 0.3f;
        feet[1].Plan.Phase = FootPhase.Stance;
        feet[1].Plan.Stance = 0.5f;
        float before = Risen(body, feet);
        feet[0].Plan.Phase = FootPhase.Swing;
        float released = Risen(body, feet);
        feet[0].Plan.Swing = 0.1f;
        float soon = Risen(body, feet);
        feet[0].Plan.Swing = 0.4f;
        float late = Risen(body, feet);
        Assert.Equal(before, released, 6);
        Assert.InRange(soon, before, late);
        Assert.True(late > before + (0.02f * body.LegLength), $"risen by {before}, and {late} when the leg is in the air");
    }

    [Fact]
    public void How_quickly_a_hip_leaves_its_foot_is_known_while_that_stands_and_not_by_how_it_came_down()
    {
        LeggedBody body = new MotionProfile(Walkers.Any(42)).Legs!;
        LegRig leg = body.Legs[0];
        var foot = new Foot();
        foot.Plan.Phase = FootPhase.Stance;
        foot.Plan.Arrived = true;
        Add(-0.9f, 0.1f);
        Add(-0.8f, 0.1f);
        Assert.Equal(0f, foot.Leg.Drift.Y);
        foot.Plan.Arrived = false;
        Add(-0.7f, 0.1f);
        Assert.Equal(leg.Reach, foot.Leg.Drift.Y, 4);
        Add(-0.7f, 0f);
        Assert.Equal(leg.Reach, foot.Leg.Drift.Y, 4);
        foot.Leg.Astray = Vector3.UnitX;
        Add(-0.6f, 0.1f);
        Assert.Equal(Vector3.Zero, foot.Leg.Drift);

        void Add(float height, float seconds) => new LegRoom(body).Add(leg, new Vector3(0f, height * leg.Reach, 0f), ref foot, seconds);
    }

    /// <summary>Down stairs a trunk whose front alone came down swung its shoulders back from the feet that they were to come down for.</summary>
    [Fact]
    public void Hind_bodies_come_down_along_with_fore_bodies_as_far_as_the_ground_is_steep()
    {
        LeggedBody body = new MotionProfile(Walkers.Any(42)).Legs!;
        Assert.Equal(2, body.Rows);
        Assert.InRange(Hind(0f, out float level), 0f, 0.2f * level);
        float hind = Hind(0.5f, out float fore);
        Assert.Equal(level, fore, 6);
        Assert.InRange(level, 0.02f * body.LegLength, body.LegLength);
        Assert.Equal(0.5f * fore, hind, 4);

        float Hind(float tilt, out float fore)
        {
            var feet = new Foot[body.Legs.Length];
            var room = new LegRoom(body);
            for (int i = 0; i < feet.Length; i++)
            {
                LegRig leg = body.Legs[i];
                feet[i].Plan.Phase = FootPhase.Stance;
                feet[i].Plan.Stance = 0.5f;
                room.Add(leg, new Vector3(0f, (leg.IsHind(body.Rows) ? -0.8f : -1.04f) * leg.Reach, 0f), ref feet[i], 0f);
            }

            var drop = new LegDrop();
            room.Find(feet, 0f, default, tilt, ref drop, out float hind, out fore);
            return hind;
        }
    }

    /// <summary>How far the hind body comes up where its left leg is stretched beyond its reach and its right one is folded.</summary>
    private static float Risen(LeggedBody body, Foot[] feet)
    {
        var room = new LegRoom(body);
        LegRig left = body.Legs[0];
        LegRig right = body.Legs[1];
        Assert.True(left.Row == right.Row);
        room.Add(left, new Vector3(0f, -1.02f * left.Reach, 0f), ref feet[0], 0f);
        room.Add(right, new Vector3(0f, -Math.Max(right.FoldedReach - (0.2f * right.Length), 0.05f * right.Length), 0f), ref feet[1], 0f);
        var drop = new LegDrop();
        room.Find(feet, 0f, default, 0f, ref drop, out float hind, out float fore);
        return -(left.IsHind(body.Rows) ? hind : fore);
    }
}
