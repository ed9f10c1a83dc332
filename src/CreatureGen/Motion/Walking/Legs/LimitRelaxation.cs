using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Footsteps;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>A foot that the joints of its leg do not let lie on the ground as it should: it stands on an edge of its sole, and what of it is on the ground stays where it is: the middle, or the tip of the toes as it rolls off.</summary>
internal static class LimitRelaxation
{
    private const float MinRise = 0.3f;

    /// <summary>Pitch at which a foot stands on nothing but the tip of its toes, radians.</summary>
    private const float Rolled = 0.2f;

    /// <summary>Turns a foot as far as its joints let it.</summary>
    /// <param name="leg">Gives the sole.</param>
    /// <param name="normal">Of the ground under it, unit, model space.</param>
    /// <param name="foot">Turn of the foot from rest that the ankle allows.</param>
    /// <param name="toes">Turn of the toes from rest that the ball allows.</param>
    /// <param name="pitch">Of what it stands on, radians, toes down: rolled off, it stays on the tip of its toes.</param>
    /// <param name="fraction">Share of all this, 0..1: none in the middle of a swing.</param>
    /// <param name="pose">Where the leg has to bring the foot.</param>
    public static void Turn(LegRig leg, Vector3 normal, Quaternion foot, Quaternion toes, float pitch, float fraction, ref FootPose pose)
    {
        float rolled = Scalar.Smooth(pitch / Rolled);
        Vector3 tip = leg.ToeDirection * (leg.Toe - Vec.Dot(leg.SoleMiddle, leg.ToeDirection));
        Vector3 middle = leg.SoleMiddle + (tip * rolled) - new Vector3(0f, leg.BallHeight, 0f);
        Vector3 before = Rotation.Rotate(pose.Toes, middle);
        Vector3 after = Rotation.Rotate(toes, middle);
        float sunk = Lowest(leg, normal, pose.Foot, pose.Toes) - Vec.Dot(normal, before) - Lowest(leg, normal, foot, toes) + Vec.Dot(normal, after);
        Vector3 way = before - after;
        way.Y += sunk / Math.Max(normal.Y, MinRise);
        pose.Ball += way * fraction;
        pose.Foot = UnitRotation.Nlerp(pose.Foot, foot, fraction);
        pose.Toes = UnitRotation.Nlerp(pose.Toes, toes, fraction);
        pose.Target = leg.Traits.Linkage == LegLinkage.Pantograph ? pose.Ball : pose.Ball - Rotation.Rotate(pose.Foot, leg.Metatarsus);
    }

    /// <summary>How far the lowest point of the sole is from the ball along the normal.</summary>
    private static float Lowest(LegRig leg, Vector3 normal, Quaternion foot, Quaternion toes)
    {
        var down = new Vector3(0f, -leg.BallHeight, 0f);
        Vector3 aside = Vec.Cross(leg.ToeDirection, Vector3.UnitY) * leg.HalfWidth;
        float lowest = Vec.Dot(normal, Rotation.Rotate(toes, down + (leg.ToeDirection * leg.Toe)));
        lowest = Math.Min(lowest, Vec.Dot(normal, Rotation.Rotate(toes, down + leg.SoleMiddle + aside)));
        lowest = Math.Min(lowest, Vec.Dot(normal, Rotation.Rotate(toes, down + leg.SoleMiddle - aside)));
        return Math.Min(lowest, Vec.Dot(normal, Rotation.Rotate(foot, down - (leg.ToeDirection * leg.Heel))));
    }
}
