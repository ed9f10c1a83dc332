using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Security.Cryptography;
using System.Text;

namespace CreatureGen.Digest;

/// <summary>A line of the list of versions: what the golden file was while the algorithm had a number.</summary>
/// <param name="Algorithm">The number of the algorithm.</param>
/// <param name="Sha256">SHA-256 of the golden file's entries, in lower-case hexadecimal digits.</param>
public sealed record GoldenVersion(int Algorithm, string Sha256)
{
    /// <summary>The line of an algorithm that gives these entries.</summary>
    public static GoldenVersion Of(int algorithm, IEnumerable<GoldenEntry> entries) =>
        new(algorithm, Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(GoldenEntry.Format("", entries)))));

    /// <summary>The lines of a list in its order; those that begin with # are remarks.</summary>
    /// <exception cref="FormatException">A line is none of a version.</exception>
    public static IReadOnlyList<GoldenVersion> Parse(string text) =>
        text.ReplaceLineEndings("\n").Split('\n').Where(l => l.Length > 0 && l[0] != '#').Select(ParseLine).ToArray();

    /// <summary>The list with one more version. One that is in it already is left as it is.</summary>
    /// <exception cref="InvalidOperationException">The algorithm of that number gave something else: it is another algorithm and needs a number of its own.</exception>
    public static string Append(string list, GoldenVersion version)
    {
        GoldenVersion? known = Parse(list).FirstOrDefault(v => v.Algorithm == version.Algorithm);
        if (known is not null && known != version)
        {
            throw new InvalidOperationException($"algorithm {version.Algorithm} is known by other bytes; raise CreatureBlueprint.CurrentAlgorithm to {version.Algorithm + 1}, build and renew again");
        }

        return known is null ? list.ReplaceLineEndings("\n") + version + "\n" : list;
    }

    /// <inheritdoc/>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Algorithm} {Sha256}");

    private static GoldenVersion ParseLine(string line)
    {
        string[] words = line.Split(' ');
        return words.Length == 2 && int.TryParse(words[0], NumberStyles.None, CultureInfo.InvariantCulture, out int algorithm)
            ? new GoldenVersion(algorithm, words[1])
            : throw new FormatException($"\"{line}\"; expected the number of an algorithm and SHA-256");
    }
}
