using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>
/// Which child each joint's bone leads to: the one that carries the longest chain, of equal ones the one that goes on most nearly in the line of the bone before. Children in the same place lead nowhere.
/// </summary>
internal static class MainChildren
{
    /// <summary>Below this distance from its parent a joint has no direction, metres.</summary>
    private const float Apart = 1e-6f;

    /// <summary>For each joint the index of its main child, −1 without one.</summary>
    public static int[] Find(ReadOnlySpan<int> parents, ReadOnlySpan<Vector3> modelPositions)
    {
        int count = parents.Length;
        int[] depth = new int[count];
        for (int i = count - 1; i > 0; i--)
        {
            depth[parents[i]] = Math.Max(depth[parents[i]], depth[i] + 1);
        }

        int[] main = new int[count];
        Array.Fill(main, -1);
        for (int i = 1; i < count; i++)
        {
            int parent = parents[i];
            if (Vec.Distance(modelPositions[i], modelPositions[parent]) <= Apart)
            {
                continue;
            }

            int best = main[parent];
            if (best < 0 || depth[i] > depth[best] || (depth[i] == depth[best] && Straightness(i, parents, modelPositions) > Straightness(best, parents, modelPositions)))
            {
                main[parent] = i;
            }
        }

        return main;
    }

    /// <summary>Cosine of the bend between the bone that leads to the parent and the one that leads to the child; 0 at a root.</summary>
    private static float Straightness(int child, ReadOnlySpan<int> parents, ReadOnlySpan<Vector3> positions)
    {
        int parent = parents[child];
        int before = parents[parent];
        return before < 0 ? 0f : Vec.Dot(
            Vec.Normalize(positions[child] - positions[parent], Vector3.Zero),
            Vec.Normalize(positions[parent] - positions[before], Vector3.Zero));
    }
}
