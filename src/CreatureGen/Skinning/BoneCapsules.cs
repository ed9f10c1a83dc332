using System;
using System.Buffers;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>A capsule for each bone that moves skin, around the vertices that the bone holds more than any other.</summary>
internal static class BoneCapsules
{
    /// <summary>Number of vertices below which a bone gets no capsule: it moves no skin to speak of.</summary>
    private const int FewestVertices = 6;

    /// <summary>Fits the capsules, in the order of the joints. Those of the right side are exact mirror images.</summary>
    /// <param name="skeleton">Rest pose, in the units of the positions.</param>
    /// <param name="weights">One per position.</param>
    /// <param name="positions">Rest positions of the skin, model space.</param>
    public static CapsuleCollider[] Fit(Skeleton skeleton, ReadOnlySpan<SkinWeights> weights, ReadOnlySpan<Vector3> positions)
    {
        int joints = skeleton.Count;
        int[] start = new int[joints + 1];
        foreach (SkinWeights w in weights)
        {
            start[w.Joint0 + 1]++;
        }

        for (int j = 0; j < joints; j++)
        {
            start[j + 1] += start[j];
        }

        // As long as the skin, and needed here alone.
        Vector3[] sorted = ArrayPool<Vector3>.Shared.Rent(positions.Length);
        float[] scratch = ArrayPool<float>.Shared.Rent(2 * positions.Length);
        int[] next = (int[])start.Clone();
        for (int v = 0; v < positions.Length; v++)
        {
            sorted[next[weights[v].Joint0]++] = positions[v];
        }

        // A limb's capsule on the right is that on the left, seen in the mirror: worked out once.
        var fits = new CapsuleCollider?[joints];
        var capsules = new List<CapsuleCollider>(joints);
        for (int j = 0; j < joints; j++)
        {
            Joint joint = skeleton.Joints[j];
            int source = joint.Side == Side.Right ? skeleton.Mirrors[j] : j;
            int count = start[source + 1] - start[source];
            if (count < FewestVertices || joint.Role == JointRole.Lid)
            {
                continue;
            }

            CapsuleCollider fit = fits[source] ??= Around(skeleton, source, sorted.AsSpan(start[source], count), scratch);
            capsules.Add(source == j ? fit : new CapsuleCollider(j, Vec.Mirror(fit.Start), Vec.Mirror(fit.End), fit.Radius));
        }

        ArrayPool<float>.Shared.Return(scratch);
        ArrayPool<Vector3>.Shared.Return(sorted);
        return capsules.ToArray();
    }

    private static CapsuleCollider Around(Skeleton skeleton, int joint, ReadOnlySpan<Vector3> held, Span<float> scratch)
    {
        Quaternion rotation = skeleton.ModelRotations[joint];
        Vector3 origin = skeleton.ModelPositions[joint];
        CapsuleFit fit = CapsuleFit.Around(held, origin, Rotation.Rotate(rotation, Vector3.UnitY), skeleton.Joints[joint].Side == Side.Median && origin.X == 0f, scratch);
        Quaternion inverse = Rotation.Inverse(rotation);
        return new CapsuleCollider(joint, Rotation.Rotate(inverse, fit.Start - origin), Rotation.Rotate(inverse, fit.End - origin), fit.Radius);
    }
}
