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
        float lowest = SoleEdge.Lay(leg, normal, foot, toes, after);
        float sunk = SoleEdge.Lay(leg, normal, pose.Foot, pose.Toes, before) - lowest;

        // It holds on to the edge that it stands on as far as the ground lets it, and turns on a point of its sole for the rest.
        Vector3 way = SolePivot.Way(leg, pose.Toes, toes, pitch);
        float held = SoleEdge.Weight(leg, normal);
        if (held > 0f)
        {
            way = Vec.Lerp(way, SoleEdge.Way(leg, before, after, normal, lowest), held);
        }

        way.Y += (sunk - Vec.Dot(normal, way)) / Math.Max(normal.Y, MinRise);
        pose.Ball += way * fraction;
        pose.Foot = UnitRotation.Nlerp(pose.Foot, foot, fraction);
        pose.Toes = UnitRotation.Nlerp(pose.Toes, toes, fraction);
        pose.Target = leg.Traits.Linkage == LegLinkage.Pantograph ? pose.Ball : pose.Ball - Rotation.Rotate(pose.Foot, leg.Metatarsus);
    }
}
