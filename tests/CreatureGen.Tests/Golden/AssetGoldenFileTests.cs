using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Digest;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Golden;

/// <summary>Textures, PNG files and clips, beside the files that <see cref="GoldenFileTests"/> compare.</summary>
public sealed class AssetGoldenFileTests
{
    private static readonly string Text = RepositoryFiles.Text(GoldenFile.AssetsPlace);
    private static readonly IReadOnlyList<AssetEntry> Entries = AssetEntry.Parse(Text);

    [Fact]
    public void Textures_pictures_and_clips_have_the_bytes_that_were_agreed()
    {
        string now = AssetEntry.Renew(Text);
        string renewed = Path.Combine(AppContext.BaseDirectory, "assets.txt");
        File.WriteAllText(renewed, now);
        string advice = $"If that is meant, copy {Path.GetRelativePath(RepositoryFiles.Root, renewed)} over it, and say why in the commit (docs/determinism.md).";
        Assert.True(Text.ReplaceLineEndings("\n") == now, $"{GoldenFile.AssetsPlace} says otherwise. {advice}");
    }

    [Fact]
    public void They_are_of_all_kinds()
    {
        foreach (string what in AssetEntry.All)
        {
            Assert.Equal(3, Entries.Where(e => e.What == what).Select(e => e.Kind).Distinct().Count());
        }

        Assert.Equal(Entries.Count, Entries.Select(e => e.Sha256).Distinct().Count());
        Assert.Throws<FormatException>(() => AssetEntry.Parse("sounds Walking 1 00"));
    }
}
