using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using CreatureGen.Console;
using CreatureGen.Console.Files;
using Xunit;

namespace CreatureGen.Tests.Console;

/// <summary>Disks that fill up, pipes that close, processes that were killed.</summary>
public sealed class FaultTests
{
    /// <summary>Every operation fails once (of the many of films some): each run ends with the code and the one line for a disk that is full, each file is the old one or the new one, whole, and nothing else is there.</summary>
    [Theory]
    [InlineData("generate --seeds 3-4 --individuals 1 --no-picture --threads 1 --out made", Explicit = true)]
    [InlineData("build given.json --textures none --out given.glb")]
    [InlineData("sheet --seeds 1-2 --size 32 --threads 1 --out sheet.png")]
    [InlineData("animate --seed 42 --size 64 --threads 1 --out film.png", Explicit = true)]
    public void A_disk_that_fails_at_any_operation_leaves_whole_files_alone(string command)
    {
        string[] words = command.Split(' ');
        IReadOnlyDictionary<string, byte[]> whole;
        using (ConsoleRun run = Prepared())
        {
            Assert.Equal(ExitCode.Done, run.Run(words));
            whole = AllFiles(run.Folder);
        }

        int operations = int.MaxValue;
        for (int n = 1; n <= operations; n += words[0] == "animate" && n > 4 ? n : 1)
        {
            using ConsoleRun run = Prepared();
            foreach (string name in whole.Keys.Where(name => name.EndsWith("glb", StringComparison.Ordinal)))
            {
                Directory.CreateDirectory(Path.GetDirectoryName(run.At(name))!);
                File.WriteAllText(run.At(name), "old");
            }

            var disk = new FailingDisk(n);
            run.Disk = disk;
            int code = run.Run(words);
            if (disk.Count < n)
            {
                Assert.Equal(ExitCode.Done, code);
                operations = 0;
                continue;
            }

            Assert.Equal(ExitCode.CannotWrite, code);
            Assert.EndsWith("the disk is full" + Environment.NewLine, run.Error, StringComparison.Ordinal);
            Assert.Equal(1, run.Error.Count(letter => letter == '\n'));
            foreach ((string name, byte[] content) in AllFiles(run.Folder))
            {
                Assert.True(content.AsSpan().SequenceEqual("old"u8) || content.AsSpan().SequenceEqual(whole[name]), $"operation {n} failed: {name} has {content.Length} bytes");
            }
        }

        Assert.Equal(0, operations);
    }

    [Fact(Explicit = true)]
    public void A_file_that_is_replaced_keeps_its_permissions()
    {
        if (OperatingSystem.IsWindows())
        {
            Assert.Skip("Windows has other permissions");
            return;
        }

        using ConsoleRun run = Prepared();
        File.WriteAllText(run.At("given.glb"), "old");
        const UnixFileMode mode = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead;
        File.SetUnixFileMode(run.At("given.glb"), mode);
        Assert.Equal(ExitCode.Done, run.Run("build", "given.json", "--out", "given.glb"));
        Assert.Equal(mode, File.GetUnixFileMode(run.At("given.glb")));
    }

    [Fact(Explicit = true)]
    public void What_a_killed_run_left_is_removed_by_the_next_and_what_another_is_writing_is_not()
    {
        using ConsoleRun run = Prepared();
        string own = TemporaryFile.In(run.Folder);
        string[] parts = Path.GetFileName(own).Split('-');
        string killed = string.Join('-', parts[0], parts[1], "4194304", "0", "1.tmp");
        string elsewhere = string.Join('-', parts[0], "00000000", parts[2], "0", "1.tmp");
        string old = string.Join('-', parts[0], "00000000", parts[2], "0", "2.tmp");
        foreach (string name in new[] { own, run.At(killed), run.At(elsewhere), run.At(old), run.At("mine.tmp") })
        {
            File.WriteAllText(name, "half");
        }

        File.SetLastWriteTimeUtc(run.At(old), DateTime.UtcNow.AddDays(-2));
        Assert.Equal(ExitCode.Done, run.Run("build", "given.json", "--out", "given.glb"));
        Assert.Equal(new[] { Path.GetFileName(own), elsewhere, "given.glb", "given.json", "mine.tmp" }.Order(StringComparer.Ordinal), run.Files);
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seed", "1", "--no-picture"));
        Assert.Contains(elsewhere, run.Files);
    }

