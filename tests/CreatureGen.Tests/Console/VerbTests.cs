using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Console;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class VerbTests
{
    /// <summary>Checks that every walker fails.</summary>
    private static readonly CreatureChecks refuseWalkers = new(
        ["StandsStill", "FliesWell"],
        creature => creature.Blueprint.Kind == LocomotionKind.Walking ? [new InvariantViolation("StandsStill", "it walks \"away\"")] : [],
        creature => creature.Blueprint.Kind == LocomotionKind.Flying ? new SurfaceCrossings(3, 0) : default);

    [Fact]
    public void Without_arguments_there_is_creature_101_and_what_it_is()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run());
        Assert.Equal(["creature-101.glb", "creature-101.json", "creature-101.png"], run.Files);
        Assert.Equal("", run.Error);
        Assert.All(["kind", "body", "limbs", "joints", "vertices", "triangles", "size", "mass", "time"], word => Assert.Contains("  " + word + " ", run.Out, StringComparison.Ordinal));
        using var other = new ConsoleRun();
        Assert.Equal(ExitCode.Done, other.Run("generate", "--seed", "0x65"));
        Assert.Equal(run.AllBytes(), other.AllBytes());
    }

    [Fact(Explicit = true)]
    public void Individuals_have_files_of_their_own_and_are_told_apart()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seed", "42", "--individuals", "1-2", "--no-picture", "--json"));
        Assert.Equal(["creature-42-1.glb", "creature-42-1.json", "creature-42-2.glb", "creature-42-2.json"], run.Files);
        JsonElement[] creatures = run.Json().GetProperty("creatures").EnumerateArray().ToArray();
        Assert.Equal(["42", "42"], creatures.Select(creature => creature.GetProperty("seed").GetString()));
        Assert.Equal(["1", "2"], creatures.Select(creature => creature.GetProperty("individual").GetString()));
        using var single = new ConsoleRun();
        Assert.Equal(ExitCode.Done, single.Run("generate", "--seed", "42", "--individual", "2", "--no-picture"));
        Assert.Contains("creature 42-2", single.Out, StringComparison.Ordinal);
        Assert.Equal(["creature-42-2.glb", "creature-42-2.json"], single.Files);
    }

    [Fact]
    public void Individuals_can_be_verified_and_drawn()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("verify", "--seeds", "1-2", "--individuals", "1-3", "--json"));
        Assert.Equal(6, run.Json().GetProperty("checked").GetInt32());
        using var sheet = new ConsoleRun();
        Assert.Equal(ExitCode.Done, sheet.Run("sheet", "--seed", "1", "--individuals", "1-2", "--size", "32", "--out", "family.png"));
        Assert.Contains("2 creatures", sheet.Out, StringComparison.Ordinal);
    }

    [Fact(Explicit = true)]
    public void Two_runs_give_the_same_bytes_for_any_number_of_threads()
    {
        using var one = new ConsoleRun();
        using var two = new ConsoleRun();
        Assert.Equal(ExitCode.Done, one.Run("generate", "--seeds", "3-4,0x20", "--textures", "512", "--picture-size", "256x256", "--threads", "1", "--json"));
        Assert.Equal(ExitCode.Done, two.Run("generate", "--seeds", "3-4,0x20", "--textures", "512", "--picture-size", "256x256", "--threads", "3", "--json"));
        Assert.Equal(9, one.Files.Length);
        Assert.Equal(one.AllBytes(), two.AllBytes());
        Assert.Equal(one.Out.Replace(one.Folder, "", StringComparison.Ordinal), two.Out.Replace(two.Folder, "", StringComparison.Ordinal));
    }

    [Fact]
    public void Generation_tells_its_creatures_as_json_in_the_order_of_the_seeds()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seeds", "18446744073709551615,9,1", "--kind", "swimming", "--no-picture", "--json", "--out", "new/folder"));
        JsonElement[] creatures = run.Json().GetProperty("creatures").EnumerateArray().ToArray();
        Assert.Equal(["18446744073709551615", "9", "1"], creatures.Select(creature => creature.GetProperty("seed").GetString()));
        foreach (JsonElement told in creatures)
        {
            Assert.Equal("swimming", told.GetProperty("kind").GetString());
            JsonElement files = told.GetProperty("files");
            Assert.Equal(["glb", "json"], files.EnumerateObject().Select(file => file.Name));
            Assert.All(files.EnumerateObject(), file => Assert.True(File.Exists(file.Value.GetString())));
            Creature creature = CreatureGenerator.Build(BlueprintJson.Read(File.ReadAllText(files.GetProperty("json").GetString()!)).GetBlueprint());
            Assert.Equal(creature.Skeleton.Count, told.GetProperty("joints").GetInt32());
            Assert.Equal(creature.Mesh.Positions.Length, told.GetProperty("vertices").GetInt32());
            Assert.Equal(creature.Mesh.Triangles.Length / 3, told.GetProperty("triangles").GetInt32());
            Assert.Equal(creature.Limbs.Count, told.GetProperty("limbs").EnumerateObject().Sum(limb => limb.Value.GetInt32()));
            Assert.Equal(creature.Mesh.Triangles.Length / 3, told.GetProperty("materials").EnumerateObject().Sum(part => part.Value.GetInt32()));
            Assert.Equal(creature.Mass.Mass, told.GetProperty("mass").GetSingle());
            Assert.Equal(1, told.GetProperty("body").EnumerateObject().Sum(part => part.Value.GetDouble()), 1e-12);
        }
    }

    [Theory]
    [InlineData("--palette", "vivid", Explicit = true)]
    [InlineData("--textures", "256", Explicit = true)]
    [InlineData("--levels", "all", Explicit = true)]
    [InlineData("--materials", "one", Explicit = true)]
    [InlineData("--materials", "one", "--levels", "all", "--textures", "256", Explicit = true)]
    [InlineData("--clips", "all", Explicit = true)]
    [InlineData("--flat")]
    public void Building_a_generated_file_anew_gives_the_same_bytes(params string[] options)
    {
        using var run = new ConsoleRun();
        foreach (string kind in new[] { "walking", "flying", "swimming" })
        {
            Assert.Equal(ExitCode.Done, run.Run(["generate", "--seed", "11", "--no-picture", "--kind", kind, .. options]));
            Assert.Equal(ExitCode.Done, run.Run("build", "creature-11.glb", "--out", "again.glb"));
            Assert.Equal(run.Bytes("creature-11.glb"), run.Bytes("again.glb"));
            Assert.Equal(ExitCode.Done, run.Run("inspect", "again.glb", "--json"));
            JsonElement file = run.Json().GetProperty("file");
            Assert.True(file.GetProperty("asWritten").GetBoolean());
            Assert.Equal(options.Contains("--flat") ? "flat" : "smooth", file.GetProperty("shading").GetString());
        }
    }

    [Fact]
    public void An_edited_blueprint_builds_and_the_file_may_replace_its_source()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seed", "4", "--no-picture"));
        CreatureBlueprint blueprint = BlueprintJson.Read(File.ReadAllText(run.At("creature-4.json"))).GetBlueprint();
        File.WriteAllText(run.At("edited.json"), BlueprintJson.Write(blueprint with { Scale = 3 }));
        Assert.Equal(ExitCode.Done, run.Run("build", "edited.json", "--out", "creature-4.glb"));
        Assert.Equal(ExitCode.Done, run.Run("build", "creature-4.glb", "--flat", "--out", "creature-4.glb"));
        Assert.Equal(ExitCode.Done, run.Run("inspect", "creature-4.glb", "--json"));
        Assert.Equal(3, run.Json().GetProperty("creature").GetProperty("scale").GetDouble());
        Assert.Equal("flat", run.Json().GetProperty("file").GetProperty("shading").GetString());
    }

    [Fact]
    public void All_problems_of_a_blueprint_are_listed_with_path_value_and_expectation()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seed", "4", "--no-picture"));
        string text = File.ReadAllText(run.At("creature-4.json"));
        CreatureBlueprint blueprint = BlueprintJson.Read(text).GetBlueprint();
        File.WriteAllText(run.At("bad.json"), BlueprintJson.Write(blueprint with { Scale = 99, Head = blueprint.Head with { NostrilSize = -4 } }));
        foreach (string[] arguments in new[] { new[] { "inspect", "bad.json" }, ["build", "bad.json", "--out", "bad.glb"] })
        {
            Assert.Equal(ExitCode.BadInput, run.Run(arguments));
            string[] lines = run.Error.TrimEnd().Split(Environment.NewLine);
            Assert.Equal(3, lines.Length);
            Assert.StartsWith($"creaturegen: '{run.At("bad.json")}' holds no blueprint that can be built:", lines[0], StringComparison.Ordinal);
            Assert.StartsWith("  scale = 99; expected 0.05..20 (line ", lines[1], StringComparison.Ordinal);
            Assert.StartsWith("  head.nostrilSize = -4; expected ", lines[2], StringComparison.Ordinal);
        }

        Assert.DoesNotContain("bad.glb", run.Files);
    }

    [Fact]
    public void Files_that_hold_no_creature_are_refused_whatever_their_bytes()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seed", "4", "--no-picture"));
        byte[] glb = run.Bytes("creature-4.glb");
        foreach (byte[] bytes in new[] { [], [0], "{}"u8.ToArray(), "glTF"u8.ToArray(), glb[..19], glb[..5000], [.. "glTF"u8, .. new byte[40]] })
        {
            File.WriteAllBytes(run.At("x"), bytes);
            File.WriteAllBytes(run.At("x.glb"), bytes);
            Assert.Equal(ExitCode.BadInput, run.Run("inspect", "x"));
            Assert.Equal(ExitCode.BadInput, run.Run("inspect", "x.glb"));
            Assert.Contains("; expected ", run.Error, StringComparison.Ordinal);
        }
    }

    [Fact(Explicit = true)]
    public void A_file_that_was_altered_is_told_from_one_that_was_not()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seed", "4", "--no-picture"));
        byte[] glb = run.Bytes("creature-4.glb");
        glb[^20] ^= 1;
        File.WriteAllBytes(run.At("creature-4.glb"), glb);
        Assert.Equal(ExitCode.Done, run.Run("inspect", "creature-4.glb", "--json"));
        Assert.False(run.Json().GetProperty("file").GetProperty("asWritten").GetBoolean());
    }

    [Fact]
    public void A_broken_creature_is_built_only_by_force_or_after_repair()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seed", "41", "--kind", "walking", "--plans", "upright=1000", "--strangeness", "0", "--no-picture", "--textures", "none"));
        CreatureBlueprint sound = BlueprintJson.Read(File.ReadAllText(run.At("creature-41.json"))).GetBlueprint();
        File.WriteAllText(run.At("level.json"), BlueprintJson.Write(sound with { Body = sound.Body with { Posture = sound.Body.Posture with { Torso = 0 } } }));
        Assert.Equal(ExitCode.CheckFailed, run.Run("build", "level.json", "--textures", "none", "--out", "level.glb"));
        Assert.Contains("would be broken", run.Error, StringComparison.Ordinal);
        string problem = run.Error.Split('\n')[1].Trim();
        Assert.DoesNotContain("level.glb", run.Files);

        Assert.Equal(ExitCode.Done, run.Run("build", "level.json", "--textures", "none", "--repair", "--out", "level.glb"));
        Assert.Contains("  repaired   ", run.Out, StringComparison.Ordinal);
        Assert.Equal(ExitCode.Done, run.Run("inspect", "level.glb", "--json"));
        Assert.True(run.Json().GetProperty("sound").GetBoolean());
        Assert.Empty(run.Json().GetProperty("problems").EnumerateArray());

        Assert.Equal(ExitCode.Done, run.Run("build", "level.json", "--textures", "none", "--force", "--out", "forced.glb"));
        Assert.Contains("written although broken: " + problem, run.Error, StringComparison.Ordinal);
        Assert.Equal(ExitCode.CheckFailed, run.Run("inspect", "forced.glb", "--json"));
        Assert.False(run.Json().GetProperty("sound").GetBoolean());
        Assert.Equal(problem, run.Json().GetProperty("problems")[0].GetString());
        Assert.Equal(ExitCode.BadInput, run.Run("build", "level.json", "--force", "--repair", "--out", "level.glb"));
    }

    [Fact]
    public void What_no_rule_allows_is_repaired_from_its_text()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seed", "4", "--no-picture"));
        CreatureBlueprint blueprint = BlueprintJson.Read(File.ReadAllText(run.At("creature-4.json"))).GetBlueprint();
        File.WriteAllText(run.At("bad.json"), BlueprintJson.Write(blueprint with { Scale = 99 }));
        Assert.Equal(ExitCode.Done, run.Run("build", "bad.json", "--repair", "--out", "good.glb"));
        Assert.Contains("good.glb", run.Files);
    }

    [Fact]
    public void Inspection_names_every_joint_limb_and_invariant()
    {
        using var run = new ConsoleRun { Checks = refuseWalkers };
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seed", "8", "--kind", "walking", "--no-picture"));
        Creature creature = CreatureGenerator.Build(BlueprintJson.Read(File.ReadAllText(run.At("creature-8.json"))).GetBlueprint());
        Assert.Equal(ExitCode.CheckFailed, run.Run("inspect", "creature-8.json", "--json"));
        JsonElement told = run.Json();
        Assert.Equal(creature.Skeleton.Joints.Select(joint => joint.Name), told.GetProperty("skeleton").EnumerateArray().Select(joint => joint.GetProperty("name").GetString()));
        Assert.Equal(creature.Limbs.Select(limb => limb.Joints.Count), told.GetProperty("limbs").EnumerateArray().Select(limb => limb.GetProperty("joints").GetArrayLength()));
        Assert.Equal(["StandsStill:False", "FliesWell:True"], told.GetProperty("invariants").EnumerateArray().Select(rule => $"{rule.GetProperty("invariant").GetString()}:{rule.GetProperty("holds").GetBoolean()}"));
        Assert.Equal(ExitCode.CheckFailed, run.Run("inspect", "creature-8.json"));
        Assert.All(creature.Skeleton.Joints, joint => Assert.Contains(joint.Name, run.Out, StringComparison.Ordinal));
        Assert.Contains("it walks \"away\"", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Verification_counts_as_json_what_fails_of_each_seeds_natural_kind()
    {
        using var run = new ConsoleRun { Checks = refuseWalkers };
        string[] kinds = Enumerable.Range(1, 40).Select(seed => CreatureGen.Sampling.BlueprintSampler.Sample((ulong)seed).Kind.ToString()).ToArray();
        string[] walkers = Enumerable.Range(1, 40).Where(seed => kinds[seed - 1] == "Walking").Select(seed => seed.ToString(System.Globalization.CultureInfo.InvariantCulture)).ToArray();
        Assert.Equal(ExitCode.CheckFailed, run.Run("verify", "--seeds", "1-40", "--kind", "any", "--threads", "3", "--json"));
        JsonElement told = run.Json();
        Assert.Equal(["checked", "failed", "selfIntersecting", "piecesCrossing", "problems"], told.EnumerateObject().Select(member => member.Name));
        Assert.Equal(40, told.GetProperty("checked").GetInt32());
        Assert.Equal(walkers.Length, told.GetProperty("failed").GetInt32());
        Assert.Equal(kinds.Count(kind => kind == "Flying"), told.GetProperty("selfIntersecting").GetInt32());
        Assert.Equal(walkers, told.GetProperty("problems").EnumerateArray().Select(problem => problem.GetProperty("seed").GetString()));
        JsonElement first = told.GetProperty("problems")[0];
        Assert.Equal(["kind", "seed", "invariant", "detail"], first.EnumerateObject().Select(member => member.Name));
        Assert.Equal("StandsStill", first.GetProperty("invariant").GetString());
        Assert.Equal("it walks \"away\"", first.GetProperty("detail").GetString());
        Assert.Equal("", run.Error);
    }

    [Fact]
    public void Verification_as_text_is_a_table_of_kinds_and_invariants()
    {
        using var run = new ConsoleRun { Checks = refuseWalkers };
        Assert.Equal(ExitCode.CheckFailed, run.Run("verify", "--seeds", "1-25", "--kind", "walking"));
        Assert.Matches(@"(?m)^checked +25 +0 +0 +25\r?$", run.Out);
        Assert.Matches(@"(?m)^StandsStill +25 +0 +0 +25\r?$", run.Out);
        Assert.Matches(@"(?m)^FliesWell +0 +0 +0 +0\r?$", run.Out);
        Assert.Contains("... and 5 more; --json lists all", run.Out, StringComparison.Ordinal);
        Assert.Equal(ExitCode.Done, run.Run("verify", "--seeds", "1-5", "--kind", "swimming"));
        Assert.Contains("All invariants hold.", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void What_a_check_throws_is_a_problem_like_any_other()
    {
        using var run = new ConsoleRun { Checks = new(["A"], _ => throw new InvalidOperationException("broken"), _ => default) };
        Assert.Equal(ExitCode.CheckFailed, run.Run("verify", "--seed", "1", "--json"));
        JsonElement problem = run.Json().GetProperty("problems")[0];
        Assert.Equal("builds", problem.GetProperty("invariant").GetString());
        Assert.Equal("InvalidOperationException: broken", problem.GetProperty("detail").GetString());
    }

    [Fact]
    public void A_sheet_is_a_picture_of_the_size_asked_for()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("sheet", "--seeds", "1-3", "--columns", "2", "--size", "68", "--view", "side", "--out", "a.png", "--threads", "1"));
        Assert.Equal(ExitCode.Done, run.Run("sheet", "--seeds", "1-3", "--columns", "2", "--size", "68", "--view", "side", "--out", "b.png", "--threads", "3"));
        Assert.Equal(ExitCode.Done, run.Run("sheet", "--seeds", "1-3", "--columns", "2", "--size", "68", "--view", "side", "--out", "c.png", "--skeleton"));
        Assert.Equal(ExitCode.Done, run.Run("sheet", "--seeds", "1-3", "--columns", "2", "--size", "68", "--view", "side", "--out", "d.png", "--face"));
        Assert.NotEqual(run.Bytes("c.png"), run.Bytes("d.png"));
        Assert.Contains("--face and --skeleton", run.Refusal(ExitCode.BadInput, "sheet", "--seed", "1", "--out", "e.png", "--face", "--skeleton"), StringComparison.Ordinal);
        byte[] png = run.Bytes("a.png");
        Assert.Equal([137, 80, 78, 71, 13, 10, 26, 10], png[..8]);
        Assert.Equal([0, 0, 0, 136, 0, 0, 0, 112], png[16..24]);
        Assert.Equal(png, run.Bytes("b.png"));
        Assert.NotEqual(png, run.Bytes("c.png"));
    }
}
