using System;

namespace CreatureGen.Geometry;

/// <summary>Numbers by ascending cost, equal costs by ascending number: a binary heap.</summary>
internal sealed class CostQueue
{
    private (double Cost, int Item)[] heap;

    /// <summary>An empty queue with room for a number of items.</summary>
    public CostQueue(int capacity) => heap = new (double Cost, int Item)[Math.Max(capacity, 4)];

    /// <summary>Number of items.</summary>
    public int Count { get; private set; }

    /// <summary>Adds an item; it must not be in the queue.</summary>
    public void Add(int item, double cost)
    {
        if (Count == heap.Length)
        {
            Array.Resize(ref heap, 2 * Count);
        }

        int at = Count++;
        while (at > 0 && IsBefore((cost, item), heap[(at - 1) / 2]))
        {
            heap[at] = heap[(at - 1) / 2];
            at = (at - 1) / 2;
        }

        heap[at] = (cost, item);
    }

    /// <summary>Takes out the item of least cost. The queue must not be empty.</summary>
    public int Take(out double cost)
    {
        (double Cost, int Item) top = heap[0];
        (double Cost, int Item) moved = heap[--Count];
        int at = 0;
        while (true)
        {
            int child = (2 * at) + 1;
            if (child >= Count)
            {
                break;
            }

            child += child + 1 < Count && IsBefore(heap[child + 1], heap[child]) ? 1 : 0;
            if (!IsBefore(heap[child], moved))
            {
                break;
            }

            heap[at] = heap[child];
            at = child;
        }

        heap[at] = moved;
        cost = top.Cost;
        return top.Item;
    }

    private static bool IsBefore((double Cost, int Item) a, (double Cost, int Item) b) =>
        a.Cost < b.Cost || (a.Cost == b.Cost && a.Item < b.Item);
}
