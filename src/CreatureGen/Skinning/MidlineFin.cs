using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>
/// Fins on the back and the belly. Such a fin bends about one joint, but the body below it bends everywhere: only the part within a bone's length of the joint belongs to it,
/// the rest follows the body where it stands.
/// </summary>
internal static class MidlineFin
{
    /// <summary>
    /// The ring (fractional) in whose plane a point of a fin lies. The tip of a swept fin stands over other rings than its base; columns that meet at the tip must move as one.
    /// </summary>
    /// <param name="shape">The sections.</param>
    /// <param name="position">The point, model space.</param>
    /// <param name="start">Ring of the fin's base below the point, where the search starts.</param>
    public static double RingOf(BodyShape shape, Vector3 position, double start)
    {
        int ring = (int)Scalar.Clamp(start, 0, BodyGrid.Rings - 2);
        float here = Ahead(shape, position, ring);
        while (here < 0f && ring < BodyGrid.Rings - 2 && Ahead(shape, position, ring + 1) < 0f)
        {
            here = Ahead(shape, position, ++ring);
        }

        while (here > 0f && ring > 0)
        {
            here = Ahead(shape, position, --ring);
        }

        float next = Ahead(shape, position, ring + 1);
        return ring + Scalar.Clamp(here / (double)Math.Min(here - next, -1e-9f), 0, 1);
    }

    /// <summary>Share of the fin's own joints at an arc length of the spine.</summary>
    public static float HoldAt(Rig rig, Appendage fin, double arc)
    {
        double root = rig.Line.ArcAt(fin.RootRing);
        int bone = rig.Spine.BoneOf(rig.Spine.At(root).Dominant);
        double reach = Math.Max(rig.Spine.End(bone) - rig.Spine.Start(bone), 1e-6);
        return 1f - (float)Scalar.Smooth((Math.Abs(arc - root) / reach) - 0.5);
    }

    /// <summary>How far a point lies ahead of a ring's plane.</summary>
    private static float Ahead(BodyShape shape, Vector3 position, int ring) => Vec.Dot(position - shape.Centre(ring), shape.Forward(ring));
}
