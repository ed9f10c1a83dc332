using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Security.Cryptography;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Sampling;

namespace CreatureGen.Digest;

/// <summary>A line of the golden file of poses: how a creature went through <see cref="PoseScript"/>, told by a hash.</summary>
/// <param name="Plan">Its body plan.</param>
/// <param name="Seed">Its seed.</param>
/// <param name="Sha256">SHA-256 of the bits of root, local pose and events of every update, in lower-case hexadecimal digits.</param>
public sealed record PoseEntry(BodyPlan Plan, ulong Seed, string Sha256)
{
    /// <summary>The entry as the library would have it now.</summary>
    public static PoseEntry Compute(BodyPlan plan, ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { BodyPlans = BodyPlanWeight.Only(plan) });
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        new PoseScript(creature, new BitHash(hash)).Run();
        return new PoseEntry(plan, seed, Convert.ToHexStringLower(hash.GetHashAndReset()));
    }

    /// <summary>The entries of a golden file in its order; lines that begin with # are remarks.</summary>
    /// <exception cref="FormatException">A line is none of an entry.</exception>
    public static IReadOnlyList<PoseEntry> Parse(string text) =>
        text.ReplaceLineEndings("\n").Split('\n').Where(l => l.Length > 0 && l[0] != '#').Select(ParseLine).ToArray();

    /// <summary>The text of a golden file: the remarks of an old one, then the entries.</summary>
    public static string Format(string old, IEnumerable<PoseEntry> entries) =>
        string.Concat(old.ReplaceLineEndings("\n").Split('\n').Where(l => l.StartsWith('#')).Concat(entries.Select(e => e.ToString())).Select(l => l + "\n"));

    /// <inheritdoc/>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Plan} {Seed} {Sha256}");

    private static PoseEntry ParseLine(string line)
    {
        string[] words = line.Split(' ');
        return words.Length == 3 && Enum.TryParse(words[0], out BodyPlan plan) && ulong.TryParse(words[1], NumberStyles.None, CultureInfo.InvariantCulture, out ulong seed)
            ? new PoseEntry(plan, seed, words[2])
            : throw new FormatException($"\"{line}\"; expected body plan, seed and SHA-256");
    }
}
