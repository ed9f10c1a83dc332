using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;
using CreatureGen.Tests.Png;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class AnimatedPngWriterTests
{
    [Theory]
    [InlineData(PixelLayout.Rgb)]
    [InlineData(PixelLayout.Rgba)]
    public void Every_frame_reads_back_byte_for_byte(PixelLayout layout)
    {
        Picture[] frames = Moving(layout);
        List<byte[]> read = Frames(new PngFile(Write(frames, 40)));
        Assert.Equal(frames.Length, read.Count);
        for (int i = 0; i < frames.Length; i++)
        {
            Assert.Equal(frames[i].Bytes.ToArray(), read[i]);
        }
    }

    [Fact]
    public void Chunks_are_in_order_their_checksums_right_and_their_numbers_without_gaps()
    {
        Picture[] frames = Moving(PixelLayout.Rgb);
        var file = new PngFile(Write(frames, 40));
        string[] expected = ["IHDR", "sRGB", "acTL", "fcTL", "IDAT", .. Enumerable.Repeat(new[] { "fcTL", "fdAT" }, frames.Length - 1).SelectMany(c => c), "IEND"];
        Assert.Equal(expected, file.Chunks.Select(c => c.Type));
        Assert.All(file.Chunks, c => Assert.Equal(c.ComputedCrc(), c.StoredCrc));
        Assert.Equal(Enumerable.Range(0, (2 * frames.Length) - 1), file.Chunks.Where(c => c.Type is "fcTL" or "fdAT").Select(c => c.Number(0)));
        PngChunk control = file.Chunks.Single(c => c.Type == "acTL");
        Assert.Equal((frames.Length, 0), (control.Number(0), control.Number(4)));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(40)]
    [InlineData(333)]
    [InlineData(65535)]
    public void Every_frame_shows_for_the_time_asked_for(int milliseconds)
    {
        var file = new PngFile(Write(Moving(PixelLayout.Rgb), milliseconds));
        Assert.All(file.Chunks.Where(c => c.Type == "fcTL"), c =>
        {
            int numerator = (c.Data[20] << 8) | c.Data[21];
            int denominator = (c.Data[22] << 8) | c.Data[23];
            Assert.Equal(milliseconds, numerator * 1000.0 / denominator);
        });
    }

    [Fact]
    public void The_first_frame_is_whole_and_the_others_are_what_changed()
    {
        var before = new Picture(20, 10, PixelLayout.Rgb);
        var after = new Picture(20, 10, PixelLayout.Rgb);
        after[7, 3] = new Pixel(0, 0, 1);
        after[12, 6] = new Pixel(1, 0, 0);
        var file = new PngFile(Write([before, after, after], 10));
        int[][] places = file.Chunks.Where(c => c.Type == "fcTL").Select(c => new[] { c.Number(12), c.Number(16), c.Number(4), c.Number(8) }).ToArray();
        Assert.Equal([0, 0, 20, 10], places[0]);
        Assert.Equal([7, 3, 6, 4], places[1]);
        Assert.Equal((1, 1), (places[2][2], places[2][3]));
    }

    [Fact]
    public void A_change_of_any_one_pixel_is_kept()
    {
        for (int at = 0; at < 5 * 4; at++)
        {
            var before = new Picture(5, 4, PixelLayout.Rgba);
            var after = new Picture(5, 4, PixelLayout.Rgba);
            after[at % 5, at / 5] = new Pixel(9, 8, 7, 6);
            List<byte[]> read = Frames(new PngFile(Write([before, after, before], 10)));
            Assert.Equal(after.Bytes.ToArray(), read[1]);
            Assert.Equal(before.Bytes.ToArray(), read[2]);
        }
    }

    [Fact]
    public void A_file_of_one_frame_is_whole()
    {
        Picture only = Moving(PixelLayout.Rgb)[0];
        var file = new PngFile(Write([only], 10));
        Assert.Equal(only.Bytes.ToArray(), file.Pixels());
        Assert.Equal("IEND", file.Chunks[^1].Type);
    }

    [Fact]
    public void Frames_of_another_size_or_too_many_are_refused()
    {
        var writer = new AnimatedPngWriter(new MemoryStream(), 2, 10);
        writer.Add(new Picture(3, 3, PixelLayout.Rgb));
        Assert.Throws<ArgumentException>(() => writer.Add(new Picture(3, 4, PixelLayout.Rgb)));
        Assert.Throws<ArgumentException>(() => writer.Add(new Picture(3, 3, PixelLayout.Rgba)));
        writer.Add(new Picture(3, 3, PixelLayout.Rgb));
        Assert.Throws<InvalidOperationException>(() => writer.Add(new Picture(3, 3, PixelLayout.Rgb)));
    }

    [Theory]
    [InlineData(0, 10)]
    [InlineData(1, 0)]
    [InlineData(1, 65536)]
    public void Numbers_out_of_range_are_refused(int frames, int milliseconds) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new AnimatedPngWriter(new MemoryStream(), frames, milliseconds));

    private static byte[] Write(Picture[] frames, int milliseconds)
    {
        var stream = new MemoryStream();
        var writer = new AnimatedPngWriter(stream, frames.Length, milliseconds);
        foreach (Picture frame in frames)
        {
            writer.Add(frame);
        }

        return stream.ToArray();
    }

    // A spot that walks over noise, and stands still once.
    private static Picture[] Moving(PixelLayout layout)
    {
        var random = new Random(3);
        var ground = new Picture(31, 23, layout);
        for (int y = 0; y < ground.Height; y++)
        {
            random.NextBytes(ground.Row(y));
        }

        return new[] { 0, 3, 3, 11, 27 }.Select(x =>
        {
            var frame = new Picture(ground.Width, ground.Height, layout);
            frame.Blit(ground, 0, 0);
            frame.Fill(new Pixel(200, 30, 90, 128), x, x / 2, 6, 5);
            return frame;
        }).ToArray();
    }

    // What a viewer shows, frame by frame: each rectangle replaces what was there.
    private static List<byte[]> Frames(PngFile file)
    {
        int step = file.BytesPerPixel;
        byte[] canvas = new byte[file.Width * file.Height * step];
        var frames = new List<byte[]>();
        PngChunk? control = null;
        foreach (PngChunk chunk in file.Chunks)
        {
            if (chunk.Type == "fcTL")
            {
                control = chunk;
                Assert.Equal((0, 0), (chunk.Data[24], chunk.Data[25]));
            }
            else if (chunk.Type is "IDAT" or "fdAT")
            {
                int width = control!.Number(4);
                int height = control.Number(8);
                byte[] part = file.Pixels(chunk.Type == "IDAT" ? chunk.Data : chunk.Data[4..], width, height);
                for (int y = 0; y < height; y++)
                {
                    part.AsSpan(y * width * step, width * step).CopyTo(canvas.AsSpan((((control.Number(16) + y) * file.Width) + control.Number(12)) * step));
                }

                frames.Add([.. canvas]);
            }
        }

        return frames;
    }
}
