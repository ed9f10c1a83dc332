using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Maths;
using CreatureGen.Motion.Swimming;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Preview.Rendering;

/// <summary>The moment of the stroke of a tail that a portrait shows: its fin trails behind the body, so that it shows its whole side to who stands beside it and its edge to who stands behind.</summary>
internal static class MomentOfStroke
{
    // Moments of a stroke that are compared, and how much a fluke that is raised is liked better than one that hangs.
    private const int Moments = 24;
    private const float Raised = 0.5f;

    // Share of a body that is taken for the end of its tail, and of what winds: its waves are short.
    private const float OfFin = 0.11f;
    private const float OfWindingFin = 0.2f;

    // Slope towards the line of the body of a fin that turns its edge to who stands behind, for each body length that it is off that line.
    private const float Inwards = 0.8f;
    private const float InwardsWinding = 0.4f;

    /// <summary>The moment as a part of the stroke.</summary>
    /// <param name="swim">How the creature swims.</param>
    /// <param name="tail">How its tail ends: one without a fin is shown as it crosses the line of the body, for bent aside it is a hook from behind.</param>
    /// <param name="clip">Its stroke.</param>
    /// <param name="local">Room for a pose.</param>
    public static float Of(SwimProfile swim, TailStyle tail, Clip clip, in Pose local)
    {
        Skeleton skeleton = swim.Skeleton;
        bool bare = tail == TailStyle.Plain || TailTaper.Of(tail) != null;
        float inwards = swim.Style == SwimStyle.Anguilliform ? InwardsWinding : Inwards;
        int last = swim.Chain.Bones[swim.Chain.Count - 1].Turn.Joint;
        var model = new Pose(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);
        float best = 0f;
        float least = float.MaxValue;
        for (int i = 0; i < Moments; i++)
        {
            float part = i / (float)Moments;
            clip.Sample(part * clip.Duration, local);
            ForwardKinematics.LocalToModel(skeleton, local, model);
            Vector3 back = Trailing(swim, model);
            Vector3 moved = (model.Positions[last] - skeleton.ModelPositions[last]) / swim.BodyLength;
            float off = swim.IsVertical ? Math.Abs(back.Y) - (Raised * moved.Y) : bare ? Math.Abs(moved.X) : Math.Abs(back.X + (inwards * moved.X));
            (best, least) = off < least ? (part, off) : (best, least);
        }

        return best;
    }

    /// <summary>Where the bones in the end of the tail point on average, backwards at rest.</summary>
    private static Vector3 Trailing(SwimProfile swim, in Pose model)
    {
        ReadOnlySpan<AxialBone> bones = swim.Chain.Bones;
        float fin = swim.BodyLength * (swim.Style == SwimStyle.Anguilliform ? OfWindingFin : OfFin);
        Vector3 sum = Vector3.Zero;
        for (int b = bones.Length - 1; b == bones.Length - 1 || bones[b].Middle.Z - swim.Chain.TailTip.Z < fin; b--)
        {
            int joint = bones[b].Turn.Joint;
            sum -= Rotation.Rotate(Rotation.Multiply(model.Rotations[joint], Rotation.Inverse(swim.Skeleton.ModelRotations[joint])), Vector3.UnitZ);
        }

        return Vec.Normalize(sum, -Vector3.UnitZ);
    }
}
