using System;
using System.Numerics;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Poses;

/// <summary>
/// A foot that the joints of its leg do not let lie on the ground as it should: it stands on an edge of its sole, and on level ground what of the sole is down stays where it would be if the foot lay as it should.
/// So it does not slip, whichever edge it comes to stand on.
/// </summary>
internal static class LimitRelaxation
{
    private const float MinRise = 0.3f;

    /// <summary>Pitch at which a foot stands on nothing but the tip of its toes, radians.</summary>
    private const float Rolled = 0.2f;

    /// <summary>Height above the lowest point of the sole at which another counts half as much as it, leg lengths: as a foot rolls from one edge to the next its hold goes over softly.</summary>
    private const float Touch = 0.02f;

    /// <summary>Up part of the normal of ground on which a foot holds on to the edge that it stands on, wholly and not at all: 1° and 4°.</summary>
    private const float Level = 0.99985f;
    private const float Slanting = 0.9976f;

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
        Span<Vector3> before = stackalloc Vector3[SoleExtent.Directions];
        Span<Vector3> after = stackalloc Vector3[SoleExtent.Directions];
        float lowest = Lay(leg, normal, foot, toes, after);
        float sunk = Lay(leg, normal, pose.Foot, pose.Toes, before) - lowest;

        // A foot that follows its leg turns on the middle of its sole, or on its toes as it rolls off; so does one that stands aslant for all of its stance.
        Vector3 pivot = Pivot(leg, pitch);
        Vector3 way = Rotation.Rotate(pose.Toes, pivot) - Rotation.Rotate(toes, pivot);
        float level = leg.Follows ? 0f : Scalar.Smooth((normal.Y - Slanting) / (Level - Slanting));
        if (level > 0f)
        {
            way = Vec.Lerp(way, Hold(before, after, normal, lowest, Touch * leg.Length), level);
        }

        way.Y += (sunk - Vec.Dot(normal, way)) / Math.Max(normal.Y, MinRise);
        pose.Ball += way * fraction;
        pose.Foot = UnitRotation.Nlerp(pose.Foot, foot, fraction);
        pose.Toes = UnitRotation.Nlerp(pose.Toes, toes, fraction);
        pose.Target = leg.Traits.Linkage == LegLinkage.Pantograph ? pose.Ball : pose.Ball - Rotation.Rotate(pose.Foot, leg.Metatarsus);
    }

    /// <summary>How far the ball has to go for what touches the ground to stay where it was.</summary>
    private static Vector3 Hold(ReadOnlySpan<Vector3> before, ReadOnlySpan<Vector3> after, Vector3 normal, float lowest, float touch)
    {
        Vector3 way = default;
        float sum = 0f;
        for (int i = 0; i < after.Length; i++)
        {
            float above = (Vec.Dot(normal, after[i]) - lowest) / touch;
            float weight = 1f / (1f + (above * above));
            weight *= weight;
            way += (before[i] - after[i]) * weight;
            sum += weight;
        }

        return way / sum;
    }

    /// <summary>From the ball to what a foot turns on, at rest: the middle of its sole, or the tip of its toes.</summary>
    private static Vector3 Pivot(LegRig leg, float pitch)
    {
        Vector3 tip = leg.ToeDirection * (leg.Toe - Vec.Dot(leg.SoleMiddle, leg.ToeDirection));
        return leg.SoleMiddle + (tip * Scalar.Smooth(pitch / Rolled)) - new Vector3(0f, leg.BallHeight, 0f);
    }

    /// <summary>Where the outline of the sole is from the ball: ahead of it with the toes, behind it with the foot.</summary>
    /// <returns>How far the lowest of it is along the normal.</returns>
    private static float Lay(LegRig leg, Vector3 normal, Quaternion foot, Quaternion toes, Span<Vector3> points)
    {
        float lowest = float.MaxValue;
        for (int i = 0; i < points.Length; i++)
        {
            Vector3 place = leg.Sole[i];
            points[i] = Rotation.Rotate(Vec.Dot(place, leg.ToeDirection) < 0f ? foot : toes, place);
            lowest = Math.Min(lowest, Vec.Dot(normal, points[i]));
        }

        return lowest;
    }
}
