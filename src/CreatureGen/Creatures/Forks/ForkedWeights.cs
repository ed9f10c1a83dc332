using System;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Creatures.Forks;

/// <summary>Skin weights of a forked surface from those of the same body with one neck.</summary>
internal static class ForkedWeights
{
    /// <summary>One set of influences per vertex of the forked surface.</summary>
    /// <param name="weights">One per vertex of the unforked surface.</param>
    /// <param name="surface">The forked surface.</param>
    /// <param name="rig">The forked rig.</param>
    /// <param name="mirrors">The counterparts of the joints of the unforked skeleton.</param>
    /// <param name="halfWidth">Half the width of the body at the fork, metres: over so much both necks share the skin behind it.</param>
    public static SkinWeights[] Solve(SkinWeights[] weights, ForkedSurface surface, ForkedRig rig, ReadOnlySpan<int> mirrors, float halfWidth)
    {
        Surface forked = surface.Surface;
        var result = new SkinWeights[forked.Positions.Length];
        var list = new InfluenceList(stackalloc int[InfluenceList.Capacity], stackalloc float[InfluenceList.Capacity]);
        for (int v = 0; v < result.Length; v++)
        {
            if (forked.Addresses[v].Sign < 0)
            {
                continue;
            }

            // What is there twice lies on the left here and follows the left neck alone; all else that follows a neck lies where both meet.
            int source = surface.Source[v];
            float left = surface.IsDoubled(source) ? 1f : (float)Scalar.Smooth((1 + (forked.Positions[v].X / halfWidth)) / 2);
            SkinWeights w = weights[source];
            list.Clear();
            Add(ref list, rig, w.Joint0, w.Weights.X, left);
            Add(ref list, rig, w.Joint1, w.Weights.Y, left);
            Add(ref list, rig, w.Joint2, w.Weights.Z, left);
            Add(ref list, rig, w.Joint3, w.Weights.W, left);
            result[v] = list.ToWeights();
        }

        int[] image = Images(rig, mirrors);
        for (int v = 0; v < result.Length; v++)
        {
            if (forked.Addresses[v].Sign < 0)
            {
                SkinWeights w = result[forked.Mirror[v]];
                result[v] = new SkinWeights(image[w.Joint0], image[w.Joint1], image[w.Joint2], image[w.Joint3], w.Weights);
            }
        }

        return result;
    }

    private static void Add(ref InfluenceList list, ForkedRig rig, int joint, float weight, float left)
    {
        int second = rig.Second[joint];
        list.Add(joint, second < 0 ? weight : weight * left);
        list.Add(Math.Max(second, 0), second < 0 ? 0f : weight * (1f - left));
    }

    /// <summary>For each joint of the forked skeleton its mirror image.</summary>
    private static int[] Images(ForkedRig rig, ReadOnlySpan<int> mirrors)
    {
        int[] image = new int[rig.Rig.Skeleton.Count];
        for (int j = 0; j < mirrors.Length; j++)
        {
            int second = rig.Second[j];
            image[j] = second < 0 ? mirrors[j] : second;
            if (second >= 0)
            {
                image[second] = j;
            }
        }

        return image;
    }
}
