using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class MirroredHalfTests
{
    // Points 0 1 2 3 on the left, 4 5 6 7 their images on the right, 8 9 on the plane.
    private static readonly sbyte[] side = [1, 1, 1, 1, -1, -1, -1, -1, 0, 0];
    private static readonly int[] twin = [4, 5, 6, 7, 0, 1, 2, 3, 8, 9];
    private static readonly int[] points = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9];

    [Fact]
    public void Of_two_pieces_that_are_images_of_each_other_the_left_one_is_kept()
    {
        int[] pieces = [0, 0, 0, 0, 4, 4, 4, 4, 8, 9];
        var half = new MirroredHalf(points, Quadrangles(4, 6, 5, 4, 7, 6), Quadrangles(4, 6, 5, 4, 7, 6), twin, side, pieces);
        Assert.Equal([0, 1], half.Triangles);
        Assert.True(half.IsHalved[0] && half.IsHalved[4]);
        Assert.Equal([4, 5, 6, 7, -1, -1, -1, -1, -1, -1], half.Image);
    }

    [Fact]
    public void Quadrangles_cut_between_other_corners_on_the_other_side_are_kept_on_both()
    {
        int[] pieces = [0, 0, 0, 0, 4, 4, 4, 4, 8, 9];
        var half = new MirroredHalf(points, Quadrangles(4, 7, 5, 5, 7, 6), Quadrangles(4, 7, 5, 5, 7, 6), twin, side, pieces);
        Assert.Equal([0, 1, 2, 3], half.Triangles);
        Assert.False(half.IsHalved[0] || half.IsHalved[4]);
        Assert.Equal([-1, -1, -1, -1, -1, -1, -1, -1, -1, -1], half.Image);
    }

    [Fact]
    public void A_piece_across_the_plane_is_halved_when_it_is_cut_along_the_plane_and_kept_when_a_triangle_reaches_across()
    {
        int[] cut = [0, 8, 9, 4, 9, 8];
        Assert.Equal([0], new MirroredHalf(points, cut, cut, twin, side, new int[10]).Triangles);
        int[] across = [0, 8, 4, 0, 9, 8, 4, 8, 9];
        Assert.Equal([0, 1, 2], new MirroredHalf(points, across, across, twin, side, new int[10]).Triangles);
    }

    [Fact]
    public void Vertices_that_part_on_one_side_alone_keep_both_sides()
    {
        // Vertex 10 is at point 4, but only in one of its triangles.
        int[] pieces = [0, 0, 0, 0, 4, 4, 4, 4, 8, 9];
        int[] corners = Quadrangles(4, 6, 5, 4, 7, 6);
        var half = new MirroredHalf([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 4], corners, Quadrangles(4, 6, 5, 10, 7, 6), twin, side, pieces);
        Assert.Equal(4, half.Triangles.Length);
    }

    [Fact]
    public void Without_mirror_images_all_is_kept()
    {
        int[] corners = Quadrangles(4, 6, 5, 4, 7, 6);
        Assert.Equal(4, new MirroredHalf(points, corners, corners, points, [1, 1, 1, 1, 1, 1, 1, 1, 1, 1], new int[10]).Triangles.Length);
    }

    private static int[] Quadrangles(params int[] right) => [0, 1, 2, 0, 2, 3, .. right];
}
