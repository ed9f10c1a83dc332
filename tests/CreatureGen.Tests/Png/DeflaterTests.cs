using System;
using System.Linq;
using System.Text;
using CreatureGen.Png;
using Xunit;

namespace CreatureGen.Tests.Png;

public sealed class DeflaterTests
{
    public static TheoryData<string, int> Inputs { get; } = MakeInputs();

    [Theory]
    [MemberData(nameof(Inputs))]
    public void What_was_compressed_inflates_to_itself(string kind, int length)
    {
        byte[] plain = Make(kind, length);
        byte[] packed = Deflater.Compress(plain).Bytes.ToArray();
        Assert.Equal(plain, PngFile.Inflate(packed));
    }

    [Theory]
    [MemberData(nameof(Inputs))]
    public void A_stream_starts_and_ends_as_zlib_asks(string kind, int length)
    {
        byte[] plain = Make(kind, length);
        byte[] packed = Deflater.Compress(plain).Bytes.ToArray();
        Assert.Equal(8, packed[0] & 15);
        Assert.Equal(0, ((packed[0] << 8) | packed[1]) % 31);
        uint stored = ((uint)packed[^4] << 24) | ((uint)packed[^3] << 16) | ((uint)packed[^2] << 8) | packed[^1];
        Assert.Equal(Adler32.Of(plain), stored);
    }

    [Fact]
    public void Noise_grows_by_no_more_than_the_headers_of_stored_blocks()
    {
        byte[] plain = Make("random", 200_000);
        Assert.InRange(Deflater.Compress(plain).Bytes.Length, plain.Length, plain.Length + 64);
    }

    [Fact]
    public void One_byte_over_and_over_takes_a_fraction_of_a_percent() =>
        Assert.InRange(Deflater.Compress(Make("flat", 1_000_000)).Bytes.Length, 1, 2000);

    [Fact]
    public void Text_takes_at_most_a_fifth_more_than_from_the_runtimes_own_compressor()
    {
        byte[] plain = Make("words", 200_000);
        var theirs = new System.IO.MemoryStream();
        using (var zlib = new System.IO.Compression.ZLibStream(theirs, System.IO.Compression.CompressionLevel.Optimal, true))
        {
            zlib.Write(plain);
        }

        Assert.InRange(Deflater.Compress(plain).Bytes.Length, 1, theirs.Length * 1.2);
    }

    // Symbols with the frequencies of Fibonacci's numbers need codes as long as their count, which is beyond the 15 bits allowed.
    [Fact]
    public void Codes_that_would_be_too_long_are_shortened_and_stay_a_prefix_code()
    {
        int[] frequencies = new int[30];
        frequencies[0] = frequencies[1] = 1;
        for (int i = 2; i < frequencies.Length; i++)
        {
            frequencies[i] = frequencies[i - 1] + frequencies[i - 2];
        }

        var code = new HuffmanCode(frequencies.Length);
        code.Build(frequencies, 15);
        Assert.All(code.Lengths, length => Assert.InRange(length, 1, 15));
        Assert.Equal(1.0, code.Lengths.Sum(length => Math.Pow(2, -length)));
        for (int i = 1; i < frequencies.Length; i++)
        {
            Assert.True(code.Lengths[i] <= code.Lengths[i - 1], $"symbol {i} is as frequent as {i - 1} or more, yet its code is longer");
        }
    }

    private static TheoryData<string, int> MakeInputs()
    {
        var data = new TheoryData<string, int>();
        foreach (string kind in new[] { "flat", "random", "words", "period", "sparse", "fibonacci" })
        {
            foreach (int length in new[] { 0, 1, 2, 3, 4, 5, 258, 259, 260, 4096, 32767, 32768, 32769, 65535, 65536, 70_001, 400_000, (1 << 20) - 1, 1 << 20, 1_300_001 })
            {
                data.Add(kind, length);
            }
        }

        return data;
    }

    private static byte[] Make(string kind, int length)
    {
        var random = new Random(length);
        byte[] bytes = new byte[length];
        switch (kind)
        {
            case "flat":
                Array.Fill(bytes, (byte)77);
                break;
            case "random":
                random.NextBytes(bytes);
                break;
            case "words":
                string[] words = ["horn", "claw", "membrane", "gill", " ", " ", "tail", "wing", "\n", "paw"];
                var text = new StringBuilder();
                while (text.Length < length)
                {
                    text.Append(words[random.Next(words.Length)]);
                }

                Encoding.ASCII.GetBytes(text.ToString(0, length)).CopyTo(bytes, 0);
                break;
            case "period":
                // Repeats at the largest distance that a match may have.
                random.NextBytes(bytes.AsSpan(0, Math.Min(length, 32768)));
                for (int i = 32768; i < length; i++)
                {
                    bytes[i] = bytes[i - 32768];
                }

                break;
            case "sparse":
                for (int i = 0; i < length; i += 1 + random.Next(300))
                {
                    bytes[i] = (byte)random.Next(256);
                }

                break;
            case "fibonacci":
                // Each symbol about 1.6 times as frequent as the one before, in random order.
                for (int i = 0; i < length; i++)
                {
                    bytes[i] = (byte)(Math.Log(1 - random.NextDouble()) / Math.Log(0.618));
                }

                break;
            default:
                throw new ArgumentOutOfRangeException(nameof(kind), kind, "unknown");
        }

        return bytes;
    }
}
