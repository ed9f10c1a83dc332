using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling.Placement;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

public sealed class SocketGridTests
{
    [Fact]
    public void A_socket_takes_its_cells_and_their_mirror_images()
    {
        var grid = new SocketGrid();
        Assert.True(grid.TryReserve(new SocketBlueprint(38, 8, 6, 4), 1));
        Assert.Equal(48, grid.TakenCells);
        for (int i = 0; i < BodyGrid.Rings - 1; i++)
        {
            for (int j = 0; j < BodyGrid.Segments; j++)
            {
                bool inside = i is >= 38 and < 44 && (j is (>= 8 and < 12) or (>= 20 and < 24));
                Assert.Equal(inside, grid.IsTaken(i, j));
            }
        }
    }

    [Fact]
    public void A_socket_on_the_midline_is_its_own_mirror_image()
    {
        var grid = new SocketGrid();
        Assert.True(grid.TryReserve(new SocketBlueprint(24, 31, 8, 2), 1));
        Assert.Equal(16, grid.TakenCells);
        Assert.True(grid.IsTaken(24, 31));
        Assert.True(grid.IsTaken(24, 0));
        Assert.True(grid.TryReserve(new SocketBlueprint(24, 15, 8, 2), 1));
        Assert.Equal(32, grid.TakenCells);
    }

    [Fact]
    public void Overlap_is_refused_counted_and_changes_nothing()
    {
        var grid = new SocketGrid();
        grid.TryReserve(new SocketBlueprint(30, 8, 4, 4), 1);
        Assert.False(grid.TryReserve(new SocketBlueprint(33, 11, 4, 4), 0));
        Assert.False(grid.TryReserve(new SocketBlueprint(30, 18, 4, 4), 0));
        Assert.Equal(2, grid.Refusals);
        Assert.Equal(32, grid.TakenCells);
    }

    [Fact]
    public void The_pad_keeps_rings_before_and_behind_free_but_does_not_take_them()
    {
        var grid = new SocketGrid();
        grid.TryReserve(new SocketBlueprint(30, 8, 4, 4), 1);
        Assert.False(grid.IsFree(new SocketBlueprint(34, 8, 4, 4), 1));
        Assert.True(grid.IsFree(new SocketBlueprint(34, 8, 4, 4), 0));
        Assert.True(grid.IsFree(new SocketBlueprint(35, 8, 4, 4), 1));
        Assert.False(grid.IsFree(new SocketBlueprint(26, 8, 4, 4), 1));
        Assert.True(grid.IsFree(new SocketBlueprint(30, 12, 4, 2), 1));
    }

    [Fact]
    public void A_socket_off_the_body_or_across_its_own_mirror_image_is_refused()
    {
        var grid = new SocketGrid();
        Assert.False(grid.TryReserve(new SocketBlueprint(0, 8, 4, 4), 0));
        Assert.False(grid.TryReserve(new SocketBlueprint(50, 8, 4, 4), 0));
        Assert.True(grid.IsFree(new SocketBlueprint(49, 8, 4, 4), 0));
        Assert.False(grid.TryReserve(new SocketBlueprint(20, 13, 4, 4), 0));
        Assert.False(grid.TryReserve(new SocketBlueprint(30, 31, 4, 4), 0));
        Assert.False(grid.TryReserve(new SocketBlueprint(20, 8, 0, 4), 0));
    }

    [Fact]
    public void A_copy_lives_its_own_life()
    {
        var grid = new SocketGrid();
        SocketGrid copy = grid.Copy();
        copy.TryReserve(new SocketBlueprint(30, 8, 4, 4), 1);
        Assert.Equal(0, grid.TakenCells);
        Assert.Equal(32, copy.TakenCells);
    }
}
