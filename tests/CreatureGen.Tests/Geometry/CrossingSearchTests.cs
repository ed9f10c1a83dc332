using System.Linq;
using System.Numerics;
using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class CrossingSearchTests
{
    private static readonly Vector3[] positions = [new(0, 0, 0), new(2, 0, 0), new(0, 2, 0), new(0.5f, 0.5f, -1), new(0.5f, 0.5f, 1), new(3, 3, 0), new(9, 9, 9)];

    [Fact]
    public void Triangles_that_cut_through_one_another_are_told_by_their_points()
    {
        Assert.Equal([0, 1, 2, 3, 4, 5], Touched([0, 1, 2, 3, 4, 5], new int[7]));
    }

    [Fact]
    public void Triangles_of_other_pieces_and_those_with_a_common_point_do_not_count()
    {
        Assert.Empty(Touched([0, 1, 2, 3, 4, 5], [0, 0, 0, 1, 1, 1, 1]));
        Assert.Empty(Touched([0, 1, 2, 3, 4, 1], new int[7]));
    }

    [Fact]
    public void Triangles_that_have_gone_do_not_count()
    {
        (CollapsingMesh surface, CrossingSearch search) = Pulled([0, 1, 2, 3, 4, 5], new int[7]);
        Assert.Equal(1, search.Find(surface));
        surface.Remove(1);
        Assert.Equal(0, search.Find(surface));
        Assert.False(search.Touches(0));
    }

    [Fact]
    public void What_the_finest_surface_crossed_already_and_what_was_taken_for_given_do_not_count()
    {
        int[] corners = [0, 1, 2, 3, 4, 5];
        var surface = new CollapsingMesh(positions, new Vector3[7], corners, (int[])corners.Clone());
        Assert.Equal(0, new CrossingSearch(positions, corners, new int[7], PointBounds.Of(positions)).Find(surface));
        (CollapsingMesh pulled, CrossingSearch search) = Pulled([0, 1, 2, 3, 4, 5], new int[7]);
        Assert.Equal(1, search.Find(pulled));
        search.Inherit();
        Assert.Equal(0, search.Find(pulled));
    }

    /// <summary>A reduction that goes on, and finds crossings at a place where the finest surface has had none, and later at another where it has.</summary>
    [Fact]
    public void What_the_finest_surface_crosses_elsewhere_is_taken_for_given_when_it_is_come_upon()
    {
        Vector3[] places = [.. positions, new(20, 0, 0), new(22, 0, 0), new(20, 2, 0), new(20.5f, 0.5f, -1), new(20.5f, 0.5f, 1), new(23, 3, 0), new(23, 3.5f, 0)];
        int[] corners = [0, 1, 2, 6, 4, 5, 7, 8, 9, 10, 11, 12];
        var search = new CrossingSearch(places, corners, new int[places.Length], PointBounds.Of(places));
        var surface = new CollapsingMesh(places, new Vector3[places.Length], corners, (int[])corners.Clone());
        Assert.Equal(0, search.Find(surface));
        corners[3] = 3;
        Assert.Equal(1, search.Find(surface));
        corners[11] = 13;
        Assert.Equal(1, search.Find(surface));
        Assert.True(search.Touches(4));
        Assert.False(search.Touches(10));
    }

    private static int[] Touched(int[] corners, int[] pieces)
    {
        (CollapsingMesh surface, CrossingSearch search) = Pulled(corners, pieces);
        search.Find(surface);
        return Enumerable.Range(0, 7).Where(search.Touches).ToArray();
    }

    /// <summary>Two triangles, the second of which was out of the way of the first at the beginning: one of its corners was at the last of the positions.</summary>
    private static (CollapsingMesh Surface, CrossingSearch Search) Pulled(int[] corners, int[] pieces)
    {
        int[] pulled = (int[])corners.Clone();
        pulled[3] = 6;
        var search = new CrossingSearch(positions, pulled, pieces, PointBounds.Of(positions));
        corners.CopyTo(pulled, 0);
        return (new CollapsingMesh(positions, new Vector3[7], pulled, (int[])corners.Clone()), search);
    }
}
