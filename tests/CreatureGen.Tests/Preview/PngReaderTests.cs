using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class PngReaderTests
{
    [Theory]
    [InlineData(PixelLayout.Rgb)]
    [InlineData(PixelLayout.Rgba)]
    public void What_was_written_is_read_back(PixelLayout layout)
    {
        var picture = new Picture(37, 23, layout);
        for (int y = 0; y < picture.Height; y++)
        {
            for (int x = 0; x < picture.Width; x++)
            {
                picture[x, y] = new Pixel((byte)(x * 7), (byte)(y * 11), (byte)(x * y), layout == PixelLayout.Rgb ? (byte)255 : (byte)(x + y));
            }
        }

        Picture read = PngReader.Read(PngWriter.ToBytes(picture));
        Assert.Equal((37, 23, PixelLayout.Rgba), (read.Width, read.Height, read.Layout));
        Assert.All(Enumerable.Range(0, 37 * 23), i => Assert.Equal(picture[i % 37, i / 37], read[i % 37, i / 37]));
    }

    // Two pixels of each form, by the specification: samples from the highest bit, colours that are clear in tRNS.
    [Theory]
    [InlineData(0, 1, new byte[] { 0b0100_0000 }, null, null, new byte[] { 0, 0, 0, 255, 255, 255, 255, 255 })]
    [InlineData(0, 2, new byte[] { 0b0110_0000 }, null, new byte[] { 0, 1 }, new byte[] { 85, 85, 85, 0, 170, 170, 170, 255 })]
    [InlineData(0, 4, new byte[] { 0x3F }, null, null, new byte[] { 51, 51, 51, 255, 255, 255, 255, 255 })]
    [InlineData(0, 16, new byte[] { 0x80, 0xFF, 0x01, 0x00 }, null, null, new byte[] { 128, 128, 128, 255, 1, 1, 1, 255 })]
    [InlineData(2, 8, new byte[] { 1, 2, 3, 4, 5, 6 }, null, new byte[] { 0, 4, 0, 5, 0, 6 }, new byte[] { 1, 2, 3, 255, 4, 5, 6, 0 })]
    [InlineData(2, 16, new byte[] { 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0 }, null, null, new byte[] { 1, 2, 3, 255, 4, 5, 6, 255 })]
    [InlineData(3, 4, new byte[] { 0x10 }, new byte[] { 9, 8, 7, 6, 5, 4 }, new byte[] { 33 }, new byte[] { 6, 5, 4, 255, 9, 8, 7, 33 })]
    [InlineData(4, 8, new byte[] { 10, 20, 30, 40 }, null, null, new byte[] { 10, 10, 10, 20, 30, 30, 30, 40 })]
    [InlineData(6, 16, new byte[] { 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0, 7, 0, 8, 0 }, null, null, new byte[] { 1, 2, 3, 4, 5, 6, 7, 8 })]
    public void Every_form_of_pixels_is_read(int colour, int depth, byte[] row, byte[]? palette, byte[]? clear, byte[] expected)
    {
        Picture read = PngReader.Read(Made(2, 1, depth, colour, 0, [0, .. row], palette, clear));
        Assert.Equal(expected, new[] { read[0, 0], read[1, 0] }.SelectMany(pixel => new[] { pixel.R, pixel.G, pixel.B, pixel.A }));
    }

    [Fact]
    public void Each_filter_is_undone_as_the_specification_says()
    {
        // Grey rows that come out as 10 20 30 each, by the filters none, sub, up, average and Paeth.
        byte[] rows = [0, 10, 20, 30, 1, 10, 10, 10, 2, 0, 0, 0, 3, 5, 5, 5, 4, 0, 0, 0];
        Picture read = PngReader.Read(Made(3, 5, 8, 0, 0, rows, null, null));
        Assert.All(Enumerable.Range(0, 5), y => Assert.Equal([10, 20, 30], Enumerable.Range(0, 3).Select(x => (int)read[x, y].R)));
    }

    [Fact]
    public void What_is_no_picture_is_told_in_words()
    {
        byte[] good = Made(2, 1, 8, 0, 0, [0, 1, 2], null, null);
        Assert.Equal("it does not start as a PNG file does", Refusal(Encoding.ASCII.GetBytes("GIF89a")));
        Assert.Equal("it ends before its end", Refusal(good[..^8]));
        Assert.Equal("it is interlaced; expected a file that is not", Refusal(Made(2, 1, 8, 0, 1, [0, 1, 2], null, null)));
        Assert.Equal("there is no colour type 5 of 8 bits", Refusal(Made(2, 1, 8, 5, 0, [0, 1, 2], null, null)));
        Assert.Equal("it holds fewer pixels than its header says", Refusal(Made(2, 9, 8, 0, 0, [0, 1, 2], null, null)));
        Assert.Equal("its palette has no colour 2", Refusal(Made(2, 1, 8, 3, 0, [0, 1, 2], [1, 1, 1, 2, 2, 2], null)));
        Assert.Equal("a row has the filter 7, which there is not", Refusal(Made(2, 1, 8, 0, 0, [7, 1, 2], null, null)));
        Assert.StartsWith("it is 30000 x 30000 pixels", Refusal(Made(30000, 30000, 8, 0, 0, [0], null, null)), StringComparison.Ordinal);
        Assert.All(Enumerable.Range(0, good.Length), length => Assert.Throws<InvalidDataException>(() => PngReader.Read(good.AsSpan(0, length))));
    }

    [Fact]
    public void An_outline_is_what_is_opaque_or_differs_from_the_edge()
    {
        var cut = new Picture(6, 4, PixelLayout.Rgba);
        cut.Fill(new Pixel(250, 250, 250), 2, 1, 2, 2);
        var plain = new Picture(6, 4, PixelLayout.Rgb);
        plain.Fill(new Pixel(200, 210, 220));
        plain.Fill(new Pixel(210, 200, 215), 0, 0, 1, 1);
        plain.Fill(new Pixel(20, 20, 20), 2, 1, 2, 2);
        foreach (Picture picture in new[] { cut, plain })
        {
            CreatureGen.Genetics.Criteria.OutlineMask mask = Cutout.Of(picture);
            Assert.Equal((6, 4), (mask.Width, mask.Height));
            Assert.All(Enumerable.Range(0, 24), i => Assert.Equal(i % 6 is 2 or 3 && i / 6 is 1 or 2 && i % 6 is 2 or 3, mask[i % 6, i / 6]));
        }

        Assert.Throws<ArgumentException>(() => Cutout.Of(new Picture(3, 3, PixelLayout.Rgba)));
    }

    private static string Refusal(byte[] file) => Assert.Throws<InvalidDataException>(() => PngReader.Read(file)).Message;

    private static byte[] Made(int width, int height, int depth, int colour, byte interlace, byte[] rows, byte[]? palette, byte[]? clear)
    {
        byte[] header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), height);
        (header[8], header[9], header[12]) = ((byte)depth, (byte)colour, interlace);
        var data = new MemoryStream();
        using (var zlib = new ZLibStream(data, CompressionMode.Compress, leaveOpen: true))
        {
            zlib.Write(rows);
        }

        return [0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, .. Chunk("IHDR", header), .. palette == null ? [] : Chunk("PLTE", palette), .. clear == null ? [] : Chunk("tRNS", clear), .. Chunk("IDAT", data.ToArray()), .. Chunk("IEND", [])];
    }

    private static byte[] Chunk(string type, byte[] content)
    {
        byte[] chunk = new byte[content.Length + 12];
        BinaryPrimitives.WriteInt32BigEndian(chunk, content.Length);
        Encoding.ASCII.GetBytes(type).CopyTo(chunk, 4);
        content.CopyTo(chunk, 8);
        return chunk;
    }
}
