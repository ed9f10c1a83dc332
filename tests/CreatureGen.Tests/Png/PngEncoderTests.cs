using System;
using System.IO;
using System.Linq;
using CreatureGen.Png;
using Xunit;

namespace CreatureGen.Tests.Png;

public sealed class PngEncoderTests
{
    public static TheoryData<string, int, int, PngPixels> Pictures { get; } = MakePictures();

    [Theory]
    [MemberData(nameof(Pictures))]
    public void A_picture_reads_back_byte_for_byte(string kind, int width, int height, PngPixels layout)
    {
        byte[] pixels = Make(kind, width, height, layout);
        var file = new PngFile(Encode(pixels, width, height, layout));
        Assert.Equal((width, height), (file.Width, file.Height));
        Assert.Equal(layout == PngPixels.Rgb ? 3 : 4, file.BytesPerPixel);
        Assert.Equal(pixels, file.Pixels());
    }

    [Theory]
    [MemberData(nameof(Pictures))]
    public void Chunks_are_in_order_and_their_checksums_right(string kind, int width, int height, PngPixels layout)
    {
        var file = new PngFile(Encode(Make(kind, width, height, layout), width, height, layout));
        Assert.Equal(["IHDR", "sRGB", "IDAT", "IEND"], file.Chunks.Select(c => c.Type));
        Assert.All(file.Chunks, c => Assert.Equal(c.ComputedCrc(), c.StoredCrc));
        Assert.Equal([8, (byte)(layout == PngPixels.Rgb ? 2 : 6), 0, 0, 0], file.Header.Data[8..]);
        Assert.Empty(file.Chunks[^1].Data);
    }

    [Fact]
    public void A_weave_a_slope_and_equal_rows_take_their_filters()
    {
        const int Stride = 64 * 3;
        byte[] pixels = new byte[Stride * 3];
        for (int i = 0; i < Stride; i++)
        {
            pixels[i] = (byte)(i / 3 % 2 == 0 ? 5 : 251);
            pixels[Stride + i] = (byte)(i / 3 * 3);
            pixels[(2 * Stride) + i] = pixels[Stride + i];
        }

        Assert.Equal([0, 1, 2], new PngFile(Encode(pixels, 64, 3, PngPixels.Rgb)).Filters());
    }

    [Fact]
    public void Rows_that_a_mean_or_Paeths_guess_foretells_take_their_filters()
    {
        const int Stride = 50 * 3;
        byte[] mean = new byte[Stride * 2];
        byte[] paeth = new byte[Stride * 2];
        var random = new Random(6);
        for (int i = 0; i < Stride; i++)
        {
            mean[i] = paeth[i] = (byte)random.Next(256);
            int left = i < 3 ? 0 : mean[Stride + i - 3];
            mean[Stride + i] = (byte)((left + mean[i]) / 2);
            paeth[Stride + i] = i < 3 ? (byte)(paeth[i] + 9) : Nearest(paeth[Stride + i - 3], paeth[i], paeth[i - 3]);
        }

        Assert.Equal(3, new PngFile(Encode(mean, 50, 2, PngPixels.Rgb)).Filters()[1]);
        Assert.Equal(4, new PngFile(Encode(paeth, 50, 2, PngPixels.Rgb)).Filters()[1]);

        static byte Nearest(int left, int up, int corner)
        {
            int estimate = left + up - corner;
            return (byte)new[] { left, up, corner }.MinBy(c => Math.Abs(estimate - c));
        }
    }

    [Fact]
    public void A_stream_is_written_from_its_present_position_and_stays_open()
    {
        var stream = new MemoryStream();
        stream.WriteByte(1);
        PngEncoder.Write([1, 2, 3], 1, 1, PngPixels.Rgb, stream);
        PngEncoder.Write([4, 5, 6], 1, 1, PngPixels.Rgb, stream);
        byte[] one = Encode([1, 2, 3], 1, 1, PngPixels.Rgb);
        byte[] two = Encode([4, 5, 6], 1, 1, PngPixels.Rgb);
        Assert.Equal([1, .. one, .. two], stream.ToArray());
    }

    [Theory]
    [InlineData(0, 1, 0)]
    [InlineData(1, 0, 0)]
    [InlineData(2, 2, 11)]
    [InlineData(2, 2, 13)]
    [InlineData(65536, 65536, 0)]
    public void Bytes_that_do_not_fit_the_size_are_refused(int width, int height, int length) =>
        Assert.Throws<ArgumentException>(() => PngEncoder.Write(new byte[length], width, height, PngPixels.Rgb, new MemoryStream()));

    [Fact]
    public void A_stream_that_cannot_be_written_is_refused() =>
        Assert.Throws<ArgumentException>(() => PngEncoder.Write(new byte[3], 1, 1, PngPixels.Rgb, new MemoryStream([], false)));

    private static byte[] Encode(byte[] pixels, int width, int height, PngPixels layout)
    {
        var stream = new MemoryStream();
        PngEncoder.Write(pixels, width, height, layout, stream);
        return stream.ToArray();
    }

    private static TheoryData<string, int, int, PngPixels> MakePictures()
    {
        var data = new TheoryData<string, int, int, PngPixels>();
        foreach (string kind in new[] { "flat", "random", "slope" })
        {
            foreach (PngPixels layout in new[] { PngPixels.Rgb, PngPixels.Rgba })
            {
                foreach ((int width, int height) in new[] { (1, 1), (1, 17), (17, 1), (7, 5), (101, 63), (256, 256) })
                {
                    data.Add(kind, width, height, layout);
                }
            }
        }

        return data;
    }

    private static byte[] Make(string kind, int width, int height, PngPixels layout)
    {
        int step = layout == PngPixels.Rgb ? 3 : 4;
        byte[] pixels = new byte[width * height * step];
        var random = new Random(width + height);
        for (int i = 0; i < pixels.Length; i++)
        {
            int x = i / step % width;
            int y = i / step / width;
            pixels[i] = kind switch
            {
                "flat" => (byte)(40 + (i % step)),
                "random" => (byte)random.Next(256),
                _ => (byte)((x * 2) + y + (i % step * 30)),
            };
        }

        return pixels;
    }
}
