using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class SurfaceTopologyTests
{
    private static readonly Vector3[] points = { Vector3.UnitX, -Vector3.UnitX, Vector3.UnitY, -Vector3.UnitY, Vector3.UnitZ, -Vector3.UnitZ, 3 * Vector3.UnitX, new(2, 1, 0), new(2, -1, 0), new(2, 0, 1), new(2, 0, -1) };
    private static readonly int[] octahedron = { 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5 };

    /// <summary>Another that has vertex 0 in common with the first.</summary>
    private static readonly int[] neighbour = { 6, 7, 9, 7, 0, 9, 0, 8, 9, 8, 6, 9, 7, 6, 10, 0, 7, 10, 8, 0, 10, 6, 8, 10 };

    [Fact]
    public void A_closed_surface_has_nothing_wrong_with_it_and_three_edges_for_two_triangles()
    {
        SurfaceTopology topology = Examine(octahedron);
        Assert.True(topology.IsClosed);
        Assert.Equal((12, 2, 0, 5), (topology.Edges, topology.EulerCharacteristic, topology.DuplicateTriangles, topology.UnusedVertices));
    }

    [Fact]
    public void A_lost_triangle_leaves_three_open_edges() => Assert.Equal((3, 0), Faults(octahedron.Skip(3)));

    [Fact]
    public void A_turned_triangle_runs_along_three_edges_as_its_neighbours_do() => Assert.Equal((0, 3), Faults(octahedron.Skip(3).Concat([0, 4, 2])));

    [Fact]
    public void A_vertex_in_which_two_surfaces_touch_is_pinched()
    {
        SurfaceTopology topology = Examine(octahedron.Concat(neighbour));
        Assert.Equal((1, 0, 0), (topology.PinchedVertices, topology.OpenEdges, topology.WindingEdges));
        Assert.False(topology.IsClosed);
    }

    [Fact]
    public void Two_triangles_back_to_back_are_one_twice() => Assert.Equal(1, Examine([0, 1, 2, 2, 1, 0]).DuplicateTriangles);

    [Fact]
    public void A_triangle_that_uses_a_vertex_twice_has_no_area_and_no_edges()
    {
        SurfaceTopology topology = Examine(octahedron.Concat([0, 0, 2]));
        Assert.Equal((12, 1, 5), (topology.Edges, topology.DegenerateTriangles, topology.UnusedVertices));
    }

    /// <summary>What is told at a glance is what counting tells.</summary>
    [Fact]
    public void Rings_are_whole_exactly_where_each_edge_has_its_two_triangles_and_no_vertex_is_pinched()
    {
        var random = new Random(7);
        int whole = 0;
        for (int round = 0; round < 2000; round++)
        {
            List<int> triangles = octahedron.Concat(round % 2 == 0 ? neighbour.Select(v => v == 0 ? 1 + (round % 5) : v) : neighbour.Select(v => v == 0 ? points.Length : v)).ToList();
            for (int change = random.Next(3); change > 0; change--)
            {
                int t = 3 * random.Next(triangles.Count / 3);
                switch (random.Next(3))
                {
                    case 0:
                        triangles.RemoveRange(t, 3);
                        break;
                    case 1:
                        (triangles[t], triangles[t + 1]) = (triangles[t + 1], triangles[t]);
                        break;
                    default:
                        triangles.AddRange(triangles.GetRange(t, 3));
                        break;
                }
            }

            bool expected = IsClosed(triangles);
            whole += expected ? 1 : 0;
            Assert.Equal(expected, VertexRings.AreWhole(points.Length + 1, triangles.ToArray(), out int used));
            Assert.True(!expected || used == triangles.Distinct().Count());
        }

        Assert.InRange(whole, 100, 1900);
    }

    /// <summary>The slow way: each directed edge once, its reverse too, and around each vertex one ring.</summary>
    private static bool IsClosed(List<int> triangles)
    {
        (int From, int To, int Opposite)[] edges = Enumerable.Range(0, triangles.Count).Select(c => (triangles[c], triangles[(c / 3 * 3) + ((c + 1) % 3)], triangles[(c / 3 * 3) + ((c + 2) % 3)])).ToArray();
        var next = new Dictionary<(int From, int To), int>();
        return edges.All(e => next.TryAdd((e.From, e.To), e.Opposite)) && edges.All(e => next.ContainsKey((e.To, e.From))) && triangles.Distinct().All(v =>
        {
            int first = edges.First(e => e.From == v).To, at = first, steps = 0;
            do
            {
                at = next[(v, at)];
                steps++;
            }
            while (at != first);
            return steps == edges.Count(e => e.From == v);
        });
    }

    private static (int Open, int Winding) Faults(IEnumerable<int> triangles)
    {
        SurfaceTopology topology = Examine(triangles);
        return (topology.OpenEdges, topology.WindingEdges);
    }

    private static SurfaceTopology Examine(IEnumerable<int> triangles) => SurfaceTopology.Of(points, triangles.ToArray());
}
