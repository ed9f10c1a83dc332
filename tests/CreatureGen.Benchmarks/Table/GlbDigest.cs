using System;
using System.Globalization;
using System.IO;
using System.Security.Cryptography;
using CreatureGen.Gltf;

namespace CreatureGen.Benchmarks.Table;

/// <summary>A hash of the files of many seeds: a change that only makes the library faster leaves it as it was.</summary>
internal static class GlbDigest
{
    /// <summary>One line per seed, then one of all together.</summary>
    public static void Print(TextWriter output, int seeds)
    {
        using var all = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        using var stream = new MemoryStream();
        for (int seed = 0; seed < seeds; seed++)
        {
            stream.SetLength(0);
            string line;
            try
            {
                GlbWriter.Write(CreatureGenerator.Generate((ulong)seed), GltfOptions.Default, stream);
                line = Convert.ToHexString(SHA256.HashData(stream.GetBuffer().AsSpan(0, (int)stream.Length)));
            }
            catch (Exception e) when (e is ArgumentException or InvalidOperationException or IndexOutOfRangeException)
            {
                line = e.GetType().Name + ": " + e.Message.Split('\n')[0];
            }

            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{seed,6} {line}"));
            all.AppendData(System.Text.Encoding.UTF8.GetBytes(line));
        }

        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{seeds,6} seeds {Convert.ToHexString(all.GetHashAndReset())}"));
    }
}
