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
        int[] corners = [0, 1, 2, 3, 4, 5];
        var surface = new CollapsingMesh(positions, new Vector3[7], corners, (int[])corners.Clone());
        using var search = new CrossingSearch(positions, corners, new int[7], PointBounds.Of(positions));
        Assert.Equal(1, search.Find(surface));
        surface.Remove(1);
        Assert.Equal(0, search.Find(surface));
        Assert.False(search.Touches(0));
    }

    private static int[] Touched(int[] corners, int[] pieces)
    {
        var surface = new CollapsingMesh(positions, new Vector3[7], corners, (int[])corners.Clone());
        using var search = new CrossingSearch(positions, corners, pieces, PointBounds.Of(positions));
        search.Find(surface);
        return Enumerable.Range(0, 7).Where(search.Touches).ToArray();
    }
}
