using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Swimming;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Preview.Scenes;
using CreatureGen.Rigging;

namespace CreatureGen.Preview.Rendering;

/// <summary>The moment of its motion in which a creature has its portrait taken.</summary>
internal static class MomentOfMotion
{
    // Parts of a cycle: a foot is in the air while another stands ahead; fins that row are up, on their way down; the wings are at their highest.
    private const float OfStep = 0.3f;
    private const float OfRow = 0.15f;
    private const float OfBeat = 0f;

    // Moments of a stroke of the tail that are compared, and how much a tail that is raised is liked better than one that hangs.
    private const int Moments = 24;
    private const float Raised = 0.5f;

    // Share of a body that is taken for the end of its tail, and of what winds: its waves are short.
    private const float OfFin = 0.11f;
    private const float OfWindingFin = 0.2f;

    // Slope towards the line of the body of a fin that turns its edge to who stands behind, for each body length that it is off that line.
    private const float Inwards = 0.8f;
    private const float InwardsWinding = 0.4f;

    /// <summary>The surface in mid-step, in mid-stroke, at the top of its wings' beat, in the bends of its crawl; as it was built where it does not go.</summary>
    public static RenderMesh Of(Creature creature)
    {
        var profile = new MotionProfile(creature);
        IReadOnlyList<Movement> ways = Movement.OfGoing(profile);
        Movement? way = ways.FirstOrDefault(one => one is { Kind: ClipKind.Lasting, Gait: null, Input.Speed: > 0f }) ?? ways.FirstOrDefault(one => one.Gait != null);
        if (way is null)
        {
            return RenderMesh.From(creature);
        }

        Clip clip = ClipBaker.Bake(profile, way);
        var local = new Pose(new Quaternion[creature.Skeleton.Count], new Vector3[creature.Skeleton.Count]);
        clip.Sample(PartOf(way, profile, creature, clip, local) * clip.Duration, local);
        (Vector3[] positions, Vector3[] normals) = MovedSkin.Of(creature, RootPlace.Identity, local, RootPlace.Identity);
        return RenderMesh.From(creature, positions, normals);
    }

    private static float PartOf(Movement way, MotionProfile profile, Creature creature, Clip clip, in Pose local)
    {
        if (way.Input.Medium == MotionMedium.Air)
        {
            return OfBeat;
        }

        return profile.Swim is not { } swim ? OfStep : swim.IsStiff ? OfRow : OfStroke(swim, clip, local, creature.Blueprint.Tail.Style == TailStyle.Plain || TailTaper.Of(creature.Blueprint.Tail.Style) != null);
    }

    /// <summary>The part of a stroke in which the end of the tail, out to the side or up, trails behind the body: its fin shows its whole side to who stands beside it and its edge to who stands behind.</summary>
    private static float OfStroke(SwimProfile swim, Clip clip, in Pose local, bool bare)
    {
        Skeleton skeleton = swim.Skeleton;
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
            float turned = swim.IsVertical ? Math.Abs(back.Y) - (Raised * moved.Y) : bare ? Math.Abs(moved.X) : Math.Abs(back.X + ((swim.Style == SwimStyle.Anguilliform ? InwardsWinding : Inwards) * moved.X));
            (best, least) = turned < least ? (part, turned) : (best, least);
        }

        return best;
    }

    /// <summary>Where the bones in the end of the tail point on average, backwards at rest.</summary>
    private static Vector3 Trailing(SwimProfile swim, in Pose model)
    {
        Vector3 sum = Vector3.Zero;
        float fin = swim.BodyLength * (swim.Style == SwimStyle.Anguilliform ? OfWindingFin : OfFin);
        foreach (AxialBone bone in swim.Chain.Bones)
        {
            if (bone.Middle.Z - swim.Chain.TailTip.Z < fin)
            {
                int joint = bone.Turn.Joint;
                sum -= Rotation.Rotate(Rotation.Multiply(model.Rotations[joint], Rotation.Inverse(swim.Skeleton.ModelRotations[joint])), Vector3.UnitZ);
            }
        }

        return Vec.Normalize(sum, -Vector3.UnitZ);
    }
}
