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

    /// <summary>How far the hind body comes up where its left leg is stretched beyond its reach and its right one is folded.</summary>
    private static float Risen(LeggedBody body, Foot[] feet)
    {
        var room = new LegRoom(body);
        LegRig left = body.Legs[0];
        LegRig right = body.Legs[1];
        Assert.True(left.Row == right.Row);
        room.Add(left, new Vector3(0f, -1.02f * left.Reach, 0f), ref feet[0]);
        room.Add(right, new Vector3(0f, -Math.Max(right.FoldedReach - (0.2f * right.Length), 0.05f * right.Length), 0f), ref feet[1]);
        room.Find(feet, out float hind, out float fore);
        return -(left.IsHind(body.Rows) ? hind : fore);
    }
}
