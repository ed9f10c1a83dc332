using System;
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

        var sorted = new Vector3[positions.Length];
        int[] next = (int[])start.Clone();
        for (int v = 0; v < positions.Length; v++)
        {
            sorted[next[weights[v].Joint0]++] = positions[v];
        }

        float[] scratch = new float[2 * positions.Length];
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

            Quaternion rotation = skeleton.ModelRotations[source];
            Vector3 origin = skeleton.ModelPositions[source];
            CapsuleFit fit = CapsuleFit.Around(sorted.AsSpan(start[source], count), origin, Rotation.Rotate(rotation, Vector3.UnitY), joint.Side == Side.Median, scratch);
            Quaternion inverse = Rotation.Inverse(rotation);
            Vector3 first = Rotation.Rotate(inverse, fit.Start - origin);
            Vector3 last = Rotation.Rotate(inverse, fit.End - origin);
            bool mirrored = source != j;
            capsules.Add(new CapsuleCollider(j, mirrored ? Vec.Mirror(first) : first, mirrored ? Vec.Mirror(last) : last, fit.Radius));
        }

        return capsules.ToArray();
    }
}
