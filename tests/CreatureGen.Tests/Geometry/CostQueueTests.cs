using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class CostQueueTests
{
    [Fact]
    public void Items_leave_by_cost_and_then_by_number()
    {
        var random = new Random(3);
        (int Item, double Cost)[] items = Enumerable.Range(0, 500).Select(i => (i, (double)random.Next(40))).ToArray();
        var queue = new CostQueue(2);
        foreach ((int item, double cost) in items.Reverse())
        {
            queue.Add(item, cost);
        }

        var taken = new List<(int, double)>();
        while (queue.Count > 0)
        {
            int item = queue.Take(out double cost);
            taken.Add((item, cost));
        }

        Assert.Equal(items.OrderBy(i => i.Cost).ThenBy(i => i.Item), taken);
    }

    [Fact]
    public void Items_may_be_added_between_takes()
    {
        var queue = new CostQueue(0);
        queue.Add(1, 5);
        queue.Add(2, 3);
        Assert.Equal(2, queue.Take(out _));
        queue.Add(3, 9);
        queue.Add(4, 1);
        Assert.Equal([4, 1, 3], new[] { queue.Take(out _), queue.Take(out _), queue.Take(out double last) });
        Assert.Equal(9, last);
        Assert.Equal(0, queue.Count);
    }
}
