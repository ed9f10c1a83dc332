using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Threading;
using CreatureGen.Blueprints;
using CreatureGen.Console;
using CreatureGen.Console.Batches;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using Xunit;

namespace CreatureGen.Tests.Console;

/// <summary>Batches that are shared between tasks, killed, and taken up again.</summary>
public sealed class BatchTests
{
    // Small enough to be made many times over.
    private const string Few = "generate --seeds 3-5,40 --individuals 1 --views side --picture-size 16x16 --triangles 6000 --textures none --out farm";

    [Theory]
    [InlineData(1, Explicit = true)]
    [InlineData(3, Explicit = true)]
    [InlineData(7, Explicit = true)]
    public void Any_number_of_shards_gives_the_files_of_one_run_and_merges_to_its_manifest(int count)
    {
        IReadOnlyDictionary<string, byte[]> whole = Whole();
        using var run = new ConsoleRun();
        for (int i = 0; i < count; i++)
        {
            Assert.Equal(ExitCode.Done, run.Run(Words($"{Few} --shard {i}/{count}")));
        }

        Assert.Equal(count > 1 ? ExitCode.Done : ExitCode.BadInput, run.Run("merge", "farm"));
        IReadOnlyDictionary<string, byte[]> made = WithoutTimes(run);
        Assert.Equal(whole, made.Where(file => !file.Key.Contains("-of-", StringComparison.Ordinal)).ToDictionary());
        Assert.Equal(count > 1 ? count : 0, made.Count - whole.Count);
        Assert.Equal(ExitCode.Done, run.Run("verify", "--manifest", "farm", "--grow"));
        Assert.Contains("4 creatures listed, 0 problems", run.Out, StringComparison.Ordinal);
    }

    /// <summary>The disk ends in each of its operations as for a process that is killed there; whoever takes the work up does what is left, and the files are those of an unbroken run.</summary>
    [Theory]
    [InlineData(11, Explicit = true)]
    [InlineData(3, Explicit = true)]
    public void A_batch_that_is_killed_at_any_moment_and_taken_up_again_gives_the_same_bytes(int apart)
    {
        IReadOnlyDictionary<string, byte[]> whole = Whole();
        for (int n = 2; ; n += apart)
        {
            using var run = new ConsoleRun();
            var disk = new KilledDisk(n);
            run.Disk = disk;
            if (run.Run(Words(Few + " --manifest --threads 1")) == ExitCode.Done)
            {
                Assert.True(n > 30, "the disk was never killed");
                break;
            }

            Assert.True(disk.IsDead);
            run.Disk = new LocalDisk();
            Assert.Equal(ExitCode.Done, run.Run(Words(Few + " --resume --threads 1")));
            Assert.Equal(whole, WithoutTimes(run).Where(file => !file.Key.EndsWith(".tmp", StringComparison.Ordinal)).ToDictionary());
        }
    }

    [Theory]
    [InlineData(9, Explicit = true)]
    [InlineData(17)]
    [InlineData(22, Explicit = true)]
    public void A_batch_whose_disk_is_full_says_so_and_goes_on_when_there_is_room(int n)
    {
        using var run = new ConsoleRun { Disk = new FailingDisk(n) };
        Assert.Equal(ExitCode.CannotWrite, run.Run(Words(Few + " --manifest --threads 1")));
        Assert.EndsWith("the disk is full" + Environment.NewLine, run.Error, StringComparison.Ordinal);
        Assert.Equal(1, run.Error.Count(letter => letter == '\n'));
        run.Disk = new LocalDisk();
        Assert.Equal(ExitCode.Done, run.Run(Words(Few + " --resume")));
        Assert.Equal(Whole(), WithoutTimes(run));
    }

