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
        int[] begins = new int[parents.Length + 1];
        for (int i = 0; i < depths.Length; i++)
        {
            depths[i] = i == 0 ? 0 : depths[parents[i]] + 1;
            begins[depths[i] + 1]++;
        }

        for (int depth = 1; depth < begins.Length; depth++)
        {
            begins[depth] += begins[depth - 1];
        }

        int[] order = new int[parents.Length];
        for (int i = 0; i < order.Length; i++)
        {
            order[begins[depths[i]]++] = i;
        }

        return order;
    }
}
