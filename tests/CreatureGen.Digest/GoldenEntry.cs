using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Sampling;

namespace CreatureGen.Digest;

/// <summary>A line of the golden file: the file of a creature, told by its hash.</summary>
/// <param name="Kind">The kind that was asked for.</param>
/// <param name="Seed">The seed.</param>
/// <param name="Sha256">SHA-256 of the bytes of its GLB, in lower-case hexadecimal digits.</param>
public sealed record GoldenEntry(RequestedKind Kind, ulong Seed, string Sha256)
{
    private static readonly RequestedKind[] Kinds = Enum.GetValues<RequestedKind>();

    /// <summary>The entry as the library would have it now.</summary>
    public static GoldenEntry Compute(RequestedKind kind, ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });
        using var stream = new MemoryStream();
        GlbWriter.Write(creature, GltfOptions.Default, stream);
        return new GoldenEntry(kind, seed, Convert.ToHexStringLower(SHA256.HashData(stream.GetBuffer().AsSpan(0, (int)stream.Length))));
    }

    /// <summary>The entries of a golden file in its order; lines that begin with # are remarks.</summary>
    /// <exception cref="FormatException">A line is none of an entry.</exception>
    public static IReadOnlyList<GoldenEntry> Parse(string text) =>
        text.ReplaceLineEndings("\n").Split('\n').Where(l => l.Length > 0 && l[0] != '#').Select(ParseLine).ToArray();

    /// <summary>The text of a golden file: the remarks of an old one, then the entries.</summary>
    public static string Format(string old, IEnumerable<GoldenEntry> entries) =>
        string.Concat(old.ReplaceLineEndings("\n").Split('\n').Where(l => l.StartsWith('#')).Concat(entries.Select(e => e.ToString())).Select(l => l + "\n"));

    /// <inheritdoc/>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{NameOf(Kind)} {Seed} {Sha256}");

    private static GoldenEntry ParseLine(string line)
    {
        string[] words = line.Split(' ');
        int kind = Array.FindIndex(Kinds, k => NameOf(k) == words[0]);
        return words.Length == 3 && kind >= 0 && ulong.TryParse(words[1], NumberStyles.None, CultureInfo.InvariantCulture, out ulong seed)
            ? new GoldenEntry(Kinds[kind], seed, words[2])
            : throw new FormatException($"\"{line}\"; expected kind, seed and SHA-256");
    }

    private static string NameOf(RequestedKind kind) => kind.ToString().ToLowerInvariant();
}
