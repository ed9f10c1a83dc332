using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Threading;
using CreatureGen.Anatomy;
using CreatureGen.Console;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Verbs;
using CreatureGen.Console.Working;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class MotionVerbTests
{
    private static readonly string[] contract =
        ["kind", "seed", "gait", "ground", "hertz", "slipMaxMetres", "penetrationMaxMetres", "clearanceMinMetres", "limitViolations", "reachResidualMaxMetres", "poseJumpMax", "supportMin"];

    [Fact]
    public void Metrics_tell_every_gait_on_each_ground_at_each_rate()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("metrics", "--seeds", "41-43", "--kind", "any", "--json", "--threads", "2"));
        Assert.Equal("", run.Error);
        JsonElement[] runs = run.Json().GetProperty("runs").EnumerateArray().ToArray();
        Assert.Equal(["runs", "worst"], run.Json().EnumerateObject().Select(member => member.Name));
        foreach (JsonElement told in runs)
        {
            string[] names = told.EnumerateObject().Select(member => member.Name).ToArray();
            Assert.All(contract, word => Assert.Contains(word, names));
            Assert.Contains(told.GetProperty("ground").GetString(), new[] { "flat", "rough" });
            Assert.Contains(told.GetProperty("hertz").GetInt32(), new[] { 30, 60, 144 });
            Assert.Contains(told.GetProperty("kind").GetString(), new[] { "walking", "flying", "swimming" });
            Assert.Equal(JsonValueKind.Number, told.GetProperty("limitViolations").ValueKind);
            Assert.All(names, name => Assert.True(char.IsLower(name[0])));
        }

        // Each creature has six runs of each of its gaits, seeds in their order.
        Assert.Equal(["41", "42", "43"], runs.Select(told => told.GetProperty("seed").GetString()).Distinct());
        Assert.All(runs.GroupBy(told => (told.GetProperty("seed").GetString(), told.GetProperty("gait").GetString())), gait => Assert.Equal(6, gait.Count()));
        string[] gaits = Movement.Of(new MotionProfile(CreatureGenerator.Generate(42))).Where(movement => movement.IsCyclic).Select(movement => movement.GaitName).ToArray();
        Assert.Equal(gaits, runs.Where(told => told.GetProperty("seed").GetString() == "42").Select(told => told.GetProperty("gait").GetString()!).Distinct());
    }

    [Fact(Explicit = true)]
    public void The_worst_of_each_measure_is_that_of_a_run()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("metrics", "--seeds", "41-42", "--kind", "walking", "--json"));
        JsonElement[] runs = run.Json().GetProperty("runs").EnumerateArray().ToArray();
        foreach (Measure<MeasuredRun> measure in MotionMeasure.All)
        {
            JsonElement worst = run.Json().GetProperty("worst").GetProperty(measure.Name);
            float[] values = runs.Select(told => told.GetProperty(measure.Name)).Where(value => value.ValueKind == JsonValueKind.Number).Select(value => value.GetSingle()).ToArray();
            Assert.NotEmpty(values);
            Assert.Equal(measure.Worse == WorseFigure.Greater ? values.Max() : values.Min(), worst.GetProperty("value").GetSingle());
            JsonElement named = Assert.Single(runs, told => new[] { "kind", "seed", "gait", "ground", "hertz" }.All(word => told.GetProperty(word).ToString() == worst.GetProperty(word).ToString()));
            Assert.Equal(worst.GetProperty("value").GetSingle(), named.GetProperty(measure.Name).GetSingle());
        }
    }

    [Fact(Explicit = true)]
    public void Metres_are_leg_lengths_times_the_leg_and_the_figures_those_of_the_library()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("metrics", "--seed", "42", "--json"));
        var profile = new MotionProfile(CreatureGenerator.Generate(42));
        JsonElement[] runs = run.Json().GetProperty("runs").EnumerateArray().ToArray();
        MotionTrial[] trials = MotionTrial.Of(profile).ToArray();
        Assert.Equal(trials.Length, runs.Length);
        for (int i = 0; i < trials.Length; i += 5)
        {
            MotionReport report = trials[i].Run(profile);
            Assert.Equal(report.Slip * profile.LegLength, runs[i].GetProperty("slipMaxMetres").GetSingle());
            Assert.Equal(report.Penetration, runs[i].GetProperty("penetrationMaxLegLengths").GetSingle());
            Assert.Equal(report.StanceResidual * profile.LegLength, runs[i].GetProperty("reachResidualMaxMetres").GetSingle());
            Assert.Equal(report.SwingResidual * profile.LegLength, runs[i].GetProperty("swingResidualMaxMetres").GetSingle());
            Assert.Equal(report.MinSupport, runs[i].GetProperty("supportMin").GetInt32());
        }
    }

    [Theory]
    [InlineData("swimming", "Swim")]
    [InlineData("flying", "Fly", Explicit = true)]
    public void What_does_not_apply_is_null(string kind, string gait)
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("metrics", "--seed", "4", "--kind", kind, "--json"));
        JsonElement told = run.Json().GetProperty("runs").EnumerateArray().First(told => told.GetProperty("gait").GetString() == gait);
        Assert.All(["slipMaxMetres", "penetrationMaxMetres", "clearanceMinMetres", "reachResidualMaxMetres", "supportMin"], word => Assert.Equal(JsonValueKind.Null, told.GetProperty(word).ValueKind));
        Assert.Equal(JsonValueKind.Number, told.GetProperty("poseJumpMax").ValueKind);
    }

    [Fact(Explicit = true)]
    public void Metrics_are_the_same_for_any_number_of_threads()
    {
        using var one = new ConsoleRun();
        using var three = new ConsoleRun();
        Assert.Equal(ExitCode.Done, one.Run("metrics", "--seeds", "1-3", "--json", "--threads", "1"));
        Assert.Equal(ExitCode.Done, three.Run("metrics", "--seeds", "1-3", "--json", "--threads", "3"));
        Assert.Equal(one.Out, three.Out);
    }

    [Fact(Explicit = true)]
    public void Metrics_for_people_are_a_table_of_gaits()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("metrics", "--seed", "42"));
        foreach (Movement movement in Movement.Of(new MotionProfile(CreatureGenerator.Generate(42))).Where(movement => movement.IsCyclic))
        {
            Assert.Contains($"{movement.GaitName,-16} flat", run.Out, StringComparison.Ordinal);
            Assert.Contains($"{movement.GaitName,-16} rough", run.Out, StringComparison.Ordinal);
        }

        Assert.Contains("poseJumpMax", run.Out, StringComparison.Ordinal);
        Assert.DoesNotContain("NaN", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Metrics_that_are_interrupted_can_be_read_as_far_as_they_came()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Interrupted, run.Run(new CancellationToken(true), "metrics", "--seeds", "1-1000000", "--json"));
        Assert.Equal(0, run.Json().GetProperty("runs").GetArrayLength());
        Assert.Equal(JsonValueKind.Null, run.Json().GetProperty("worst").GetProperty("slipMaxMetres").ValueKind);
    }

    [Fact(Explicit = true)]
    public void Animate_writes_a_moving_picture_and_a_strip_whatever_the_spelling_of_the_gait_and_the_threads()
    {
        using var one = new ConsoleRun();
        using var two = new ConsoleRun();
        Assert.Equal(ExitCode.Done, one.Run("animate", "--seed", "42", "--gait", "transverse-gallop", "--ground", "rough", "--out", "go.png", "--size", "96", "--threads", "1"));
        Assert.Equal(ExitCode.Done, two.Run("animate", "--seed", "0x2a", "--gait", "TransverseGALLOP", "--ground", "rough", "--out", "go.png", "--size", "96", "--threads", "3"));
        Assert.Equal("", one.Error);
        Assert.Equal(["go-strip.png", "go.png"], one.Files.Order(StringComparer.Ordinal));
        Assert.Equal(one.AllBytes(), two.AllBytes());
        Assert.Contains("42 TransverseGallop at ", one.Out, StringComparison.Ordinal);
        Assert.Contains("acTL", System.Text.Encoding.Latin1.GetString(one.Bytes("go.png")), StringComparison.Ordinal);
        Assert.DoesNotContain("acTL", System.Text.Encoding.Latin1.GetString(one.Bytes("go-strip.png")), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("Fly", RequestedKind.Flying, "raptor")]
    [InlineData("Hover", RequestedKind.Flying, "raptor", "--gait", "hover")]
    [InlineData("Swim", RequestedKind.Swimming, "fish", "--speed", "0.4")]
    [InlineData("Slither", RequestedKind.Walking, "cobra")]
    [InlineData("Walk", RequestedKind.Walking, "hyena")]
    [InlineData("Walk", RequestedKind.Walking, "hyena", "--speed", "0.4")]
    [InlineData("RotaryGallop", RequestedKind.Walking, "hyena", "--speed", "1000")]
    [InlineData("Canter", RequestedKind.Walking, "hyena", "--speed", "0.2", "--gait", "CANTER")]
    [InlineData("BipedRun", RequestedKind.Walking, "ostrich", "--gait", "run")]
    [InlineData("BipedRun", RequestedKind.Walking, "ostrich", "--gait", "biped-run")]
    public void Without_a_gait_a_creature_does_what_suits_it_and_the_speed(string gait, RequestedKind kind, string body, params string[] words)
    {
        var profile = new MotionProfile(SpeciesSubject.Of(body, kind));
        Movement movement = MovementArguments.Read(ArgumentReader.Read(new AnimateVerb().Syntax, words), profile);
        Assert.Equal(gait, movement.GaitName);
        int speed = Array.IndexOf(words, "--speed");
        Assert.Equal(speed < 0 ? Movement.Of(profile).Single(known => known.GaitName == gait).Input.Speed : float.Parse(words[speed + 1], System.Globalization.CultureInfo.InvariantCulture), movement.Input.Speed);
    }

    [Fact]
    public void Animate_refuses_in_one_line_what_it_cannot_do()
    {
        using var run = new ConsoleRun();
        Assert.Equal(
            "creaturegen: animate: --gait = 'pronk'; expected a gait that this creature has: idle, walk, trot, canter, transverse-gallop",
            run.Refusal(ExitCode.BadInput, "animate", "--seed", "42", "--gait", "pronk", "--out", "a.png"));
        Assert.Contains("did you mean trot?", run.Refusal(ExitCode.BadInput, "animate", "--seed", "42", "--gait", "trott", "--out", "a.png"), StringComparison.Ordinal);
        Assert.Contains("expected metres per second", run.Refusal(ExitCode.BadInput, "animate", "--seed", "42", "--speed", "-1", "--out", "a.png"), StringComparison.Ordinal);
        Assert.Contains("expected metres per second", run.Refusal(ExitCode.BadInput, "animate", "--seed", "42", "--speed", "NaN", "--out", "a.png"), StringComparison.Ordinal);
        Assert.Contains("expected one of flat, rough", run.Refusal(ExitCode.BadInput, "animate", "--seed", "42", "--ground", "steep", "--out", "a.png"), StringComparison.Ordinal);
        Assert.Contains("no --seed", run.Refusal(ExitCode.BadInput, "animate", "--out", "a.png"), StringComparison.Ordinal);
        Assert.Contains("no --out", run.Refusal(ExitCode.BadInput, "animate", "--seed", "42"), StringComparison.Ordinal);
        Assert.Contains("no seeds", run.Refusal(ExitCode.BadInput, "metrics"), StringComparison.Ordinal);
        Assert.Empty(run.Files);
    }

    [Fact]
    public void Animate_writes_both_files_or_none()
    {
        using var run = new ConsoleRun();
        Directory.CreateDirectory(run.At("a-strip.png"));
        Assert.Contains("there is a folder of that name", run.Refusal(ExitCode.CannotWrite, "animate", "--seed", "42", "--out", "a.png", "--size", "64"), StringComparison.Ordinal);
        Assert.Contains("its folder does not exist", run.Refusal(ExitCode.CannotWrite, "animate", "--seed", "42", "--out", "no/a.png", "--size", "64"), StringComparison.Ordinal);
        Assert.Equal(["a-strip.png"], run.Files);

        // As soon as the first file is under way.
        using var disk = new StoppingDisk(path => path.EndsWith(".tmp", StringComparison.Ordinal));
        run.Disk = disk;
        Assert.Equal(ExitCode.Interrupted, run.Run(disk.Token, "animate", "--seed", "42", "--out", "b.png", "--size", "640"));
        Assert.Equal(["a-strip.png"], run.Files);
    }
}
