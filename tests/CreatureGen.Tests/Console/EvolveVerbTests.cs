using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using CreatureGen.Blueprints;
using CreatureGen.Console;
using CreatureGen.Console.Evolving;
using CreatureGen.Genetics;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class EvolveVerbTests
{
    private static readonly string[] Small = ["evolve", "--towards", "tall", "--parents", "60-62", "--population", "4", "--out", "run", "--threads", "1"];

    [Fact]
    public void A_run_has_sheets_a_tree_a_curve_and_everybody_who_lived_and_is_told_as_JSON()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run([.. Small, "--generations", "2", "--json"]));
        JsonElement told = run.Json();
        JsonElement[] generations = told.GetProperty("generations").EnumerateArray().ToArray();
        Assert.Equal([0, 1, 2], generations.Select(row => row.GetProperty("generation").GetInt32()));
        Assert.All(generations, row => Assert.True(row.GetProperty("best").GetDouble() >= row.GetProperty("median").GetDouble() && row.GetProperty("median").GetDouble() > 0));
        Assert.True(generations[2].GetProperty("best").GetDouble() >= generations[0].GetProperty("best").GetDouble());
        foreach (string name in new[] { "generation-000.png", "generation-002.png", "family-tree.png", "curve.png", "best.glb", "best.json", "lineage.json" })
        {
            Assert.True(run.Bytes("run/" + name).Length > 500, name);
        }

        string[] creatures = Directory.GetFiles(run.At("run/creatures")).Select(path => Path.GetFileName(path)).Order(StringComparer.Ordinal).ToArray();
        string[] listed = Lineage(run).GetProperty("creatures").EnumerateArray().Select(one => $"creature-{one.GetProperty("hash").GetString()}.json").Order(StringComparer.Ordinal).ToArray();
        Assert.Equal(listed, creatures);
        Assert.All(creatures, name => Assert.NotNull(BlueprintJson.Read(File.ReadAllText(run.At("run/creatures/" + name))).Blueprint));
        Assert.Equal(ExitCode.Done, run.Run("inspect", "run/best.glb", "--json"));
        Assert.True(run.Json().GetProperty("sound").GetBoolean());
    }

    [Theory]
    [InlineData("tournament", Explicit = true)]
    [InlineData("novelty", Explicit = true)]
    public void A_run_that_is_stopped_at_any_generation_goes_on_as_if_it_had_not_been(string selection)
    {
        string[] words = [.. Small, "--selection", selection];
        using var whole = new ConsoleRun();
        Assert.Equal(ExitCode.Done, whole.Run([.. words, "--generations", "3"]));
        using var parts = new ConsoleRun();
        foreach (string generation in new[] { "0", "2", "3" })
        {
            Assert.Equal(ExitCode.Done, parts.Run([.. words, "--generations", generation]));
        }

        Assert.Equal(whole.Bytes("run/lineage.json"), parts.Bytes("run/lineage.json"));
        Assert.Equal(whole.Bytes("run/best.glb"), parts.Bytes("run/best.glb"));
        Assert.Equal(whole.Bytes("run/family-tree.png"), parts.Bytes("run/family-tree.png"));
    }

    [Fact(Explicit = true)]
    public void A_run_that_is_killed_loses_the_generation_it_was_at_and_no_more()
    {
        using var whole = new ConsoleRun();
        Assert.Equal(ExitCode.Done, whole.Run([.. Small, "--generations", "2"]));

        // The disk fails at one operation after another, as if the process were killed there; what is left is gone on with.
        for (int failsAt = 20; ; failsAt += Thoroughness.IsExhaustive ? 61 : 223)
        {
            using var run = new ConsoleRun { Disk = new FailingDisk(failsAt) };
            int code = run.Run([.. Small, "--generations", "2"]);
            if (code == ExitCode.Done)
            {
                break;
            }

            Assert.Equal(ExitCode.CannotWrite, code);
            int there = File.Exists(run.At("run/lineage.json")) ? Lineage(run).GetProperty("generations").GetArrayLength() : 0;
            run.Disk = new CreatureGen.Console.Files.LocalDisk();
            Assert.Equal(ExitCode.Done, run.Run([.. Small, "--generations", "2"]));
            Assert.InRange(there, 0, 3);
            Assert.Equal(whole.Bytes("run/lineage.json"), run.Bytes("run/lineage.json"));
            Assert.Equal(Directory.GetFiles(whole.At("run/creatures")).Select(Path.GetFileName).Order(StringComparer.Ordinal), Directory.GetFiles(run.At("run/creatures")).Select(Path.GetFileName).Order(StringComparer.Ordinal));
        }
    }

    [Fact(Explicit = true)]
    public void A_run_that_is_interrupted_keeps_the_generations_that_are_done()
    {
        using var disk = new StoppingDisk(path => path.EndsWith("lineage.json", StringComparison.Ordinal));
        using var run = new ConsoleRun { Disk = disk };
        Assert.Equal(ExitCode.Interrupted, run.Run(disk.Token, [.. Small, "--generations", "10000"]));
        int there = Lineage(run).GetProperty("generations").GetArrayLength() - 1;
        Assert.Equal(ExitCode.Done, run.Run([.. Small, "--generations", FormattableString.Invariant($"{there + 1}")]));
        using var whole = new ConsoleRun();
        Assert.Equal(ExitCode.Done, whole.Run([.. Small, "--generations", FormattableString.Invariant($"{there + 1}")]));
        Assert.Equal(whole.Bytes("run/lineage.json"), run.Bytes("run/lineage.json"));
    }

    [Fact(Explicit = true)]
    public void Picks_are_found_by_their_first_digits_and_draw_the_population_to_them()
    {
        using var run = new ConsoleRun();
        string[] words = ["evolve", "--towards", "picks", "--parents", "60-62", "--population", "4", "--out", "run", "--threads", "1"];
        Assert.Equal(ExitCode.Done, run.Run([.. words, "--generations", "0"]));
        string pick = Lineage(run).GetProperty("population")[2].GetProperty("hash").GetString()!;
        Assert.Equal(ExitCode.Done, run.Run([.. words, "--generations", "4", "--picks", pick[..6], "--json"]));
        double picked = run.Json().GetProperty("generations")[4].GetProperty("median").GetDouble();
        Assert.Equal(1, run.Json().GetProperty("generations")[4].GetProperty("best").GetDouble());
        CreatureBlueprint Kept(string hash) => BlueprintJson.Read(File.ReadAllText(run.At($"run/creatures/creature-{hash}.json"))).GetBlueprint();
        double[] before = Lineage(run).GetProperty("creatures").EnumerateArray().Where(one => one.GetProperty("born").GetInt32() == 0).Select(one => 1 - SpeciesDistance.Between(Kept(pick), Kept(one.GetProperty("hash").GetString()!))).Order().ToArray();
        Assert.True(picked > before[(before.Length - 1) / 2], $"{picked}, {string.Join(' ', before)}");
        Assert.Equal(pick, Lineage(run).GetProperty("picks")[0].GetString());

        // The picks stay as they are until there are others.
        Assert.Equal(ExitCode.Done, run.Run([.. words, "--generations", "5"]));
        Assert.Equal(pick, Lineage(run).GetProperty("picks")[0].GetString());
    }

    [Fact(Explicit = true)]
    public void Creatures_become_like_an_outline_and_like_the_proportions_of_another()
    {
        using var run = new ConsoleRun();
        var tower = new Picture(40, 80, PixelLayout.Rgba);
        tower.Fill(new Pixel(0, 0, 0), 12, 4, 14, 72);
        File.WriteAllBytes(run.At("tower.png"), PngWriter.ToBytes(tower));
        foreach (string target in new[] { "like:tower.png", "like:7" })
        {
            string folder = target.Length == 6 ? "a" : "b";
            Assert.Equal(ExitCode.Done, run.Run("evolve", "--towards", target, "--parents", "60-62", "--population", "5", "--generations", "3", "--out", folder, "--threads", "1", "--json"));
            JsonElement rows = run.Json().GetProperty("generations");
            Assert.InRange(rows[3].GetProperty("best").GetDouble(), rows[0].GetProperty("best").GetDouble(), 1);
            Assert.True(rows[3].GetProperty("median").GetDouble() > rows[0].GetProperty("median").GetDouble());
        }
    }

    [Theory]
    [InlineData("evolve: --towards = 'quick'; expected of fast, stable, tall, efficient, smooth, distinct, strange, picks, like:FILE", "--towards", "quick")]
    [InlineData("expected of fast, stable, tall, efficient, smooth, distinct, strange, picks, like:FILE; did you mean stable?", "--towards", "fast,stabel")]
    [InlineData("evolve: --towards = 'fast=1.5'; expected a weight above 0 and up to 1 after =", "--towards", "fast=1.5")]
    [InlineData("evolve: --towards = 'fast=0'; expected a weight above 0 and up to 1 after =", "--towards", "fast=0")]
    [InlineData("expected fast once", "--towards", "fast,fast=0.5")]
    [InlineData("there is no such file; expected an outline (.png) or a creature (.json, .glb)", "--towards", "like:none.png")]
    [InlineData("cannot use 'bad.png' as an outline: it does not start as a PNG file does", "--towards", "like:bad.png")]
    [InlineData("cannot use 'plain.png' as an outline: the picture is empty; expected an outline on a plain background", "--towards", "like:plain.png")]
    [InlineData("evolve: --mutation = '1.2'; expected a number 0..1", "--towards", "fast", "--mutation", "1.2")]
    [InlineData("evolve: --population = '1'; expected a whole number 2..10000", "--towards", "fast", "--population", "1")]
    [InlineData("evolve: --selection = 'tournement'; expected one of tournament, novelty, niches; did you mean tournament?", "--towards", "fast", "--selection", "tournement")]
    [InlineData("cannot read", "--towards", "fast", "--parents", "nobody.glb")]
    [InlineData("expected at most 4 creatures, the population", "--towards", "fast", "--parents", "1-5", "--population", "4")]
    [InlineData("evolve: no --towards; expected --towards LIST", "--population", "4")]
    public void What_cannot_be_bred_towards_is_one_line_and_leaves_nothing(string part, params string[] arguments)
    {
        using var run = new ConsoleRun();
        File.WriteAllText(run.At("bad.png"), "no picture");
        File.WriteAllBytes(run.At("plain.png"), PngWriter.ToBytes(new Picture(8, 8, PixelLayout.Rgb)));
        Assert.Contains(part, run.Refusal(ExitCode.BadInput, ["evolve", "--out", "run", .. arguments]), StringComparison.Ordinal);
        Assert.Equal(["bad.png", "plain.png"], run.Files);
    }

    [Fact]
    public void An_invalid_parent_is_told_with_all_that_is_wrong_with_it()
    {
        using var run = new ConsoleRun();
        File.WriteAllText(run.At("bad.json"), BlueprintJson.Write(Blueprints.Samples.Small).Replace("\"scale\": 1.25", "\"scale\": -3", StringComparison.Ordinal));
        Assert.Equal(ExitCode.BadInput, run.Run([.. Small[..3], "--parents", "60,bad.json", "--out", "run"]));
        Assert.Contains("scale = -3", run.Error, StringComparison.Ordinal);
        Assert.Equal(["bad.json"], run.Files);
    }

    [Fact(Explicit = true)]
    public void A_folder_of_another_run_is_left_alone()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run([.. Small, "--generations", "1"]));
        byte[] before = run.Bytes("run/lineage.json");
        Assert.Contains("has mutation 0.35; expected the same instead of 0.2", run.Refusal(ExitCode.BadInput, [.. Small, "--mutation", "0.2"]), StringComparison.Ordinal);
        Assert.Contains("has other founders", run.Refusal(ExitCode.BadInput, [.. Small[..3], "--parents", "70-73", .. Small[5..]]), StringComparison.Ordinal);
        Assert.Contains("has 1 generations; expected --generations 1 or more", run.Refusal(ExitCode.BadInput, [.. Small, "--generations", "0"]), StringComparison.Ordinal);
        Assert.Equal(before, run.Bytes("run/lineage.json"));
        File.WriteAllText(run.At("run/lineage.json"), "{\"format\": 1}");
        Assert.Contains("cannot go on with", run.Refusal(ExitCode.BadInput, Small), StringComparison.Ordinal);
    }

    [Fact]
    public void Halves_of_a_pedigree_add_up_generation_by_generation()
    {
        static LineageBlueprint Of(ulong first, ulong second) => new(1, first, second, 0.2, ParentName.First, ParentName.First, ParentName.First, ParentName.First, ParentName.First);
        var everybody = new List<Ancestor> { new(1, 0, 1, null), new(2, 0, 1, null), new(3, 1, 1, Of(1, 2)), new(4, 1, 1, Of(2, 2)), new(5, 2, 1, Of(3, 4)), new(6, 3, 1, Of(5, 3)) };
        var pedigree = new Pedigree(new EvolutionRun([], [], [], everybody, null!));
        Assert.Equal([(3UL, 0.75), (4UL, 0.25)], pedigree.AncestorsAt(6, 1).Select(entry => (entry.Ancestor.Identity, entry.Share)));
        Assert.Equal([(2UL, 0.625), (1UL, 0.375)], pedigree.AncestorsAt(6, 0).Select(entry => (entry.Ancestor.Identity, entry.Share)));
        Assert.Equal([(6UL, 1.0)], pedigree.AncestorsAt(6, 3).Select(entry => (entry.Ancestor.Identity, entry.Share)));
    }

    private static JsonElement Lineage(ConsoleRun run)
    {
        using JsonDocument document = JsonDocument.Parse(run.Bytes("run/lineage.json"));
        return document.RootElement.Clone();
    }
}
