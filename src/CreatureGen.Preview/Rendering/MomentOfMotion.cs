using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
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

    /// <summary>The surface in mid-step, in mid-stroke, at the top of its wings' beat, in the bends of its crawl; as it was built where it does not go.</summary>
    /// <param name="creature">The creature.</param>
    /// <param name="held">Joints that stay as they were built, if any: wings, to who looks along the body and would see no more of beating ones than their edges.</param>
    public static RenderMesh Of(Creature creature, JointRole? held = null)
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
        SetToRest(held, creature.Skeleton, local);
        (Vector3[] positions, Vector3[] normals) = MovedSkin.Of(creature, RootPlace.Identity, local, RootPlace.Identity);
        return RenderMesh.From(creature, positions, normals);
    }

    private static void SetToRest(JointRole? role, Skeleton skeleton, in Pose local)
    {
        for (int joint = 0; joint < skeleton.Count; joint++)
        {
            if (skeleton.Joints[joint].Role == role)
            {
                local.Rotations[joint] = skeleton.LocalRotations[joint];
                local.Positions[joint] = skeleton.LocalPositions[joint];
            }
        }
    }

    private static float PartOf(Movement way, MotionProfile profile, Creature creature, Clip clip, in Pose local)
    {
        if (way.Input.Medium == MotionMedium.Air)
        {
            return OfBeat;
        }

        return profile.Swim is not { } swim ? OfStep : swim.IsStiff ? OfRow : MomentOfStroke.Of(swim, creature.Blueprint.Tail.Style, clip, local);
    }
}
