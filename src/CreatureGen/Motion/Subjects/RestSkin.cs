using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Subjects;

/// <summary>The skin of a skeleton from elsewhere as it is at rest. Immutable.</summary>
internal sealed class RestSkin
{
    private readonly Skeleton skeleton;
    private readonly SkinnedMesh mesh;

    /// <summary>Takes a skin.</summary>
    /// <param name="skeleton">That it is around.</param>
    /// <param name="mesh">At rest, in the skeleton's model space.</param>
    /// <exception cref="ArgumentException">A vertex follows a joint that there is not.</exception>
    public RestSkin(Skeleton skeleton, SkinnedMesh mesh)
    {
        this.skeleton = skeleton;
        this.mesh = mesh;
        foreach (SkinWeights w in mesh.Weights)
        {
            int last = Math.Max(Math.Max(w.Joint0, w.Joint1), Math.Max(w.Joint2, w.Joint3));
            if (last >= skeleton.Count || Math.Min(Math.Min(w.Joint0, w.Joint1), Math.Min(w.Joint2, w.Joint3)) < 0)
            {
                throw new ArgumentException(FormattableString.Invariant($"a skin whose vertices follow joint {last}; expected 0..{skeleton.Count - 1}"), "skin");
            }
        }
    }

    /// <summary>The farthest vertex in a direction of those that a joint, or one that hangs on it, holds more than any other; null where there is none.</summary>
    /// <param name="joint">Number.</param>
    /// <param name="direction">Unit, model space.</param>
    public Vector3? Farthest(int joint, Vector3 direction)
    {
        ReadOnlySpan<Vector3> positions = mesh.Positions;
        ReadOnlySpan<SkinWeights> weights = mesh.Weights;
        Vector3? farthest = null;
        for (int v = 0; v < positions.Length; v++)
        {
            if (Hangs(weights[v].Joint0, joint) && (farthest is not Vector3 other || Vec.Dot(positions[v], direction) > Vec.Dot(other, direction)))
            {
                farthest = positions[v];
            }
        }

        return farthest;
    }

    /// <summary>The same skin around a stand-in at rest, without triangles.</summary>
    /// <param name="stand">The stand-in.</param>
    /// <param name="pose">The skeleton's in model space where the stand-in is at rest.</param>
    public CreatureMesh Around(StandIn stand, in Pose pose)
    {
        int count = mesh.Positions.Length;
        var matrices = new Matrix4x4[skeleton.Count];
        var positions = new Vector3[count];
        var normals = new Vector3[count];
        SkinMatrices.Fill(skeleton, pose, matrices);
        CpuSkinning.Skin(matrices, mesh.Weights, mesh.Positions, mesh.Normals, positions, normals);
        for (int v = 0; v < count; v++)
        {
            positions[v] = (positions[v] - new Vector3(0f, stand.Ground, 0f)) * stand.Unit;
        }

        return new CreatureMesh(positions, normals, new Vector2[count], new Vector3[count], WeightsOf(stand), Array.Empty<int>(), Array.Empty<MeshPart>());
    }

    /// <summary>What no joint of the stand-in leads goes with what carries it.</summary>
    private SkinWeights[] WeightsOf(StandIn stand)
    {
        int[] leaders = new int[skeleton.Count];
        for (int j = 0; j < leaders.Length; j++)
        {
            leaders[j] = stand.Follows[j] >= 0 ? stand.Follows[j] : skeleton.Parents[j] >= 0 ? leaders[skeleton.Parents[j]] : stand.Skeleton.FirstOf(JointRole.Pelvis);
        }

        var list = new InfluenceList(stackalloc int[InfluenceList.Capacity], stackalloc float[InfluenceList.Capacity]);
        var weights = new SkinWeights[mesh.Weights.Length];
        for (int v = 0; v < weights.Length; v++)
        {
            SkinWeights w = mesh.Weights[v];
            list.Clear();
            list.Add(leaders[w.Joint0], w.Weights.X);
            list.Add(leaders[w.Joint1], w.Weights.Y);
            list.Add(leaders[w.Joint2], w.Weights.Z);
            list.Add(leaders[w.Joint3], w.Weights.W);
            weights[v] = list.ToWeights();
        }

        return weights;
    }

    private bool Hangs(int joint, int above)
    {
        while (joint > above)
        {
            joint = skeleton.Parents[joint];
        }

        return joint == above;
    }
}
