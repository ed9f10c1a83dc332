using System;

namespace CreatureGen.Geometry;

/// <summary>Items in the order of their cost, to within a sixteenth of it, and of their number where costs are as equal as that.</summary>
/// <remarks>A counting sort by the exponent and the first binary places of the cost: a tenth of the time of a sort by comparison.</remarks>
internal sealed class CostOrder
{
    private const int DroppedBits = 19;
    private const int Buckets = 1 << (31 - DroppedBits);

    private readonly int[] starts = new int[Buckets + 1];
    private readonly int[] items;

    /// <summary>With room for a number of items.</summary>
    public CostOrder(int capacity) => items = new int[capacity];

    /// <summary>Those of the items that have a finite cost, the cheapest first.</summary>
    /// <param name="candidates">The items, ascending.</param>
    /// <param name="costs">The cost of each, at its number, not below zero.</param>
    public ReadOnlySpan<int> Sort(ReadOnlySpan<int> candidates, ReadOnlySpan<float> costs)
    {
        Array.Clear(starts, 0, starts.Length);
        foreach (int item in candidates)
        {
            starts[BucketOf(costs[item]) + 1]++;
        }

        for (int b = 0; b < Buckets; b++)
        {
            starts[b + 1] += starts[b];
        }

        int finite = starts[BucketOf(float.PositiveInfinity)];
        foreach (int item in candidates)
        {
            items[starts[BucketOf(costs[item])]++] = item;
        }

        return items.AsSpan(0, finite);
    }

    private static int BucketOf(float cost) => BitConverter.SingleToInt32Bits(cost) >> DroppedBits;
}
