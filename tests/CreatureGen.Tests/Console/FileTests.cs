using System;
using System.IO;
using System.Linq;
using System.Threading;
using CreatureGen.Blueprints;
using CreatureGen.Console;
using CreatureGen.Console.Files;
using CreatureGen.Pictures;
using CreatureGen.Png;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class FileTests
{
    [Fact]
    public void A_file_that_is_there_is_replaced_whole()
    {
        using var run = new ConsoleRun();
        File.WriteAllText(run.At("a"), "old and longer");
        FileSet.Write(run.At("a"), stream => stream.Write("new"u8), run.Surroundings());
        Assert.Equal("new", File.ReadAllText(run.At("a")));
        Assert.Equal(["a"], run.Files);
    }

    [Fact]
    public void A_failure_in_the_middle_leaves_the_old_file_and_nothing_else()
    {
        using var run = new ConsoleRun();
        File.WriteAllText(run.At("a"), "old");
        var failure = Assert.Throws<WriteFailure>(() => FileSet.Write(run.At("a"), stream =>
        {
            stream.Write("half"u8);
            throw new IOException("no space", 28);
        }, run.Surroundings()));
        Assert.Equal($"cannot write '{run.At("a")}': the disk is full", failure.Message);
        Assert.Equal("old", File.ReadAllText(run.At("a")));
        Assert.Equal(["a"], run.Files);
    }

    [Fact]
    public void Files_of_a_set_appear_together_or_not_at_all()
    {
        using var run = new ConsoleRun();
        Directory.CreateDirectory(run.At("b"));
        using (var set = new FileSet(run.Surroundings()))
        {
            set.Stage(run.At("a"), stream => stream.Write("a"u8));
            Assert.DoesNotContain("a", run.Files);
            Assert.Throws<WriteFailure>(() => set.Stage(run.At("b"), stream => stream.Write("b"u8)));
        }

        Assert.Equal(["b"], run.Files);
    }

    [Fact]
    public void Work_that_is_stopped_leaves_no_file()
    {
        using var run = new ConsoleRun();
        Assert.Throws<OperationCanceledException>(() => FileSet.Write(run.At("a"), stream => stream.Write("a"u8), run.Surroundings() with { Cancellation = new CancellationToken(true) }));
        Assert.Empty(run.Files);
    }

    [Fact]
    public void What_cannot_be_written_is_told_in_one_line()
    {
        using var run = new ConsoleRun();
        Assert.Equal(0, run.Run("generate", "--seed", "1", "--no-picture"));
        File.WriteAllText(run.At("fixed.glb"), "x");
        File.SetAttributes(run.At("fixed.glb"), FileAttributes.ReadOnly);
        Directory.CreateDirectory(run.At("folder"));
        string[] before = run.Files;
        Assert.Equal($"creaturegen: cannot write '{run.At("fixed.glb")}': the file is read-only", run.Refusal(ExitCode.CannotWrite, "build", "creature-1.json", "--out", "fixed.glb"));
        Assert.Equal($"creaturegen: cannot write '{run.At("no/x.glb")}': its folder does not exist", run.Refusal(ExitCode.CannotWrite, "build", "creature-1.json", "--out", "no/x.glb"));
        Assert.Equal($"creaturegen: cannot write '{run.At("folder")}': there is a folder of that name; expected a file", run.Refusal(ExitCode.CannotWrite, "build", "creature-1.json", "--out", "folder"));
        Assert.Contains("its folder does not exist", run.Refusal(ExitCode.CannotWrite, "sheet", "--seeds", "1-2", "--out", "no/x.png"), StringComparison.Ordinal);
        Assert.Contains("expected a folder", run.Refusal(ExitCode.CannotWrite, "generate", "--seed", "1", "--out", "fixed.glb"), StringComparison.Ordinal);
        Assert.Equal("x", File.ReadAllText(run.At("fixed.glb")));
        Assert.Equal(before, run.Files);
    }

    [Fact]
    public void A_creature_of_which_one_file_cannot_be_written_gets_none()
    {
        using var run = new ConsoleRun();
        Directory.CreateDirectory(run.At("creature-5.json"));
        run.Refusal(ExitCode.CannotWrite, "generate", "--seed", "5", "--no-picture");
        Assert.Equal(["creature-5.json"], run.Files);
    }

    [Fact]
    public void Devices_are_no_files()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "devices are files on Unix alone");
        using var run = new ConsoleRun();
        Assert.Equal(0, run.Run("generate", "--seed", "1", "--no-picture"));
        Assert.Equal("creaturegen: cannot write '/dev/null': it is a device; expected a file", run.Refusal(ExitCode.CannotWrite, "build", "creature-1.json", "--out", "/dev/null"));
    }

    [Fact]
    public void A_link_stays_a_link_and_what_it_points_to_is_written()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "links need rights on Windows");
        using var run = new ConsoleRun();
        File.WriteAllText(run.At("real"), "old");
        File.CreateSymbolicLink(run.At("link"), run.At("real"));
        FileSet.Write(run.At("link"), stream => stream.Write("new"u8), run.Surroundings());
        Assert.Equal("new", File.ReadAllText(run.At("real")));
        Assert.NotNull(new FileInfo(run.At("link")).LinkTarget);
        Assert.Equal(2, run.Files.Length);
    }

    [Theory]
    [InlineData("generate", "--seeds", "1-1000000", "--no-picture")]
    [InlineData("sheet", "--seeds", "1-8", "--out", "x.png")]
    [InlineData("verify", "--seeds", "1-1000000")]
    [InlineData("metrics", "--seeds", "1-1000000")]
    [InlineData("animate", "--seed", "42", "--out", "x.png")]
    public void An_interrupted_run_says_so_and_leaves_nothing_behind(params string[] arguments)
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Interrupted, run.Run(new CancellationToken(true), arguments));
        Assert.Equal("creaturegen: interrupted; no unfinished file is left" + Environment.NewLine, run.Error);
        Assert.Empty(run.Files);
    }

    [Fact]
    public void A_run_that_is_interrupted_in_the_middle_leaves_whole_creatures_alone()
    {
        // Far more than are under way at once, so that some have been reported.
        int written = 0;
        using var disk = new StoppingDisk(path => path.EndsWith(".glb", StringComparison.Ordinal) && Interlocked.Increment(ref written) > 8 * Environment.ProcessorCount);
        using var run = new ConsoleRun { Disk = disk };
        Assert.Equal(ExitCode.Interrupted, run.Run(disk.Token, "generate", "--seeds", "1-1000000", "--no-picture", "--textures", "none", "--json"));
        string[] seeds = run.Json().GetProperty("creatures").EnumerateArray().Select(creature => creature.GetProperty("seed").GetString()!).ToArray();
        Assert.NotEmpty(seeds);
        Assert.DoesNotContain(run.Files, name => name.EndsWith(".tmp", StringComparison.Ordinal));
        Assert.All(seeds, seed => Assert.Contains($"creature-{seed}.glb", run.Files));
    }

    [Fact]
    public void A_picture_that_holds_a_blueprint_builds_the_same_file_as_the_blueprint()
    {
        using var run = new ConsoleRun();
        CreatureBlueprint blueprint = BlueprintSampler.Sample(12);
        using var picture = new MemoryStream();
        PngEncoder.Write(new byte[12], 2, 2, PngPixels.Rgb, picture);
        picture.Position = 0;
        using (FileStream file = File.Create(run.At("me.png")))
        {
            BlueprintPicture.Write(picture, blueprint, file);
        }

        File.WriteAllText(run.At("me.json"), BlueprintJson.Write(blueprint));
        Assert.Equal(ExitCode.Done, run.Run("build", "me.png", "--out", "a.glb", "--textures", "none"));
        Assert.Equal(ExitCode.Done, run.Run("build", "me.json", "--out", "b.glb", "--textures", "none"));

        Assert.Equal(File.ReadAllBytes(run.At("b.glb")), File.ReadAllBytes(run.At("a.glb")));
    }
}
