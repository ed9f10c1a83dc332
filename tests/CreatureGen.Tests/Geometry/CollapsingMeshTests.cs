using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class CollapsingMeshTests
{
    private static readonly int[] octahedron = { 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5 };
    private static readonly Vector3[] octahedronPoints = { new(1, 0, 0), new(-1, 0, 0), new(0, 1, 0), new(0, -1, 0), new(0, 0, 1), new(0, 0, -1) };

    [Fact]
    public void Neighbours_are_listed_once()
    {
        CollapsingMesh mesh = Octahedron();
        Assert.Equal([2, 3, 4, 5], mesh.Neighbours(0).ToArray().Order());
    }

    [Fact]
    public void A_tetrahedron_does_not_collapse()
    {
        Vector3[] points = { new(0, 0, 1), new(1, 0, -1), new(-1, 0, -1), new(0, 1, 0) };
        int[] corners = { 0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 2, 1 };
        var mesh = new CollapsingMesh(points, Outwards(points), (int[])corners.Clone(), (int[])corners.Clone());
        for (int from = 0; from < 4; from++)
        {
            for (int to = 0; to < 4; to++)
            {
                Assert.False(from != to && TryCollapse(mesh, from, to));
            }
        }

        Assert.Equal(4, mesh.Triangles);
    }

    [Fact]
    public void Points_without_an_edge_between_them_stay()
    {
        Assert.False(TryCollapse(Octahedron(), 0, 1));
    }

    [Fact]
    public void An_edge_whose_ends_have_a_third_neighbour_in_common_stays()
    {
        // Two tetrahedra on a common triangle without that triangle: its three edges must not collapse, or the surface is pinched.
        Vector3[] points = { new(1, 0, 0), new(-0.5f, 0, 0.9f), new(-0.5f, 0, -0.9f), new(0, 1, 0), new(0, -1, 0) };
        int[] corners = { 0, 2, 3, 2, 1, 3, 1, 0, 3, 2, 0, 4, 1, 2, 4, 0, 1, 4 };
        Assert.True(SurfaceTopology.Of(points, corners).IsClosed);
        var mesh = new CollapsingMesh(points, Outwards(points), (int[])corners.Clone(), (int[])corners.Clone());
        Assert.False(TryCollapse(mesh, 0, 1));
        Assert.False(TryCollapse(mesh, 1, 2));
    }

    /// <summary>The numbers of what comes after the point in one triangle and before it in the other add up to the same.</summary>
    [Fact]
    public void All_neighbours_are_told_of_a_point_where_two_open_fans_meet()
    {
        Vector3[] points = { new(0, 0, 0), new(1, 0, 0), default, new(-1, 0, -1), new(1, 0, 1), default, new(-1, 0, 0) };
        int[] corners = { 0, 1, 4, 0, 6, 3 };
        var mesh = new CollapsingMesh(points, Outwards(points), (int[])corners.Clone(), (int[])corners.Clone());
        Assert.Equal([1, 3, 4, 6], mesh.Neighbours(0).ToArray().Order());
    }

    [Fact]
    public void A_step_that_turns_a_triangle_over_is_refused()
    {
        // A fan around point 0 in a plane; pulling 0 beyond the notch of the outline would turn a triangle over.
        Vector3[] points = { new(0, 0, 0), new(2, 0, 0), new(0.2f, 0, -0.2f), new(0, 0, -2), new(-2, 0, 0), new(0, 0, 2), new(0, -2, 0) };
        int[] outline = { 1, 2, 3, 4, 5 };
        var corners = new List<int>();
        for (int i = 0; i < outline.Length; i++)
        {
            int a = outline[i];
            int b = outline[(i + 1) % outline.Length];
            corners.AddRange([0, a, b]);
            corners.AddRange([6, b, a]);
        }

        Assert.True(SurfaceTopology.Of(points, corners.ToArray()).IsClosed);
        Vector3[] normals = Enumerable.Repeat(Vector3.UnitY, 6).Append(-Vector3.UnitY).ToArray();
        var mesh = new CollapsingMesh(points, normals, corners.ToArray(), corners.ToArray());
        Assert.False(TryCollapse(mesh, 0, 1));
        Assert.Equal(10, mesh.Triangles);
        Assert.True(TryCollapse(mesh, 0, 2));
        Assert.Equal(8, mesh.Triangles);
    }

    [Fact]
    public void Undoing_a_step_restores_all_there_was()
    {
        (Vector3[] points, int[] corners) = Grid(6);
        int[] places = (int[])corners.Clone();
        int[] vertices = (int[])corners.Clone();
        var mesh = new CollapsingMesh(points, Outwards(points), places, vertices);
        int tried = 0;
        for (int p = 0; p < points.Length; p++)
        {
            int[] neighbours = mesh.Neighbours(p).ToArray();
            foreach (int q in neighbours)
            {
                if (TryCollapse(mesh, p, q))
                {
                    tried++;
                    Assert.Equal((corners.Length / 3) - 2, mesh.Triangles);
                    mesh.Undo();
                    Assert.Equal(corners.Length / 3, mesh.Triangles);
                    Assert.Equal(corners, places);
                    Assert.Equal(corners, vertices);
                    Assert.Equal(neighbours, mesh.Neighbours(p).ToArray());
                }
            }
        }

        Assert.True(tried > 20);
    }

    [Fact]
    public void A_vertex_on_a_seam_is_matched_along_the_seam_only()
    {
        // Points 0 and 2 of the octahedron have another vertex on the side of 5: the seam runs along the equator.
        int[] vertices = octahedron.Select((v, i) => v is 0 or 2 && i >= 12 ? v + 10 : v).ToArray();
        var mesh = new CollapsingMesh(octahedronPoints, Outwards(octahedronPoints), (int[])octahedron.Clone(), vertices);
        var pairs = new List<(int From, int To)>();
        Assert.True(mesh.Match(0, 2, pairs));
        Assert.Equal([(0, 2), (10, 12)], pairs.Order());
        Assert.False(mesh.Match(0, 4, pairs));
        Assert.Equal([(0, 4), (10, -1)], pairs.Order());
    }

    [Fact]
    public void A_surface_is_put_back_to_what_it_was_when_it_was_saved()
    {
        (Vector3[] points, int[] corners) = Grid(6);
        int[] places = (int[])corners.Clone();
        var mesh = new CollapsingMesh(points, Outwards(points), places, (int[])corners.Clone());
        mesh.Save();
        int taken = 0;
        for (int p = 0; p < points.Length; p++)
        {
            foreach (int q in mesh.Neighbours(p).ToArray())
            {
                taken += mesh.IsUsed(p) && mesh.IsUsed(q) && TryCollapse(mesh, p, q) ? 1 : 0;
            }
        }

        Assert.True(taken > 10);
        Assert.Equal((corners.Length / 3) - (2 * taken), mesh.Triangles);
        mesh.Restore();
        Assert.Equal(corners.Length / 3, mesh.Triangles);
        Assert.Equal(corners, places);
        Assert.All(Enumerable.Range(0, points.Length), p => Assert.True(mesh.IsUsed(p)));
    }

    /// <summary>Points 0 to 3 and 4 are a square and its middle in front of the plane x = 0, seen from the left; what is beyond is the image.</summary>
    [Fact]
    public void A_point_on_the_rim_goes_along_the_rim_with_one_triangle()
    {
        Vector3[] points = { new(0, -1, -1), new(0, -1, 1), new(0, 1, 1), new(0, 1, -1), new(0, 0, 1.2f), new(1, 0, 0) };
        int[] corners = { 0, 5, 1, 1, 5, 4, 4, 5, 2, 2, 5, 3, 3, 5, 0 };
        CollapsingMesh mesh = Half(points, corners);
        Assert.Equal([1, 2, 5], mesh.Neighbours(4).ToArray().Order());
        Assert.True(TryCollapse(mesh, 4, 1));
        Assert.Equal(4, mesh.Triangles);
    }

    [Fact]
    public void A_point_that_joins_parts_of_the_rim_that_are_no_neighbours_stays()
    {
        // On the other side its image would do the same: both would meet along an edge of four triangles.
        Vector3[] points = { new(0, -1, -1), new(0, -1, 1), new(0, 1, 1), new(0, 1, -1), new(1, 0, 0) };
        int[] corners = { 0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 4, 0 };
        Assert.False(Half(points, corners).Allows(4, 0));
    }

    private static CollapsingMesh Half(Vector3[] points, int[] corners) =>
        new(points, Outwards(points), (int[])corners.Clone(), (int[])corners.Clone(), points.Select(p => p.X == 0f).ToArray());

    private static bool TryCollapse(CollapsingMesh mesh, int from, int to)
    {
        if (!mesh.Allows(from, to))
        {
            return false;
        }

        mesh.Collapse(from, to, [(from, to)]);
        return true;
    }

    private static CollapsingMesh Octahedron() =>
        new(octahedronPoints, Outwards(octahedronPoints), (int[])octahedron.Clone(), (int[])octahedron.Clone());

    private static Vector3[] Outwards(Vector3[] points) => points.Select(Vector3.Normalize).ToArray();

    /// <summary>A ball of rings and segments with two poles.</summary>
    private static (Vector3[] Points, int[] Corners) Grid(int rings)
    {
        int segments = 2 * rings;
        var points = new List<Vector3>();
        var corners = new List<int>();
        for (int r = 1; r < rings; r++)
        {
            for (int s = 0; s < segments; s++)
            {
                float polar = System.MathF.PI * r / rings;
                float around = 2f * System.MathF.PI * s / segments;
                points.Add(new Vector3(System.MathF.Sin(polar) * System.MathF.Cos(around), System.MathF.Cos(polar), System.MathF.Sin(polar) * System.MathF.Sin(around)));
            }
        }

        points.Add(Vector3.UnitY);
        points.Add(-Vector3.UnitY);
        int Index(int r, int s) => ((r - 1) * segments) + (s % segments);
        for (int s = 0; s < segments; s++)
        {
            corners.AddRange([points.Count - 2, Index(1, s + 1), Index(1, s), points.Count - 1, Index(rings - 1, s), Index(rings - 1, s + 1)]);
            for (int r = 1; r < rings - 1; r++)
            {
                corners.AddRange([Index(r, s), Index(r, s + 1), Index(r + 1, s + 1), Index(r, s), Index(r + 1, s + 1), Index(r + 1, s)]);
            }
        }

        return (points.ToArray(), corners.ToArray());
    }
}
