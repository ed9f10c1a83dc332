using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>
/// Skin weights by distance, as in the thesis: every vertex is bound to its four nearest bones, the nearer the more, for any mesh and any skeleton. Grown creatures are bound by their anatomy instead, since distance alone folds skin.
/// </summary>
/// <remarks>
/// Of any mesh, all bones are asked. In grown creatures distance alone would tie a left leg to the right one and a curled tail to the head. So only bones that the surface connects are asked: of a limb's vertex the limb's own bones and those
/// that move its socket; of the body's vertices the bones of the spine no more than two further along, the jaw below the mouth slit, and the thighs of limbs whose socket is at most two edges away.
/// A vertex on the midline asks no limb. Weights fall with the square of the distance to the bone's segment.
/// </remarks>
public static class NearestBoneWeights
{
    /// <summary>Bones of the spine on either side of a vertex's own that are asked.</summary>
    private const int SpineReach = 2;

    /// <summary>Least distance, in lengths of the whole spine, so that a vertex on a bone has a finite weight.</summary>
    private const double MinDistance = 1e-4;

    /// <summary>Binds the vertices of any mesh.</summary>
    /// <param name="positions">Vertices in the skeleton's rest pose, model space, metres.</param>
    /// <param name="skeleton">Its bones go from joints to their main children; joints without children are bones of no length, end joints none.</param>
    /// <returns>The four nearest bones of each vertex, weighted by the inverse square of the distance.</returns>
    /// <exception cref="ArgumentNullException">There is no skeleton.</exception>
    /// <exception cref="ArgumentException">A position is not finite.</exception>
    public static SkinWeights[] Solve(ReadOnlySpan<Vector3> positions, Skeleton skeleton)
    {
        int[] bones = BonesOf(skeleton ?? throw new ArgumentNullException(nameof(skeleton)));
        float size = 0f;
        foreach (Vector3 p in skeleton.ModelPositions)
        {
            size = Math.Max(size, Vec.Distance(p, skeleton.ModelPositions[0]));
        }

        float min = Math.Max((float)MinDistance * size, 1e-9f);
        var weights = new SkinWeights[positions.Length];
        var list = new InfluenceList(stackalloc int[InfluenceList.Capacity], stackalloc float[InfluenceList.Capacity]);
        Span<int> nearest = stackalloc int[4];
        Span<float> fractions = stackalloc float[4];
        for (int v = 0; v < weights.Length; v++)
        {
            Finite.Require(positions[v], nameof(positions));
            int found = 0;
            foreach (int bone in bones)
            {
                float distance = Distance(skeleton, bone, positions[v], min);
                float fraction = 1f / (distance * distance);
                if (found == 4 && fraction <= fractions[3])
                {
                    continue;
                }

                int at = found < 4 ? found++ : 3;
                while (at > 0 && fractions[at - 1] < fraction)
                {
                    (fractions[at], nearest[at]) = (fractions[at - 1], nearest[at - 1]);
                    at--;
                }

                (fractions[at], nearest[at]) = (fraction, bone);
            }

            list.Clear();
            for (int k = 0; k < found; k++)
            {
                list.Add(nearest[k], fractions[k]);
            }

            fractions.Clear();
            weights[v] = list.ToWeights();
        }

        return weights;
    }

    /// <summary>One set of influences per vertex of the surface.</summary>
    /// <param name="input">The surface and its anatomy, at scale 1.</param>
    /// <param name="rig">The rig built from it.</param>
    internal static SkinWeights[] Solve(RigInput input, Rig rig)
    {
        Surface surface = input.Surface;
        var spread = SocketSpread.Measure(surface, input.Adjacency, input.Appendages);
        float[] jaw = MouthWeights.Solve(surface, input.Adjacency, input.Mouth);
        float min = (float)(MinDistance * rig.Line.Length);
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
                    Ask(ref list, rig.Skeleton, joints[k], p, min);
                }

                Ask(ref list, rig.Skeleton, body.First, p, min);
                if (body.Second != body.First)
                {
                    Ask(ref list, rig.Skeleton, body.Second, p, min);
                }
            }
            else if (jaw.Length > 0 && jaw[v] > 0.5f)
            {
                list.Add(rig.Jaw, 1f);
            }
            else
            {
                AskSpine(ref list, rig, body.Dominant, p, min);
                AskLimbs(ref list, input, rig, spread, v, p, min);
            }

            weights[v] = list.ToWeights();
        }

        SkinMirror.Complete(surface, rig.Skeleton, weights);
        return weights;
    }

    private static void AskSpine(ref InfluenceList list, Rig rig, int joint, Vector3 p, float min)
    {
        int own = rig.Spine.BoneOf(joint);
        for (int bone = Math.Max(own - SpineReach, 0); bone <= own + SpineReach && bone < rig.Spine.Joints.Length; bone++)
        {
            Ask(ref list, rig.Skeleton, rig.Spine.Joints[bone], p, min);
        }
    }

    private static void AskLimbs(ref InfluenceList list, RigInput input, Rig rig, SocketSpread spread, int vertex, Vector3 p, float min)
    {
        if (input.Surface.Mirror[vertex] == vertex)
        {
            return;
        }

        for (int e = spread.First(vertex); e >= 0; e = spread.Next(e))
        {
            int a = spread.Appendage(e);
            int root = input.Appendages[a].Kind is LimbKind.Leg or LimbKind.Arm ? 1 : 0;
            Ask(ref list, rig.Skeleton, rig.Appendages[a].Left[root], p, min);
        }
    }

    private static int[] BonesOf(Skeleton skeleton)
    {
        bool[] carries = new bool[skeleton.Count];
        foreach (int parent in skeleton.Parents)
        {
            if (parent >= 0)
            {
                carries[parent] = true;
            }
        }

        int[] bones = Array.FindAll(Sequence(skeleton.Count), i => skeleton.Joints[i].Length > 0f || (!carries[i] && skeleton.Joints[i].Role != JointRole.End));
        return bones.Length > 0 ? bones : new[] { 0 };
    }

    private static int[] Sequence(int count)
    {
        int[] sequence = new int[count];
        for (int i = 0; i < count; i++)
        {
            sequence[i] = i;
        }

        return sequence;
    }

    private static void Ask(ref InfluenceList list, Skeleton skeleton, int joint, Vector3 p, float min)
    {
        float distance = Distance(skeleton, joint, p, min);
        list.Add(joint, 1f / (distance * distance));
    }

    private static float Distance(Skeleton skeleton, int joint, Vector3 p, float min)
    {
        Vector3 start = skeleton.ModelPositions[joint];
        Vector3 along = Rotation.Rotate(skeleton.ModelRotations[joint], skeleton.Joints[joint].Along) * skeleton.Joints[joint].Length;
        float squared = Vec.LengthSquared(along);
        float t = squared > 0f ? Scalar.Clamp(Vec.Dot(p - start, along) / squared, 0f, 1f) : 0f;
        return Math.Max(Vec.Distance(p, start + (along * t)), min);
    }
}
