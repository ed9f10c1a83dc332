using System.Linq;
using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class MirrorImagesTests
{
    // Points 0 1 2 on the left, 3 4 5 their images on the right, 6 7 on the plane.
    private static readonly sbyte[] side = [1, 1, 1, -1, -1, -1, 0, 0];

    [Fact]
    public void Triangles_on_the_right_are_images_also_where_they_touch_the_plane()
    {
        int[] corners = [0, 1, 2, 3, 5, 4, 0, 6, 7, 3, 7, 6];
        Assert.Equal([false, true, false, true], MirrorImages.Find(corners, side, new int[8], new bool[8]));
    }

    [Fact]
    public void A_piece_that_reaches_across_the_plane_has_none_and_neither_has_a_lopsided_one()
    {
        int[] corners = [0, 1, 3, 3, 4, 0, 3, 5, 4];
        Assert.Equal([false, false, false], MirrorImages.Find(corners, side, new int[8], new bool[8]));
        Assert.Equal([false, true, false], MirrorImages.Find([0, 1, 2, 3, 5, 4, 0, 6, 7], side, [0, 0, 0, 3, 3, 3, 0, 0], new bool[8]));
        Assert.Equal([false, false, false], MirrorImages.Find([0, 1, 2, 3, 5, 4, 0, 6, 7], side, [0, 0, 0, 3, 3, 3, 0, 0], [true, false, false, true, false, false, false, false]));
    }

    [Fact]
    public void Without_a_side_there_are_none()
    {
        Assert.Empty(MirrorImages.Find([], [], [], []));
        Assert.All(MirrorImages.Find([0, 1, 2, 3, 5, 4], Enumerable.Repeat((sbyte)1, 8).ToArray(), new int[8], new bool[8]), Assert.False);
    }
}
