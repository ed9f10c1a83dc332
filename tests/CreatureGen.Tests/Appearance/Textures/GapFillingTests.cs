using System;
using System.Linq;
using CreatureGen.Appearance.Textures;
using CreatureGen.Creatures;
using Xunit;

namespace CreatureGen.Tests.Appearance.Textures;

public sealed class GapFillingTests
{
    [Fact]
    public void A_gap_gets_the_mean_of_the_smallest_square_around_it_with_paint_in_it()
    {
        // Painted: two texels of the upper left quarter, one of the lower right one.
        byte[] picture = new byte[3 * 16];
        bool[] painted = new bool[16];
        Paint(0, 10, 20, 30);
        Paint(1, 20, 40, 61);
        Paint(15, 200, 100, 0);

        GapFilling.Fill(picture, painted, 4);

        Assert.Equal([10, 20, 30], Texel(0));
        Assert.Equal([20, 40, 61], Texel(1));
        Assert.Equal([15, 30, 46], Texel(4));
        Assert.Equal([15, 30, 46], Texel(5));
        Assert.Equal([200, 100, 0], Texel(10));

        // The other quarters have none: the mean of the quarters that have.
        Assert.Equal([108, 65, 23], Texel(2));
        Assert.Equal([108, 65, 23], Texel(12));

        void Paint(int texel, byte red, byte green, byte blue)
        {
            painted[texel] = true;
            (picture[3 * texel], picture[(3 * texel) + 1], picture[(3 * texel) + 2]) = (red, green, blue);
        }

        byte[] Texel(int texel) => picture[(3 * texel)..((3 * texel) + 3)];
    }

    [Fact]
    public void Where_nothing_is_painted_nothing_changes()
    {
        byte[] picture = [.. Enumerable.Range(0, 48).Select(i => (byte)i)];
        byte[] before = [.. picture];
        GapFilling.Fill(picture, new bool[16], 4);
        Assert.Equal(before, picture);
    }

    [Fact]
    public void What_is_painted_keeps_its_colour()
    {
        byte[] picture = [.. Enumerable.Range(0, 48).Select(i => (byte)(5 * i))];
        byte[] before = [.. picture];
        GapFilling.Fill(picture, [.. Enumerable.Repeat(true, 16)], 4);
        Assert.Equal(before, picture);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void An_atlas_has_no_grey_ground_between_its_charts(ulong seed)
    {
        ReadOnlySpan<byte> colour = CreatureTextures.Bake(CreatureGenerator.Generate(seed), 256).BaseColour;
        int grey = 0;
        for (int i = 0; i < colour.Length; i += 3)
        {
            grey += colour[i] == 128 && colour[i + 1] == 128 && colour[i + 2] == 128 ? 1 : 0;
        }

        // A fifth of the picture and more was left at the ground's grey before.
        Assert.InRange(grey, 0, colour.Length / 3 / 200);
    }
}