    [Fact(Explicit = true)]
    public void What_was_done_is_kept_and_what_was_lost_or_altered_is_made_anew()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run(Words(Few + " --manifest")));
        IReadOnlyDictionary<string, byte[]> whole = WithoutTimes(run);
        File.Delete(run.At("farm/creature-4-1.png"));
        byte[] altered = File.ReadAllBytes(run.At("farm/creature-40-1.glb"));
        altered[^1] ^= 1;
        File.WriteAllBytes(run.At("farm/creature-40-1.glb"), altered);
        Assert.Equal(ExitCode.CheckFailed, run.Run("verify", "--manifest", "farm"));
        Assert.Contains("creature-4-1.png is missing", run.Out, StringComparison.Ordinal);
        Assert.Contains("creature-40-1.glb has other content than the manifest says", run.Out, StringComparison.Ordinal);
        DateTime before = File.GetLastWriteTimeUtc(run.At("farm/creature-3-1.glb"));
        Assert.Equal(ExitCode.Done, run.Run(Words(Few + " --resume --json")));
        Assert.Equal(["3-1", "5-1"], run.Json().GetProperty("kept").EnumerateArray().Select(name => name.GetString()));
        Assert.Equal(["4", "40"], run.Json().GetProperty("creatures").EnumerateArray().Select(creature => creature.GetProperty("seed").GetString()));
        Assert.Equal(before, File.GetLastWriteTimeUtc(run.At("farm/creature-3-1.glb")));
        Assert.Equal(whole, WithoutTimes(run));
    }

    [Fact]
    public void A_signal_lets_the_creature_in_hand_be_finished_and_listed()
    {
        int written = 0;
        using var disk = new StoppingDisk(path => path.EndsWith(".glb", StringComparison.Ordinal) && Interlocked.Increment(ref written) > 2);
        using var run = new ConsoleRun { Disk = disk };
        Assert.Equal(ExitCode.Interrupted, run.Run(disk.Token, Words("generate --seeds 1-1000000 --no-picture --triangles 6000 --textures none --threads 2 --out farm --manifest")));

        string[] lines = File.ReadAllLines(run.At("farm/manifest.jsonl"));
        string[] listed = lines.Skip(1).Select(line => "creature-" + Json(line).GetProperty("seed").GetString() + ".glb").Order(StringComparer.Ordinal).ToArray();
        string[] made = Directory.GetFiles(run.At("farm"), "*.glb").Select(path => Path.GetFileName(path)).Order(StringComparer.Ordinal).ToArray();
        Assert.Equal(made, listed);
    }

    /// <summary>What takes longer than a signal leaves it is left out between two of its clips, pictures or files.</summary>
    [Theory]
    [InlineData("--clips all --no-picture --textures none", Explicit = true)]
    [InlineData("--dataset 3 --no-picture --textures none --picture-size 32x32", Explicit = true)]
    [InlineData("--views all --picture-size 32x32 --textures none", Explicit = true)]
    public void A_creature_that_is_abandoned_leaves_no_file_and_no_line_and_the_next_run_makes_it(string heavy)
    {
        using var whole = new ConsoleRun();
        using var disk = new StoppingDisk(path => path.EndsWith("creature-1.glb", StringComparison.Ordinal));
        using var run = new ConsoleRun { Disk = disk };
        string words = $"generate --seeds 1-3 --triangles 6000 {heavy} --threads 1 --out farm";
        Assert.Equal(ExitCode.Done, whole.Run(Words(words + " --manifest")));
        string manifest = run.At("farm/manifest.jsonl");
        Assert.Equal(ExitCode.Interrupted, run.Run(run.Surroundings() with { Cancellation = disk.Token, Abandonment = disk.Token }, Words(words + " --resume")));
        Assert.Equal("creaturegen: interrupted; no unfinished file is left" + Environment.NewLine, run.Error);
        string[] listed = File.ReadAllLines(manifest).Skip(1).SelectMany(line => Json(line).GetProperty("files").EnumerateArray()).Select(file => file.GetProperty("path").GetString()!).Order(StringComparer.Ordinal).ToArray();
        Assert.Equal(Directory.GetFiles(run.At("farm"), "creature-*").Select(path => Path.GetFileName(path)).Order(StringComparer.Ordinal), listed);
        Assert.DoesNotContain(listed, name => name.StartsWith("creature-3", StringComparison.Ordinal));
        Assert.Equal(ExitCode.Done, run.Run(Words(words + " --resume")));
        Assert.Equal(WithoutTimes(whole), WithoutTimes(run));
    }

    [Fact]
    public void A_manifest_lists_each_creature_with_its_versions_files_and_looks()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run(Words("generate --seeds 7 --clips all --views side,front --picture-size 32x16 --transparent --triangles 6000 --textures none --manifest --out farm")));
        JsonElement[] lines = File.ReadAllLines(run.At("farm/manifest.jsonl")).Select(Json).ToArray();
        Assert.Equal(3, lines.Length);
        Assert.Equal("0/1", lines[0].GetProperty("shard").GetString());
        Assert.Equal("7", lines[1].GetProperty("seed").GetString());
        Assert.Equal(CreatureBlueprint.CurrentAlgorithm, lines[1].GetProperty("algorithm").GetInt32());
        Assert.Equal(["creature-7.glb", "creature-7-side.png", "creature-7-front.png", "creature-7.json"], lines[1].GetProperty("files").EnumerateArray().Select(file => file.GetProperty("path").GetString()));
        Assert.NotEmpty(lines[1].GetProperty("clips").EnumerateArray());
        Assert.True(lines[1].GetProperty("joints").GetInt32() > 10);
        Assert.True(lines[2].GetProperty("complete").GetBoolean());
        byte[] png = File.ReadAllBytes(run.At("farm/creature-7-front.png"));
        Assert.Equal([32, 16], [png[19], png[23]]);
        Assert.Equal(6, png[25]);
        Assert.Single(File.ReadAllLines(run.At("farm/times.jsonl")));
    }

    [Fact]
    public void Seeds_without_a_creature_are_listed_and_the_batch_goes_on()
    {
        using var run = new ConsoleRun();
        const string some = "generate --seeds 1-8 " + RareCreatures.Options + " --no-picture --textures none --out farm";
        Assert.Equal(ExitCode.CheckFailed, run.Run(Words(some + " --manifest")));
        string[] lines = File.ReadAllLines(run.At("farm/manifest.jsonl"));
        Assert.Equal(10, lines.Length);
        int missing = lines.Count(line => line.Contains("\"missing\":\"", StringComparison.Ordinal));
        Assert.InRange(missing, 1, 7);
        Assert.Equal(missing, Json(lines[^1]).GetProperty("missing").GetInt32());
        Assert.Equal(8 - missing, Json(lines[^1]).GetProperty("creatures").GetInt32());
        Assert.Equal(ExitCode.CheckFailed, run.Run(Words(some + " --resume")));
        Assert.Equal(lines, File.ReadAllLines(run.At("farm/manifest.jsonl")));
        Assert.Equal(ExitCode.Done, run.Run("verify", "--manifest", "farm", "--grow"));
    }

    [Theory]
    [InlineData("--seeds 3-6", "seeds 3-6, not 3-5,40")]
    [InlineData("--seeds 3-5,40 --kind swimming", "other options of the creatures or their files")]
    [InlineData("--seeds 3-5,40 --flat", "other options of the creatures or their files")]
    public void The_manifest_of_another_batch_is_refused_and_stays(string options, string difference)
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run(Words("generate --seeds 3-5,40 --no-picture --triangles 6000 --textures none --out farm --manifest")));
        byte[] before = File.ReadAllBytes(run.At("farm/manifest.jsonl"));
        foreach (string how in new[] { "--resume", "--manifest" })
        {
            string refusal = run.Refusal(ExitCode.BadInput, Words($"generate {options} --no-picture --triangles 6000 --textures none --out farm {how}"));
            Assert.Contains(difference, refusal, StringComparison.Ordinal);
            Assert.Contains("expected another --out", refusal, StringComparison.Ordinal);
        }

        Assert.Equal(before, File.ReadAllBytes(run.At("farm/manifest.jsonl")));
    }

    [Fact]
    public void A_second_task_with_the_same_shard_is_refused_while_the_first_works()
    {
        using var run = new ConsoleRun();
        string refusal = "";
        Directory.CreateDirectory(run.At("farm"));
        using (new LocalDisk().Hold(run.At("farm/times-1-of-4.jsonl")))
        {
            refusal = run.Refusal(ExitCode.CannotWrite, Words(Few + " --shard 1/4"));
            Assert.Equal(ExitCode.Done, run.Run(Words(Few + " --shard 2/4")));
        }

        Assert.Contains("another task is at work on shard 1/4", refusal, StringComparison.Ordinal);
        Assert.Equal(ExitCode.Done, run.Run(Words(Few + " --shard 1/4")));
    }

    [Fact]
    public void Merging_tells_what_is_missing_doubled_or_different()
    {
        using var run = new ConsoleRun();
        const string bare = "generate --seeds 1-6 --no-picture --triangles 6000 --textures none --out farm";
        for (int i = 0; i < 3; i++)
        {
            Assert.Equal(ExitCode.Done, run.Run(Words($"{bare} --shard {i}/3")));
        }

        string path = run.At("farm/manifest-1-of-3.jsonl");
        string[] lines = File.ReadAllLines(path);
        Assert.Equal("creature 2 is missing in shard 1/3", Problem(lines[0], lines[2], lines[3]));
        Assert.Equal("creature 5 is listed twice, at last in shard 1/3", Problem(lines[0], lines[1], lines[2], lines[2], lines[3]));
        Assert.Equal("creature 5 is listed twice, differently, at last in shard 1/3", Problem(lines[0], lines[1], lines[2], lines[2].Replace("\"joints\":", "\"joints\":1", StringComparison.Ordinal), lines[3]));
        Assert.Equal("creature 9 does not belong to the batch", Problem(lines[0], lines[1], lines[2], lines[1].Replace("\"seed\":\"2\"", "\"seed\":\"9\"", StringComparison.Ordinal), lines[3]));
        Assert.Equal("shard 1/3 is not complete: --resume makes the rest", Problem(lines[0], lines[1]));
        File.Delete(path);
        Assert.Equal(ExitCode.CheckFailed, run.Run("merge", "farm"));
        Assert.Contains("shard 1/3 is missing", run.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(run.At("farm/manifest.jsonl")));
        Assert.Equal(ExitCode.Done, run.Run(Words($"{bare} --shard 1/4")));
        Assert.Contains("is of 4 shards", run.Refusal(ExitCode.BadInput, "merge", "farm"), StringComparison.Ordinal);

        string Problem(params string[] changed)
        {
            File.WriteAllText(path, string.Concat(changed.Select(line => line + "\n")));
            Assert.Equal(ExitCode.CheckFailed, run.Run("merge", "farm"));
            string[] told = run.Error.TrimEnd().Split(Environment.NewLine);
            Assert.Equal(2, told.Length);
            return told[1].Trim();
        }
    }

    [Fact]
    public void A_manifest_that_was_tampered_with_is_refused_with_its_line()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run(Words("generate --seeds 1-2 --no-picture --triangles 6000 --textures none --out farm --manifest")));
        string[] lines = File.ReadAllLines(run.At("farm/manifest.jsonl"));
        foreach (string bad in new[] { "{", "[]", "{\"seed\":1}", lines[1].Replace("creature-1.glb", "../creature-1.glb", StringComparison.Ordinal) })
        {
            File.WriteAllText(run.At("farm/manifest.jsonl"), string.Join('\n', lines[0], lines[1], bad, lines[3], ""));
            Assert.Contains("line 3: ", run.Refusal(ExitCode.BadInput, "verify", "--manifest", "farm"), StringComparison.Ordinal);
        }

        File.WriteAllText(run.At("farm/manifest.jsonl"), "{}\n");
        Assert.Contains("no manifests of shards in", run.Refusal(ExitCode.BadInput, "merge", "farm"), StringComparison.Ordinal);
        Assert.Contains("line 1: expected the first line of a manifest", run.Refusal(ExitCode.BadInput, "verify", "--manifest", "farm/manifest.jsonl"), StringComparison.Ordinal);
    }

    [Fact(Explicit = true)]
    public void Existing_files_can_be_left_out_without_a_manifest()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run(Words("generate --seeds 1-2 --no-picture --triangles 6000 --textures none")));
        File.WriteAllText(run.At("creature-2.glb"), "mine");
        Assert.Equal(ExitCode.Done, run.Run(Words("generate --seeds 1-3 --no-picture --triangles 6000 --textures none --skip-existing")));
        Assert.Contains("1 creatures in", run.Out, StringComparison.Ordinal);
        Assert.Contains("2 there already", run.Out, StringComparison.Ordinal);
        Assert.Equal("mine", File.ReadAllText(run.At("creature-2.glb")));
        Assert.Equal(ExitCode.Done, run.Run(Words("generate --seeds 1-4 --no-picture --skip-existing --dry-run")));
        Assert.Equal(string.Concat(new[] { "creature-4.glb", "creature-4.json" }.Select(name => run.At(name) + Environment.NewLine)), run.Out);
        Assert.Equal(6, run.Files.Length);
    }

    [Fact]
    public void A_dry_run_tells_what_is_left_and_how_large_it_will_be_and_leaves_everything_as_it_is()
    {
        using var run = new ConsoleRun();
        string[] line = Words("generate --seeds 1-3 --no-picture --triangles 6000 --textures none --out farm --resume");
        Assert.Equal(ExitCode.Done, run.Run(line));
        long bytes = new[] { "1", "3" }.Sum(seed => run.Bytes($"farm/creature-{seed}.glb").LongLength + run.Bytes($"farm/creature-{seed}.json").LongLength);
        File.Delete(run.At("farm/creature-1.glb"));
        File.Delete(run.At("farm/creature-3.json"));
        (string, DateTime)[] before = Look();
        Assert.Equal(ExitCode.Done, run.Run([.. line, "--dry-run"]));
        Assert.Equal(new[] { "1.glb", "1.json", "3.glb", "3.json" }.Select(name => run.At("farm/creature-" + name)), run.Out.Split(Environment.NewLine, StringSplitOptions.RemoveEmptyEntries));
        Assert.StartsWith($"2 creatures in 4 files: {Units.Bytes(bytes)}, about ", run.Error, StringComparison.Ordinal);
        Assert.Contains("on one processor, by 2 that were made", run.Error, StringComparison.Ordinal);
        Assert.Equal(before, Look());
        Assert.Equal(ExitCode.Done, run.Run(Words("generate --seeds 1-16 --no-picture --textures none --dry-run")));
        Assert.Contains("16 creatures in 32 files: about ", run.Error, StringComparison.Ordinal);
        Assert.Contains("is of another batch", run.Refusal(ExitCode.BadInput, [.. line, "--dry-run", "--kind", "flying"]), StringComparison.Ordinal);

        (string, DateTime)[] Look() => Directory.GetFiles(run.Folder, "*", SearchOption.AllDirectories).Order(StringComparer.Ordinal).Select(path => (path, File.GetLastWriteTimeUtc(path))).ToArray();
    }

    /// <summary>All files of an unbroken run.</summary>
    private static IReadOnlyDictionary<string, byte[]> Whole()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run(Words(Few + " --manifest")));
        return WithoutTimes(run);
    }

    private static Dictionary<string, byte[]> WithoutTimes(ConsoleRun run) =>
        Directory.GetFiles(run.At("farm")).Where(path => !Path.GetFileName(path).StartsWith("times", StringComparison.Ordinal)).ToDictionary(path => Path.GetFileName(path), File.ReadAllBytes);

    private static string[] Words(string line) => line.Split(' ');

    private static JsonElement Json(string line)
    {
        using JsonDocument document = JsonDocument.Parse(line);
        return document.RootElement.Clone();
    }
}