    [Fact(Explicit = true)]
    public void A_batch_goes_on_without_the_seeds_that_give_no_creature()
    {
        string[] words = ("generate --seeds 1-8 --no-picture " + RareCreatures.Options).Split(' ');
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.CheckFailed, run.Run(words));
        int complaints = run.Error.Split('\n').Count(l => l.StartsWith("creaturegen: seed ", StringComparison.Ordinal) && l.Contains("gave no creature", StringComparison.Ordinal));
        Assert.InRange(complaints, 1, 7);
        Assert.Equal(2 * (8 - complaints), run.Files.Length);
        Assert.Contains($"{complaints} missing", run.Out, StringComparison.Ordinal);
        using var json = new ConsoleRun();
        Assert.Equal(ExitCode.CheckFailed, json.Run([.. words, "--json", "--threads", "3"]));
        Assert.Equal(8 - complaints, json.Json().GetProperty("creatures").GetArrayLength());
        Assert.Equal(complaints, json.Json().GetProperty("missing").GetArrayLength());
        Assert.Equal(run.Files, json.Files);
        using var fast = new ConsoleRun();
        Assert.Equal(ExitCode.BadInput, fast.Run([.. words, "--fail-fast"]));
    }

    [Fact]
    public void Options_that_no_creature_meets_are_refused_before_a_batch_begins()
    {
        using var run = new ConsoleRun();
        Assert.Contains("no creature has", run.Refusal(ExitCode.BadInput, "generate", "--seeds", "1-8", "--leg-pairs", "16-16", "--kind", "swimming", "--no-picture"), StringComparison.Ordinal);
    }

    [Fact]
    public void A_file_of_an_earlier_process_of_the_same_number_is_stale()
    {
        string[] parts = Path.GetFileName(TemporaryFile.In("")).Split('-');
        Assert.False(TemporaryFile.IsStale(string.Join('-', parts), TimeSpan.Zero));
        parts[3] = "another";
        Assert.True(TemporaryFile.IsStale(string.Join('-', parts), TimeSpan.Zero));
    }

    [Fact(Explicit = true)]
    public void A_dash_is_the_standard_input_and_output()
    {
        using ConsoleRun file = Prepared();
        Assert.Equal(ExitCode.Done, file.Run("build", "given.json", "--out", "given.glb"));
        using var pipe = new ConsoleRun { Input = file.Bytes("given.json") };
        Assert.Equal(ExitCode.Done, pipe.Run("build", "-", "--out", "-"));
        Assert.Equal(file.Bytes("given.glb"), pipe.Data);
        Assert.Equal("", pipe.Out);
        using var second = new ConsoleRun { Input = pipe.Data };
        Assert.Equal(ExitCode.Done, second.Run("inspect", "-", "--json"));
        Assert.Equal(file.Bytes("given.glb").Length, second.Json().GetProperty("file").GetProperty("bytes").GetInt64());
        Assert.Empty(second.Files);
        using var third = new ConsoleRun { Input = "{}"u8.ToArray() };
        Assert.Contains("'-'", third.Run("build", "-", "--out", "x.glb") == ExitCode.BadInput ? third.Error : "", StringComparison.Ordinal);
    }

    /// <summary>In a process of its own, because streams are closed by the shell that starts it.</summary>
    [Theory]
    [InlineData("--help >&-", ExitCode.CannotWrite)]
    [InlineData("--help >&- 2>&-", ExitCode.CannotWrite, Explicit = true)]
    [InlineData("generate --seeds 1-2 --no-picture --textures none >&-", ExitCode.CannotWrite)]
    [InlineData("generate --seeds 1-2 --no-picture --textures none --json >&- 2>&-", ExitCode.CannotWrite, Explicit = true)]
    [InlineData("nonsense 2>&-", ExitCode.BadInput, Explicit = true)]
    [InlineData("generate --seeds 1-2 --no-picture --textures none 2>&-", ExitCode.Done)]
    [InlineData("--help > /dev/full", ExitCode.CannotWrite, Explicit = true)]
    [InlineData("build - --out x.glb < /dev/null", ExitCode.BadInput)]
    [InlineData("build - --out x.glb <&-", ExitCode.BadInput, Explicit = true)]
    [InlineData("inspect - <&- 5< given.json", ExitCode.BadInput)]
    [InlineData("build /dev/stdin --textures none --out x.glb < given.json", ExitCode.Done)]
    [InlineData("build - --textures none --out - < given.json | cat > x.glb; test -s x.glb", ExitCode.Done)]
    public async Task Closed_streams_end_a_run_with_a_code_and_without_a_trace(string line, int code)
    {
        Assert.SkipUnless(File.Exists("/bin/sh") && File.Exists("/dev/full"), "needs a Unix shell");
        using ConsoleRun folder = Prepared();
        string program = typeof(Application).Assembly.Location;
        var start = new ProcessStartInfo("/bin/sh", ["-c", $"dotnet '{program}' {line}"])
        {
            WorkingDirectory = folder.Folder,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment["DOTNET_TieredPGO"] = "0";
        using Process process = Process.Start(start)!;
        Task<string> output = process.StandardOutput.ReadToEndAsync(TestContext.Current.CancellationToken);
        string error = await process.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
        await output;
        await process.WaitForExitAsync(TestContext.Current.CancellationToken);
        Assert.True(code == process.ExitCode, $"exit code {process.ExitCode}: {error}");
        Assert.DoesNotContain("   at ", error, StringComparison.Ordinal);
        Assert.DoesNotContain("Unhandled", error, StringComparison.Ordinal);
    }

    private static ConsoleRun Prepared()
    {
        var run = new ConsoleRun();
        File.WriteAllText(run.At("given.json"), CreatureGen.Blueprints.BlueprintJson.Write(CreatureGen.Sampling.BlueprintSampler.Sample(5)));
        return run;
    }

    private static Dictionary<string, byte[]> AllFiles(string folder) =>
        Directory.GetFiles(folder, "*", SearchOption.AllDirectories).Where(path => !path.EndsWith("given.json", StringComparison.Ordinal)).ToDictionary(path => Path.GetRelativePath(folder, path), File.ReadAllBytes);
}
