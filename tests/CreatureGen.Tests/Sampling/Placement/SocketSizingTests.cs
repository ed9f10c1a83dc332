using CreatureGen.Blueprints;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

public sealed class SocketSizingTests
{
    [Theory]
    [InlineData(0.05, 4)]
    [InlineData(0.124, 4)]
    [InlineData(0.126, 6)]
    [InlineData(0.174, 6)]
    [InlineData(0.18, 8)]
    [InlineData(0.5, 8)]
    public void Rows_are_twice_the_radius_in_rings_even_and_between_four_and_eight(double radius, int rows)
    {
        SocketBlueprint socket = SocketSizing.Size(41, 10.6, radius, 0.01, 0.05, 0.05, 0, SocketBounds.Limb);
        Assert.Equal(rows, socket.Rows);
        Assert.Equal(4, socket.Columns);
    }

    [Theory]
    [InlineData(0.05, 4)]
    [InlineData(0.126, 6)]
    [InlineData(0.5, 6)]
    public void Columns_are_twice_the_radius_in_segments_even_and_between_four_and_six(double radius, int columns) =>
        Assert.Equal(columns, SocketSizing.Size(41, 10.6, 0.01, radius, 0.05, 0.05, 0, SocketBounds.Limb).Columns);

    [Theory]
    [InlineData(3, 4, 4)]
    [InlineData(4, 6, 4)]
    [InlineData(5, 8, 4)]
    [InlineData(6, 8, 6)]
    [InlineData(9, 8, 6)]
    public void Toes_make_room_along_the_body_first_then_around_it(int toes, int rows, int columns)
    {
        SocketBlueprint socket = SocketSizing.Size(30, 10, 0.01, 0.01, 0.05, 0.05, toes, SocketBounds.Limb);
        Assert.Equal(rows, socket.Rows);
        Assert.Equal(columns, socket.Columns);
    }

    [Fact]
    public void Insects_have_two_by_two_cells_whatever_their_legs()
    {
        SocketBlueprint socket = SocketSizing.Size(28, 10, 0.4, 0.4, 0.03, 0.03, 5, SocketBounds.Insect);
        Assert.Equal(new SocketBlueprint(27, 9, 2, 2), socket);
    }

    [Fact]
    public void A_socket_is_centred_on_its_ring_and_segment()
    {
        Assert.Equal(new SocketBlueprint(39, 9, 4, 4), SocketSizing.Centre(41, 10.6, 4, 4));
        Assert.Equal(new SocketBlueprint(24, 5, 6, 2), SocketSizing.Centre(27, 6, 6, 2));
        Assert.Equal(new SocketBlueprint(20, 9, 4, 2), SocketSizing.Centre(22, 10, 4, 2));
    }

    [Fact]
    public void A_socket_ends_before_the_midline_and_before_the_ends_of_the_body()
    {
        var stream = new RandomStream(5);
        for (int n = 0; n < 2000; n++)
        {
            int rows = 2 * stream.Integer(1, 5);
            int columns = 2 * stream.Integer(1, 4);
            SocketBlueprint socket = SocketSizing.Centre(stream.Uniform(0, 54), stream.Uniform(0, 16), rows, columns);
            Assert.True(socket.Segment >= 1 && socket.Segment + columns <= 15);
            Assert.True(new SocketGrid().IsFree(socket, 1));
        }

        Assert.Equal(11, SocketSizing.Centre(30, 14, 4, 4).Segment);
    }

    [Fact]
    public void Segments_of_a_circle_divide_its_circumference() =>
        Assert.Equal(System.Math.PI * 0.3 / 32, SocketSizing.SegmentSpacing(0.3, 0.3), 12);
}
