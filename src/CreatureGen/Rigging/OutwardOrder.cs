using System;

namespace CreatureGen.Rigging;

/// <summary>The joints of a skeleton in an order in which joints of different chains take turns: a processor then works on several at once, where along one chain each would wait for the one before it.</summary>
internal static class OutwardOrder
{
    /// <summary>The joints by their distance from the root, counted in joints, and in their order where it is the same.</summary>
    /// <param name="parents">The parent of each joint, before its children; that of the first is not looked at.</param>
    public static int[] Of(ReadOnlySpan<int> parents)
    {
        int[] depths = new int[parents.Length];
        int[] order = new int[parents.Length];
        for (int i = 1; i < depths.Length; i++)
        {
            depths[i] = depths[parents[i]] + 1;
            order[i] = i;
        }

        // Insertion sort: stable, and joints are nearly in order where chains are short.
        for (int i = 1; i < order.Length; i++)
        {
            int joint = order[i];
            int k = i;
            for (; k > 0 && depths[order[k - 1]] > depths[joint]; k--)
            {
                order[k] = order[k - 1];
            }

            order[k] = joint;
        }

        return order;
    }
}
