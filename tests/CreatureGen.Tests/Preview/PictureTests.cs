using System;
using System.IO;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;
using CreatureGen.Tests.Png;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class PictureTests
{
    [Theory]
    [InlineData(PixelLayout.Rgb, 1, 1)]
    [InlineData(PixelLayout.Rgb, 33, 7)]
    [InlineData(PixelLayout.Rgba, 1, 1)]
    [InlineData(PixelLayout.Rgba, 33, 7)]
    public void A_picture_saved_as_PNG_reads_back_byte_for_byte(PixelLayout layout, int width, int height)
    {
        var picture = new Picture(width, height, layout);
        var random = new Random(1);
        for (int y = 0; y < height; y++)
        {
            random.NextBytes(picture.Row(y));
        }

        var file = new PngFile(PngWriter.ToBytes(picture));
        Assert.Equal(picture.BytesPerPixel, file.BytesPerPixel);
        Assert.Equal(picture.Bytes.ToArray(), file.Pixels());
    }

    [Theory]
    [InlineData(-2, -1)]
    [InlineData(3, 4)]
    [InlineData(0, 0)]
    [InlineData(-9, 0)]
    [InlineData(9, 9)]
    public void A_copied_picture_lands_in_its_place_and_what_lies_outside_is_left_out(int left, int top)
    {
        foreach (PixelLayout layout in new[] { PixelLayout.Rgb, PixelLayout.Rgba })
        {
            var source = new Picture(4, 3, layout);
            source.Fill(new Pixel(1, 2, 3));
            var target = new Picture(6, 6, PixelLayout.Rgb);
            target.Blit(source, left, top);
            for (int y = 0; y < 6; y++)
            {
                for (int x = 0; x < 6; x++)
                {
                    bool inside = x >= left && x < left + 4 && y >= top && y < top + 3;
                    Assert.Equal(inside ? new Pixel(1, 2, 3) : new Pixel(0, 0, 0), target[x, y]);
                }
            }
        }
    }

    [Fact]
    public void Half_opaque_white_over_black_is_grey_and_over_nothing_half_opaque_white()
    {
        var over = new Picture(1, 1, PixelLayout.Rgba) { [0, 0] = new Pixel(255, 255, 255, 128) };
        var black = new Picture(1, 1, PixelLayout.Rgb);
        black.Overlay(over, 0, 0);
        Assert.Equal(new Pixel(128, 128, 128), black[0, 0]);
        var nothing = new Picture(1, 1, PixelLayout.Rgba);
        nothing.Overlay(over, 0, 0);
        Assert.Equal(new Pixel(255, 255, 255, 128), nothing[0, 0]);
    }

    [Theory]
    [InlineData(0, 1)]
    [InlineData(1, 0)]
    [InlineData(32769, 1)]
    [InlineData(32768, 32768)]
    public void Sizes_out_of_range_are_refused(int width, int height) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new Picture(width, height, PixelLayout.Rgba));

    [Theory]
    [InlineData(-1, 0)]
    [InlineData(2, 0)]
    [InlineData(0, 2)]
    public void Pixels_outside_are_refused(int x, int y) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new Picture(2, 2, PixelLayout.Rgb)[x, y]);

    [Fact]
    public void A_stream_that_cannot_be_written_is_refused() =>
        Assert.Throws<ArgumentException>(() => PngWriter.Write(new Picture(1, 1, PixelLayout.Rgb), new MemoryStream([], false)));
}
