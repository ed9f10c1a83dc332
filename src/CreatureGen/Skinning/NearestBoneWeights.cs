using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>
/// Skin weights by distance, as in the thesis: every vertex is bound to its four nearest bones, the nearer the more. Kept for comparison; <see cref="AnatomicalWeights"/> is the default.
/// </summary>
/// <remarks>
/// Distance alone would tie a left leg to the right one and a curled tail to the head. So only bones that the surface connects are asked: of a limb's vertex the limb's own bones and those
/// that move its socket; of the body's vertices the bones of the spine no more than two further along, the jaw below the mouth slit, and the thighs of limbs whose socket is at most two edges away.
/// A vertex on the midline asks no limb. Weights fall with the square of the distance to the bone's segment.
/// </remarks>
internal static class NearestBoneWeights
{
    /// <summary>Bones of the spine on either side of a vertex's own that are asked.</summary>
    private const int SpineReach = 2;

    /// <summary>Least distance, in lengths of the whole spine, so that a vertex on a bone has a finite weight.</summary>
    private const double LeastDistance = 1e-4;

    /// <summary>One set of influences per vertex of the surface.</summary>
    /// <param name="input">The surface and its anatomy, at scale 1.</param>
    /// <param name="rig">The rig built from it.</param>
    public static SkinWeights[] Solve(RigInput input, Rig rig)
    {
        Surface surface = input.Surface;
        var spread = SocketSpread.Measure(surface, input.Adjacency, input.Appendages);
        float[] jaw = MouthWeights.Solve(surface, input.Adjacency, input.Mouth);
        float least = (float)(LeastDistance * rig.Line.Length);
        var weights = new SkinWeights[surface.Positions.Length];
        var list = new InfluenceList(stackalloc int[InfluenceList.Capacity], stackalloc float[InfluenceList.Capacity]);
        for (int v = 0; v < weights.Length; v++)
        {
            VertexAddress address = surface.Addresses[v];
            if (address.Sign < 0)
            {
                continue;
            }

            list.Clear();
            Vector3 p = surface.Positions[v];
            SpineBlend body = rig.Spine.At(rig.Line.ArcAt(address.Ring));
            if (address.Appendage >= 0)
            {
                int[] joints = rig.Appendages[address.Appendage].Left;
                int first = input.Appendages[address.Appendage].Kind is LimbKind.Leg or LimbKind.Arm ? 1 : 0;
                for (int k = first; k < joints.Length - 1; k++)
                {
                    Ask(ref list, rig.Skeleton, joints[k], p, least);
                }

                Ask(ref list, rig.Skeleton, body.First, p, least);
                if (body.Second != body.First)
                {
                    Ask(ref list, rig.Skeleton, body.Second, p, least);
                }
            }
            else if (jaw.Length > 0 && jaw[v] > 0.5f)
            {
                list.Add(rig.Jaw, 1f);
            }
            else
            {
                AskSpine(ref list, rig, body.Dominant, p, least);
                AskLimbs(ref list, input, rig, spread, v, p, least);
            }

            weights[v] = list.ToWeights();
        }

        SkinMirror.Complete(surface, rig.Skeleton, weights);
        return weights;
    }

    private static void AskSpine(ref InfluenceList list, Rig rig, int joint, Vector3 p, float least)
    {
        int own = rig.Spine.BoneOf(joint);
        for (int bone = Math.Max(own - SpineReach, 0); bone <= own + SpineReach && bone < rig.Spine.Joints.Length; bone++)
        {
            Ask(ref list, rig.Skeleton, rig.Spine.Joints[bone], p, least);
        }
    }

    private static void AskLimbs(ref InfluenceList list, RigInput input, Rig rig, SocketSpread spread, int vertex, Vector3 p, float least)
    {
        if (input.Surface.Mirror[vertex] == vertex)
        {
            return;
        }

        for (int e = spread.First(vertex); e >= 0; e = spread.Next(e))
        {
            int a = spread.Appendage(e);
            int root = input.Appendages[a].Kind is LimbKind.Leg or LimbKind.Arm ? 1 : 0;
            Ask(ref list, rig.Skeleton, rig.Appendages[a].Left[root], p, least);
        }
    }

    private static void Ask(ref InfluenceList list, Skeleton skeleton, int joint, Vector3 p, float least)
    {
        Vector3 start = skeleton.ModelPositions[joint];
        Vector3 along = Rotation.Rotate(skeleton.ModelRotations[joint], Vector3.UnitY) * skeleton.Joints[joint].Length;
        float squared = Vec.LengthSquared(along);
        float t = squared > 0f ? Scalar.Clamp(Vec.Dot(p - start, along) / squared, 0f, 1f) : 0f;
        float distance = Math.Max(Vec.Distance(p, start + (along * t)), least);
        list.Add(joint, 1f / (distance * distance));
    }
}
