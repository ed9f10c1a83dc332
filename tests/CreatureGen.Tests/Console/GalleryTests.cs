using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using CreatureGen.Console;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class GalleryTests
{
    private const string Small = "--textures none --triangles 6000 --picture-size 32x24 --out site";

    [Fact(Explicit = true)]
    public void The_page_shows_every_creature_and_leads_to_its_files_and_nowhere_else()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run(["gallery", "--seeds", "1-8", .. Small.Split(' ')]));
        Assert.Contains("index.html: 8 creatures, ", run.Out, StringComparison.Ordinal);
        string page = File.ReadAllText(run.At("site/index.html"));
        string[] links = Regex.Matches(page, "(?:href|src)=\"([^\"]*)\"").Select(link => link.Groups[1].Value).ToArray();
        Assert.Equal(Directory.GetFiles(run.At("site"), "creature-*").Select(path => Path.GetFileName(path)).Order(StringComparer.Ordinal), links.Order(StringComparer.Ordinal));
        Assert.Equal(8 * 3, links.Length);
        Assert.DoesNotContain("<script", page, StringComparison.Ordinal);
        Assert.DoesNotContain("://", page, StringComparison.Ordinal);
        Assert.Equal(8, Regex.Matches(page, "<img [^>]*alt=\"A (walking|flying|swimming) creature, [^\"]+\"").Count);
        string[] kinds = Regex.Matches(page, "<figure class=\"([a-z]+)\"").Select(figure => figure.Groups[1].Value).Distinct().ToArray();
        Assert.True(kinds.Length > 1);
        Assert.All(kinds, kind => Assert.Contains($"id=\"{kind}\"", page, StringComparison.Ordinal));
        using var again = new ConsoleRun();
        Assert.Equal(ExitCode.Done, again.Run(["gallery", "--seeds", "1-8", "--threads", "1", .. Small.Split(' ')]));
        Assert.Equal(run.Bytes("site/index.html"), again.Bytes("site/index.html"));
    }

    /// <summary>The files are those that other verbs write.</summary>
    [Fact(Explicit = true)]
    public void Its_files_are_those_of_generate()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("gallery", "--seed", "7", "--out", "site"));
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seed", "7", "--picture-size", "640x480", "--out", "plain"));
        Assert.All(new[] { "glb", "png", "json" }, form => Assert.Equal(run.Bytes("plain/creature-7." + form), run.Bytes("site/creature-7." + form)));
    }

    [Fact]
    public void Seeds_without_a_creature_are_told_and_left_out()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.CheckFailed, run.Run(["gallery", "--seeds", "1-8", .. RareCreatures.Options.Split(' '), .. Small.Split(' ')]));
        Assert.Contains("gave no creature", run.Error, StringComparison.Ordinal);
        Assert.Contains(" missing", run.Out, StringComparison.Ordinal);
        Assert.True(File.Exists(run.At("site/index.html")));
    }

    [Theory]
    [InlineData("gallery --seeds 1-3", "--out")]
    [InlineData("gallery --seeds 1-3 --out -", "expected a folder")]
    [InlineData("gallery --seeds 1-10001 --out site", "expected at most 10,000")]
    [InlineData("gallery --seeds 1-3 --out site --picture-size 8x8", "expected width x height, each 16..4096")]
    public void A_page_that_cannot_be_is_refused(string line, string message)
    {
        using var run = new ConsoleRun();
        Assert.Contains(message, run.Refusal(ExitCode.BadInput, line.Split(' ')), StringComparison.Ordinal);
    }
}
