using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Digest;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Golden;

public sealed class GoldenPoseTests
{
    private const string Place = "tests/CreatureGen.Tests/Golden/poses.txt";
    private static readonly string Text = RepositoryFiles.Text(Place);
    private static readonly IReadOnlyList<PoseEntry> Entries = PoseEntry.Parse(Text);

    [Fact]
    public void Creatures_move_as_was_agreed_to_the_last_bit()
    {
        PoseEntry[] actual = Entries.Select(e => PoseEntry.Compute(e.Plan, e.Seed)).ToArray();
        string renewed = Path.Combine(AppContext.BaseDirectory, "poses.txt");
        File.WriteAllText(renewed, PoseEntry.Format(Text, actual));
        string[] wrong = Entries.Zip(actual).Where(p => p.First != p.Second).Select(p => p.First.Plan.ToString()).ToArray();
        string advice = $"If that is meant, copy {Path.GetRelativePath(RepositoryFiles.Root, renewed)} over it, and say why in the commit (docs/determinism.md).";
        Assert.True(wrong.Length == 0, $"{wrong.Length} of {actual.Length} creatures move otherwise than {Place} says: {string.Join(", ", wrong)}\n{advice}");
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Unguligrade)]
    [InlineData(BodyPlan.Upright)]
    [InlineData(BodyPlan.Theropod)]
    [InlineData(BodyPlan.Sprawling)]
    [InlineData(BodyPlan.Hexapod)]
    [InlineData(BodyPlan.ManyLegged)]
    [InlineData(BodyPlan.Legless)]
    [InlineData(BodyPlan.Flapping)]
    [InlineData(BodyPlan.Buzzing)]
    [InlineData(BodyPlan.Fish)]
    [InlineData(BodyPlan.Eel)]
    [InlineData(BodyPlan.Whale)]
    [InlineData(BodyPlan.Flipper)]
    public void They_are_of_all_kinds_of_motion(BodyPlan plan) => Assert.Contains(Entries, e => e.Plan == plan);

    [Fact]
    public void No_two_of_them_move_the_same() => Assert.Equal(Entries.Count, Entries.Select(e => e.Sha256).Distinct().Count());

    [Fact]
    public void The_text_of_the_file_is_what_its_entries_give()
    {
        Assert.Equal(Text.ReplaceLineEndings("\n"), PoseEntry.Format(Text, Entries));
        Assert.Throws<FormatException>(() => PoseEntry.Parse("Theropod 1"));
        Assert.Throws<FormatException>(() => PoseEntry.Parse("Kangaroo 1 00"));
        Assert.Throws<FormatException>(() => PoseEntry.Parse("Theropod -1 00"));
    }
}
