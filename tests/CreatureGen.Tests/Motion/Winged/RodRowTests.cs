using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Motion.Winged;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Winged;

public sealed class RodRowTests
{
    private const float Slack = 1e-3f;

    [Fact]
    public void The_nearest_rod_is_the_one_that_asking_all_of_them_finds()
    {
        RandomStream random = new Seed(7).Stream();
        for (int trial = 0; trial < 40; trial++)
        {
            Rod[] rods = Enumerable.Range(0, trial).Select(_ => new Rod(Point(random, 1), Point(random, 1), (float)random.Uniform(0.01, 0.2))).ToArray();
            var row = new RodRow(rods, Slack);
            for (int i = 0; i < 200; i++)
            {
                Vector3 point = Point(random, 2);
                double nearest = rods.Length == 0 ? double.MaxValue : rods.Min(rod => rod.Distance(point));
                Assert.Equal(Math.Max(0, nearest), Math.Max(0, row.Distance(point)));
            }
        }
    }

    [Fact]
    public void The_cell_of_a_point_names_every_box_that_holds_it()
    {
        RandomStream random = new Seed(8).Stream();
        RodBox[] boxes = Enumerable.Range(0, 60).Select(_ => new Rod(Point(random, 1), Point(random, 1), 0.05f).Box(Slack)).ToArray();
        var grid = new BoxGrid(Array.ConvertAll(boxes, box => (box.Min, box.Max)));
        for (int i = 0; i < 5000; i++)
        {
            Vector3 point = Point(random, 1.5);
            int[] named = grid.At(point).ToArray();
            Assert.Equal(named.Order(), named);
            Assert.All(Enumerable.Range(0, boxes.Length).Where(k => boxes[k].MayHold(point, below: true)), k => Assert.Contains(k, named));
        }

        Assert.True(new BoxGrid([]).At(Vector3.Zero).IsEmpty);
    }

    private static Vector3 Point(RandomStream random, double extent) =>
        new((float)random.Uniform(-extent, extent), (float)random.Uniform(-extent, extent), (float)random.Uniform(-extent, extent));
}
