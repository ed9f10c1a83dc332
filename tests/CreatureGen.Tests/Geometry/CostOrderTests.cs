using System.Linq;
using CreatureGen.Geometry;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class CostOrderTests
{
    [Fact]
    public void Costs_are_in_order_to_within_a_sixteenth_and_those_without_end_are_left_out()
    {
        var random = new Seed(3).Stream();
        float[] costs = Enumerable.Range(0, 500).Select(i => i % 7 == 0 ? float.PositiveInfinity : (float)random.Uniform() * System.MathF.Pow(10f, (i % 30) - 20)).ToArray();
        int[] items = Enumerable.Range(0, 500).Where(i => i % 3 != 0).ToArray();
        int[] sorted = new CostOrder(500).Sort(items, costs).ToArray();
        Assert.Equal(items.Where(i => i % 7 != 0), sorted.Order());
        for (int i = 1; i < sorted.Length; i++)
        {
            Assert.True(costs[sorted[i]] >= costs[sorted[i - 1]] * (15f / 16f));
        }
    }

    [Fact]
    public void Equal_costs_are_in_the_order_of_their_numbers_and_nothing_is_cheapest()
    {
        var order = new CostOrder(4);
        Assert.Equal([2, 0, 1, 3], order.Sort([0, 1, 2, 3], [0.5f, 0.5f, 0f, 0.5f]).ToArray());
        Assert.Equal([1], order.Sort([1], [1f, 2f]).ToArray());
        Assert.True(order.Sort([], []).IsEmpty);
    }
}
