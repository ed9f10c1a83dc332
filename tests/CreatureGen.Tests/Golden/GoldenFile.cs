using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Digest;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Golden;

/// <summary>The hashes that were agreed, and how others are compared with them.</summary>
internal static class GoldenFile
{
    /// <summary>Where it is in the repository.</summary>
    public const string Place = "tests/CreatureGen.Tests/Golden/golden.txt";

    /// <summary>Where the list of versions is.</summary>
    public const string VersionsPlace = "tests/CreatureGen.Tests/Golden/versions.txt";

    /// <summary>Where the hashes of poses and of assets are.</summary>
    public const string PosesPlace = "tests/CreatureGen.Tests/Golden/poses.txt";
    public const string AssetsPlace = "tests/CreatureGen.Tests/Golden/assets.txt";

    /// <summary>Its text.</summary>
    public static string Text { get; } = RepositoryFiles.Text(Place);

    /// <summary>Its entries.</summary>
    public static IReadOnlyList<GoldenEntry> Entries { get; } = GoldenEntry.Parse(Text);

    /// <summary>Passes entries that are those expected, in their order.</summary>
    public static void AssertSame(IReadOnlyList<GoldenEntry> expected, IReadOnlyList<GoldenEntry> actual, string advice)
    {
        Assert.Equal(expected.Select(e => (e.Kind, e.Seed)), actual.Select(e => (e.Kind, e.Seed)));
        string[] wrong = expected.Zip(actual).Where(p => p.First != p.Second).Select(p => $"- {p.First}\n+ {p.Second}").ToArray();
        Assert.True(wrong.Length == 0, $"{wrong.Length} of {actual.Count} creatures have other bytes than {Place} says:\n{string.Join('\n', wrong.Take(3))}\n{advice}");
    }
}
