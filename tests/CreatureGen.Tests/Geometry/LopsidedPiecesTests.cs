using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class LopsidedPiecesTests
{
    // Two quadrangles 0 1 2 3 on the right and 4 5 6 7 on the left, each the other's mirror image.
    private static readonly int[] twin = [4, 5, 6, 7, 0, 1, 2, 3];

    [Fact]
    public void Quadrangles_cut_between_the_same_corners_are_mirrored_in_whatever_order_the_corners_come()
    {
        int[] corners = [0, 1, 2, 2, 3, 0, 5, 4, 6, 6, 4, 7];
        Assert.Equal(new bool[8], LopsidedPieces.Find(corners, twin, new int[8]));
    }

    [Fact]
    public void A_quadrangle_cut_between_its_other_corners_makes_its_piece_lopsided_and_no_other()
    {
        int[] corners = [0, 1, 2, 2, 3, 0, 4, 5, 7, 5, 6, 7];
        int[] pieceOf = [2, 2, 2, 2, 6, 6, 6, 6];
        bool[] found = LopsidedPieces.Find(corners, twin, pieceOf);
        Assert.Equal([false, false, true, false, false, false, true, false], found);
    }

    [Fact]
    public void A_triangle_across_the_plane_is_its_own_image()
    {
        Assert.Equal(new bool[3], LopsidedPieces.Find([0, 1, 2], [1, 0, 2], new int[3]));
        Assert.Empty(LopsidedPieces.Find([], [], []));
    }
}
