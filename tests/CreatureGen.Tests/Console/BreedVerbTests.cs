using System;
using System.Linq;
using System.Text.Json;
using CreatureGen.Console;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class BreedVerbTests
{
    [Fact]
    public void A_litter_has_files_and_a_sheet_and_is_told_as_JSON()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("breed", "3", "16", "--litter", "2", "--mutation", "0.3", "--out", "litter", "--json"));
        JsonElement told = run.Json();
        Assert.Equal(["3", "16"], told.GetProperty("parents").EnumerateArray().Select(parent => parent.GetProperty("name").GetString()));
        JsonElement[] litter = told.GetProperty("litter").EnumerateArray().ToArray();
        Assert.Equal(2, litter.Length);
        foreach (JsonElement child in litter)
        {
            string hash = child.GetProperty("hash").GetString()!;
            Assert.Equal(16, hash.Length);
            foreach (string form in new[] { "glb", "png", "json" })
            {
                Assert.EndsWith($"creature-{hash}.{form}", child.GetProperty("files").GetProperty(form).GetString(), StringComparison.Ordinal);
                Assert.True(run.Bytes($"litter/creature-{hash}.{form}").Length > 1000);
            }

            Assert.Equal(1, child.GetProperty("generation").GetInt32());
        }

        Assert.True(run.Bytes("litter/litter.png").Length > 1000);
        string first = litter[0].GetProperty("files").GetProperty("glb").GetString()!;
        Assert.Equal(ExitCode.Done, run.Run("inspect", first, "3", "--json"));
        Assert.InRange(run.Json().GetProperty("speciesDistance").GetDouble(), 0.01, 0.9);
        Assert.True(run.Json().GetProperty("sound").GetBoolean());
    }

    [Fact(Explicit = true)]
    public void A_litter_is_told_with_each_child_apart_from_where_its_parts_are_of()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("breed", "3", "16", "--litter", "1", "--out", "litter"));
        Assert.Matches(@"(?m)^  [0-9a-f]{16} frame [AB] ", run.Out);
    }

    [Theory]
    [InlineData("1 of 2 creatures", "breed", "3", "--out", "x")]
    [InlineData("'5' after '4'", "breed", "3", "4", "5", "--out", "x")]
    [InlineData("--mutation = '2'; expected a number 0..1", "breed", "3", "4", "--mutation", "2", "--out", "x")]
    [InlineData("--litter = '0'", "breed", "3", "4", "--litter", "0", "--out", "x")]
    [InlineData("nobody.glb", "breed", "3", "nobody.glb", "--out", "x")]
    public void What_cannot_be_bred_is_one_line(string part, params string[] arguments)
    {
        using var run = new ConsoleRun();
        Assert.Contains(part, run.Refusal(ExitCode.BadInput, arguments), StringComparison.Ordinal);
        Assert.Empty(run.Files);
    }
}
