using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>Skin weights of a separate piece that bends along a chain of joints: an antenna, the wing of an insect.</summary>
internal static class ChainWeights
{
    /// <summary>Share of the shorter of two bones on either side of a joint over which the skin goes over.</summary>
    private const float Stretch = 0.4f;

    /// <summary>One set of influences per point, by where the point lies along the chain.</summary>
    /// <param name="skeleton">Rest pose, in the units of the points.</param>
    /// <param name="joints">Indices from root to end, the end joint included (as <see cref="LimbChain.Joints"/>).</param>
    /// <param name="points">Rest positions, model space.</param>
    public static SkinWeights[] Solve(Skeleton skeleton, IReadOnlyList<int> joints, ReadOnlySpan<Vector3> points)
    {
        int bones = joints.Count - 1;
        float[] at = new float[joints.Count];
        for (int k = 0; k < bones; k++)
        {
            at[k + 1] = at[k] + Vec.Distance(skeleton.ModelPositions[joints[k]], skeleton.ModelPositions[joints[k + 1]]);
        }

        var weights = new SkinWeights[points.Length];
        var list = new InfluenceList(stackalloc int[InfluenceList.Capacity], stackalloc float[InfluenceList.Capacity]);
        for (int v = 0; v < points.Length; v++)
        {
            float x = Along(skeleton, joints, at, points[v]);
            list.Clear();
            float over = 1f;
            for (int k = 1; k < bones; k++)
            {
                float half = Math.Max(Stretch * Math.Min(at[k] - at[k - 1], at[k + 1] - at[k]), 1e-9f);
                float next = Math.Min(over, Scalar.Smooth((x - at[k] + half) / (2f * half)));
                list.Add(joints[k - 1], over - next);
                over = next;
            }

            list.Add(joints[bones - 1], over);
            weights[v] = list.ToWeights();
        }

        return weights;
    }

    /// <summary>Distance along the chain of the place on it that is nearest to a point.</summary>
    private static float Along(Skeleton skeleton, IReadOnlyList<int> joints, float[] at, Vector3 p)
    {
        float nearest = float.MaxValue;
        float along = 0f;
        for (int k = 0; k < joints.Count - 1; k++)
        {
            Vector3 a = skeleton.ModelPositions[joints[k]];
            Vector3 d = skeleton.ModelPositions[joints[k + 1]] - a;
            float squared = Vec.LengthSquared(d);
            float t = squared > 0f ? Scalar.Clamp(Vec.Dot(p - a, d) / squared, 0f, 1f) : 0f;
            float distance = Vec.LengthSquared(p - (a + (d * t)));
            if (distance < nearest)
            {
                nearest = distance;
                along = at[k] + (t * (at[k + 1] - at[k]));
            }
        }

        return along;
    }
}
