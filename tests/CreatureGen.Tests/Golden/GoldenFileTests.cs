using System;
using System.IO;
using System.Linq;
using CreatureGen.Anatomy;
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
        GoldenFile.AssertSame(actual, $"If that is meant, copy {Path.GetRelativePath(RepositoryFiles.Root, renewed)} over it, and say why in the commit (docs/determinism.md).");
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
