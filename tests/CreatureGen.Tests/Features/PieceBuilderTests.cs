using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Features;
using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Features;

public sealed class PieceBuilderTests
{
    [Fact]
    public void A_circle_is_exactly_symmetric()
    {
        for (int count = 3; count <= UnitCircle.MaxCount; count++)
        {
            for (int k = 1; k < count; k++)
            {
                Vector2 here = UnitCircle.Directions(count)[k];
                Vector2 there = UnitCircle.Directions(count)[count - k];
                Assert.Equal(here.X, there.X);
                Assert.Equal(here.Y, -there.Y);
                Assert.Equal(1f, here.Length(), 1e-6f);
            }
        }
    }

    [Theory]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(7)]
    [InlineData(12)]
    public void A_ring_filled_below_and_fanned_above_is_closed(int sides)
    {
        var builder = new PieceBuilder();
        foreach (Vector2 d in UnitCircle.Directions(sides))
        {
            // Seen from above (+Y) the ring runs counter-clockwise.
            builder.Vertex(new Vector3(d.X, 0f, -d.Y), new Vector3(d.X, 0f, -d.Y), Vector3.One);
        }

        int pole = builder.Vertex(Vector3.UnitY, Vector3.UnitY, Vector3.One);
        builder.FillBelow(0, sides);
        builder.Fan(0, pole, sides);
        PieceChecks.IsSound(builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere));
        Assert.Equal(3 * ((2 * sides) - 2), builder.IndexCount);
    }

    [Fact]
    public void A_cleared_builder_starts_again()
    {
        var builder = new PieceBuilder();
        NailShape.Append(builder, Vector3.UnitY, Vector3.UnitZ, 0.1f, 0f, Vector3.One * 0.5f);
        Piece first = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
        builder.Clear();
        NailShape.Append(builder, Vector3.UnitY, Vector3.UnitZ, 0.1f, 0f, Vector3.One * 0.5f);
        Piece second = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
        Assert.Equal(first.Positions, second.Positions);
        Assert.Equal(first.Triangles, second.Triangles);
    }
}
