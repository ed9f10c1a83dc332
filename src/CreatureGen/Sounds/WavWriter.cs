using System;
using System.Buffers.Binary;
using System.IO;

namespace CreatureGen.Sounds;

/// <summary>Writes sound as WAV files: one channel of 16-bit samples, without compression.</summary>
/// <remarks>Based on: IBM and Microsoft, "Multimedia programming interface and data specifications 1.0" (1991).</remarks>
public static class WavWriter
{
    private const int HeaderBytes = 44;
    private const int SampleBytes = 2;
    private const int Loudest = short.MaxValue;

    /// <summary>Writes a sound. The same samples give the same bytes.</summary>
    /// <param name="samples">−1..1; what is beyond is cut off.</param>
    /// <param name="rate">Samples per second, 1 000 to 384 000.</param>
    /// <param name="destination">Takes the bytes; is neither flushed nor closed.</param>
    /// <exception cref="ArgumentNullException">There is no destination.</exception>
    /// <exception cref="ArgumentException">The rate is out of its range, a sample is not a number, or there are more than a file holds.</exception>
    public static void Write(ReadOnlySpan<float> samples, int rate, Stream destination)
    {
        _ = destination ?? throw new ArgumentNullException(nameof(destination));
        if (rate is < 1_000 or > 384_000)
        {
            throw new ArgumentOutOfRangeException(nameof(rate), rate, "expected 1000 to 384000 samples per second");
        }

        if (samples.Length > (int.MaxValue - HeaderBytes) / SampleBytes)
        {
            throw new ArgumentException(FormattableString.Invariant($"{samples.Length} samples; expected {(int.MaxValue - HeaderBytes) / SampleBytes} at most"), nameof(samples));
        }

        int bytes = SampleBytes * samples.Length;
        byte[] file = new byte[HeaderBytes + bytes];
        Text(file, 0, "RIFF");
        BinaryPrimitives.WriteInt32LittleEndian(file.AsSpan(4), HeaderBytes - 8 + bytes);
        Text(file, 8, "WAVE");
        Text(file, 12, "fmt ");
        BinaryPrimitives.WriteInt32LittleEndian(file.AsSpan(16), 16);
        BinaryPrimitives.WriteInt16LittleEndian(file.AsSpan(20), 1);
        BinaryPrimitives.WriteInt16LittleEndian(file.AsSpan(22), 1);
        BinaryPrimitives.WriteInt32LittleEndian(file.AsSpan(24), rate);
        BinaryPrimitives.WriteInt32LittleEndian(file.AsSpan(28), SampleBytes * rate);
        BinaryPrimitives.WriteInt16LittleEndian(file.AsSpan(32), SampleBytes);
        BinaryPrimitives.WriteInt16LittleEndian(file.AsSpan(34), 8 * SampleBytes);
        Text(file, 36, "data");
        BinaryPrimitives.WriteInt32LittleEndian(file.AsSpan(40), bytes);
        for (int i = 0; i < samples.Length; i++)
        {
            if (float.IsNaN(samples[i]))
            {
                throw new ArgumentException(FormattableString.Invariant($"sample {i} is not a number; expected -1 to 1"), nameof(samples));
            }

            double level = Math.Round(Loudest * (double)Math.Max(-1f, Math.Min(1f, samples[i])));
            BinaryPrimitives.WriteInt16LittleEndian(file.AsSpan(HeaderBytes + (SampleBytes * i)), (short)level);
        }

        destination.Write(file, 0, file.Length);
    }

    private static void Text(byte[] file, int at, string word)
    {
        for (int i = 0; i < word.Length; i++)
        {
            file[at + i] = (byte)word[i];
        }
    }
}
