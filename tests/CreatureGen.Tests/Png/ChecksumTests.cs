using System;
using System.Linq;
using System.Text;
using CreatureGen.Png;
using Xunit;

namespace CreatureGen.Tests.Png;

public sealed class ChecksumTests
{
    [Theory]
    [InlineData("", 0x00000000u)]
    [InlineData("123456789", 0xCBF43926u)]
    [InlineData("IEND", 0xAE426082u)]
    [InlineData("The quick brown fox jumps over the lazy dog", 0x414FA339u)]
    public void Crc_has_the_known_value(string text, uint expected) =>
        Assert.Equal(expected, Crc32.Finish(Crc32.Append(Crc32.Start, Encoding.ASCII.GetBytes(text))));

    [Theory]
    [InlineData("", 0x00000001u)]
    [InlineData("a", 0x00620062u)]
    [InlineData("123456789", 0x091E01DEu)]
    [InlineData("Wikipedia", 0x11E60398u)]
    public void Adler_has_the_known_value(string text, uint expected) => Assert.Equal(expected, Adler32.Of(Encoding.ASCII.GetBytes(text)));

    [Fact]
    public void Crc_in_pieces_is_that_of_the_whole()
    {
        byte[] bytes = new byte[1000];
        new Random(4).NextBytes(bytes);
        uint whole = Crc32.Append(Crc32.Start, bytes);
        foreach (int cut in new[] { 0, 1, 7, 500, 999, 1000 })
        {
            Assert.Equal(whole, Crc32.Append(Crc32.Append(Crc32.Start, bytes.AsSpan(0, cut)), bytes.AsSpan(cut)));
        }
    }

    [Fact]
    public void Adler_of_two_pieces_joins_to_that_of_the_whole()
    {
        byte[] bytes = Enumerable.Repeat((byte)255, 200_000).ToArray();
        new Random(5).NextBytes(bytes.AsSpan(0, 100_000));
        uint whole = Adler32.Of(bytes);
        foreach (int cut in new[] { 0, 1, 7, 99_999, 131_072, 199_999, 200_000 })
        {
            Assert.Equal(whole, Adler32.Joined(Adler32.Of(bytes.AsSpan(0, cut)), Adler32.Of(bytes.AsSpan(cut)), bytes.Length - cut));
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(7)]
    [InlineData(8)]
    [InlineData(9)]
    [InlineData(5560)]
    [InlineData(50_003)]
    public void Adler_is_what_one_byte_after_the_other_gives(int length)
    {
        byte[] bytes = new byte[length];
        new Random(length).NextBytes(bytes);
        ulong a = 1;
        ulong b = 0;
        foreach (byte value in bytes)
        {
            a = (a + value) % 65521;
            b = (b + a) % 65521;
        }

        Assert.Equal((uint)((b << 16) | a), Adler32.Of(bytes));
    }

    [Theory]
    [InlineData(5551)]
    [InlineData(5552)]
    [InlineData(5553)]
    [InlineData(300_000)]
    public void Adler_of_the_largest_bytes_does_not_overflow(int length)
    {
        // The definition of RFC 1950 with a remainder after every byte.
        ulong a = 1;
        ulong b = 0;
        for (int i = 0; i < length; i++)
        {
            a = (a + 255) % 65521;
            b = (b + a) % 65521;
        }

        Assert.Equal((uint)((b << 16) | a), Adler32.Of(Enumerable.Repeat((byte)255, length).ToArray()));
    }
}
