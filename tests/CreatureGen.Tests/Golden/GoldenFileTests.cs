using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Digest;
using CreatureGen.Sampling;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Golden;

public sealed class GoldenFileTests
{
    [Fact]
    public void Creatures_have_the_bytes_that_were_agreed()
    {
        GoldenEntry[] actual = GoldenFile.Entries.Select(e => GoldenEntry.Compute(e.Kind, e.Seed)).ToArray();
        string renewed = Path.Combine(AppContext.BaseDirectory, "golden.txt");
        File.WriteAllText(renewed, GoldenEntry.Format(GoldenFile.Text, actual));
        GoldenFile.AssertSame(GoldenFile.Entries, actual, $"If that is meant, copy {Path.GetRelativePath(RepositoryFiles.Root, renewed)} over it, and say why in the commit (docs/determinism.md).");
    }

    [Fact]
    public void The_bytes_have_a_version_of_the_algorithm_of_their_own()
    {
        IReadOnlyList<GoldenVersion> versions = GoldenVersion.Parse(RepositoryFiles.Text(GoldenFile.VersionsPlace));
        Assert.Equal(Enumerable.Range(1, versions.Count), versions.Select(v => v.Algorithm));
        Assert.Equal(versions.Count, versions.Select(v => v.Sha256).Distinct().Count());
        GoldenVersion now = GoldenVersion.Of(CreatureBlueprint.CurrentAlgorithm, GoldenFile.Entries);
        Assert.True(
            versions[^1] == now,
            $"{GoldenFile.Place} is \"{now}\" and {GoldenFile.VersionsPlace} ends with \"{versions[^1]}\": other bytes need a higher CreatureBlueprint.CurrentAlgorithm, then the golden file renewed (docs/determinism.md).");
    }

    [Fact]
    public void A_version_keeps_its_bytes_for_good()
    {
        const string list = "# remark\n1 aa\n2 bb\n";
        Assert.Equal(list, GoldenVersion.Append(list, new GoldenVersion(2, "bb")));
        Assert.Equal(list + "3 cc\n", GoldenVersion.Append(list, new GoldenVersion(3, "cc")));
        Assert.Contains("raise CreatureBlueprint.CurrentAlgorithm to 3", Assert.Throws<InvalidOperationException>(() => GoldenVersion.Append(list, new GoldenVersion(2, "cc"))).Message, StringComparison.Ordinal);
        Assert.Throws<FormatException>(() => GoldenVersion.Parse("one aa"));
    }

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    [InlineData(RequestedKind.Swimming)]
    public void The_agreed_bytes_are_those_of_a_dozen_seeds_of_each_kind_from_both_ends(RequestedKind kind)
    {
        ulong[] seeds = GoldenFile.Entries.Where(e => e.Kind == kind).Select(e => e.Seed).ToArray();
        Assert.True(seeds.Distinct().Count() == seeds.Length && seeds.Length >= 12, $"{seeds.Length} seeds");
        Assert.Contains(0UL, seeds);
        Assert.Contains(ulong.MaxValue, seeds);
    }

    /// <summary>A body plan that no seed of the file draws any more wants a seed that does.</summary>
    [Fact]
    public void Every_body_plan_is_among_them()
    {
        BodyPlan[] found = GoldenFile.Entries.Select(e => BlueprintSampler.Sample(e.Seed, CreatureOptions.Default with { Kind = e.Kind }).Plan).Distinct().ToArray();
        Assert.Empty(Enum.GetValues<BodyPlan>().Except(found));
    }

    [Fact]
    public void No_two_creatures_are_the_same() => Assert.Equal(GoldenFile.Entries.Count, GoldenFile.Entries.Select(e => e.Sha256).Distinct().Count());

    [Fact]
    public void The_text_of_the_file_is_what_its_entries_give()
    {
        Assert.Equal(GoldenFile.Text.ReplaceLineEndings("\n"), GoldenEntry.Format(GoldenFile.Text, GoldenFile.Entries));
        Assert.Throws<FormatException>(() => GoldenEntry.Parse("walking 1"));
        Assert.Throws<FormatException>(() => GoldenEntry.Parse("crawling 1 00"));
        Assert.Throws<FormatException>(() => GoldenEntry.Parse("walking -1 00"));
    }
}
