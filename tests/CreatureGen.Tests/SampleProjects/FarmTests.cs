using System;
using System.ComponentModel;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Threading;
using CreatureGen.Console;
using CreatureGen.Tests.Console;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.SampleProjects;

/// <summary>The files of samples/farm do what they say, with the variables that schedulers set.</summary>
public sealed class FarmTests
{
    private const string Small = "--no-picture --textures none --triangles 6000";

    private static readonly string[] scripts = ["samples/farm/farm.sbatch", "samples/farm/run-local.sh", "samples/farm/slurm-rehearsal.sh", "samples/dataset/make.sh", "samples/Unity/build.sh", "samples/Unity/metas.sh", "tools/site/build.sh", "docs/pictures.sh", "docs/renew.sh", "samples/farm/container-rehearsal.sh", "pack.sh"];

    [Fact]
    public void The_line_of_the_kubernetes_job_makes_everything_once()
    {
        string job = RepositoryFiles.Text("samples/farm/kubernetes/job.yaml");
        string[] words = Regex.Match(job, @"args: \[(.*)\]").Groups[1].Value.Split(',').Select(word => word.Trim().Trim('"')).ToArray();
        int completions = int.Parse(Regex.Match(job, @"completions: (\d+)").Groups[1].Value, CultureInfo.InvariantCulture);
        Assert.Equal(completions.ToString(CultureInfo.InvariantCulture), words[Array.IndexOf(words, "--shards") + 1]);
        Assert.Contains("mountPath: " + words[Array.IndexOf(words, "--out") + 1] + "\n", job.ReplaceLineEndings("\n"), StringComparison.Ordinal);
        words[Array.IndexOf(words, "--seeds") + 1] = "1-5";
        words[Array.IndexOf(words, "--out") + 1] = "farm";
        using var farm = new ConsoleRun();
        for (int i = 0; i < completions; i++)
        {
            string index = i.ToString(CultureInfo.InvariantCulture);
            Assert.Equal(ExitCode.Done, Application.Run([.. words, .. Small.Split(' ')], farm.Surroundings() with { Variable = name => name == "JOB_COMPLETION_INDEX" ? index : null }));
        }

        Assert.Equal(ExitCode.Done, farm.Run("merge", "farm"));
        Assert.Contains($"5 creatures of {completions} shards", farm.Out, StringComparison.Ordinal);
    }

    /// <summary>npm fetches the schemas.</summary>
    [Fact(Explicit = true)]
    public void The_kubernetes_job_is_valid_by_the_published_schema()
    {
        string place = Directory.CreateTempSubdirectory("creaturegen-kubernetes-").FullName;
        foreach (string name in new[] { "job.yaml", "package.json", "package-lock.json", "validate.mjs", ".npmrc" })
        {
            File.Copy(SampleFiles.At("samples/farm/kubernetes/" + name), Path.Combine(place, name));
        }

        SampleFiles.Run(place, "npm", ["ci", "--prefer-offline"]);
        Assert.Contains("Job creatures: valid", SampleFiles.Run(place, "node", ["validate.mjs", "job.yaml"]), StringComparison.Ordinal);
        File.WriteAllText(Path.Combine(place, "bad.yaml"), File.ReadAllText(Path.Combine(place, "job.yaml")).Replace("completions: 64", "completions: many", StringComparison.Ordinal));
        using Process bad = SampleFiles.Start(place, "node", ["validate.mjs", "bad.yaml"]);
        bad.WaitForExit();
        Assert.Equal(1, bad.ExitCode);
        Directory.Delete(place, recursive: true);
    }

    [Fact(Explicit = true)]
    public void The_script_for_slurm_makes_the_share_of_its_task()
    {
        RequireShell();
        using var run = new ConsoleRun();
        string program = SampleFiles.Console(run.Folder);
        foreach (string task in new[] { "5", "6" })
        {
            SampleFiles.Run(run.Folder, "/bin/bash", [SampleFiles.At("samples/farm/farm.sbatch")], ("CREATUREGEN", program), ("SEEDS", "1-3"), ("OUT", run.At("farm")), ("OPTIONS", Small), ("SLURM_ARRAY_TASK_ID", task), ("SLURM_ARRAY_TASK_MIN", "5"), ("SLURM_ARRAY_TASK_COUNT", "2"));
        }

        Assert.Equal(ExitCode.Done, run.Run("merge", "farm"));
        Assert.Contains("3 creatures of 2 shards", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Shell_scripts_can_be_read()
    {
        RequireShell();
        Assert.All(scripts, script => SampleFiles.Run(RepositoryFiles.Root, "/bin/bash", ["-n", script]));
    }

    /// <summary>A real process: asked to end it ends well, killed it leaves what can be gone on with. So many that a busy machine looks in time.</summary>
    [Fact(Explicit = true)]
    public void A_task_that_is_terminated_and_then_killed_is_finished_by_the_next()
    {
        RequireShell();
        using var run = new ConsoleRun();
        string program = SampleFiles.Console(run.Folder);
        string manifest = run.At("farm/manifest.jsonl");
        string[] words = $"generate --seeds 1-120 {Small} --threads 1 --resume --out farm".Split(' ');
        using (Process task = SampleFiles.Start(run.Folder, program, words))
        {
            Await(() => Listed(manifest) >= 3);
            Terminate(task);
        }

        int first = Listed(manifest);
        Assert.InRange(first, 3, 119);
        Assert.Equal(first, Directory.GetFiles(run.At("farm"), "*.glb").Length);
        using (Process task = SampleFiles.Start(run.Folder, program, words))
        {
            Await(() => Listed(manifest) >= first + 3);
            task.Kill();
            task.WaitForExit();
        }

        Assert.Equal(ExitCode.Done, run.Run([.. words, "--json"]));
        Assert.InRange(run.Json().GetProperty("kept").GetArrayLength(), first + 3, 119);
        Assert.Equal(ExitCode.Done, run.Run("verify", "--manifest", "farm"));
        Assert.Contains("120 creatures listed, 0 problems", run.Out, StringComparison.Ordinal);
        Assert.DoesNotContain(Directory.GetFiles(run.At("farm")), path => path.EndsWith(".tmp", StringComparison.Ordinal));
    }

    /// <summary>It is held while one looks how far it is and signals, so that nothing is made in between.</summary>
    [Fact(Explicit = true)]
    public void A_task_that_is_terminated_finishes_the_creature_in_hand_and_begins_no_other()
    {
        RequireShell();
        using var run = new ConsoleRun();
        string manifest = run.At("farm/manifest.jsonl");
        using Process task = SampleFiles.Start(run.Folder, SampleFiles.Console(run.Folder), "generate --seeds 1-40 --threads 1 --resume --out farm".Split(' '));
        Await(() => Listed(manifest) >= 1);
        Signal(task, "STOP");
        int before = Listed(manifest);
        Signal(task, "TERM");
        Signal(task, "CONT");
        AssertInterrupted(task);
        Assert.InRange(Listed(manifest), before, before + 1);
        Assert.Equal(3 * Listed(manifest), Directory.GetFiles(run.At("farm"), "creature-*").Length);
    }

    /// <summary>All that can be asked of one creature, on one thread. Counted in time of the processor, against what the same process took until its first creature was whole: about three quarters of a second against many.</summary>
    [Theory]
    [InlineData(2, Explicit = true)]
    [InlineData(7, Explicit = true)]
    public void A_task_that_is_terminated_over_a_creature_with_clips_and_a_data_set_leaves_it_soon(int seed)
    {
        RequireShell();
        Assert.SkipUnless(OperatingSystem.IsLinux(), "only Linux tells the time of a process that has ended");
        using var run = new ConsoleRun();
        using Process task = SampleFiles.Start(run.Folder, SampleFiles.Console(run.Folder), $"generate --seeds {seed}-{seed + 40} --threads 1 --resume --clips all --dataset 8 --out farm".Split(' '));
        Await(() => Listed(run.At("farm/manifest.jsonl")) >= 1);
        TimeSpan before = task.TotalProcessorTime;
        Signal(task, "TERM");
        TimeSpan after = before;
        while (!task.HasExited)
        {
            try
            {
                task.Refresh();
                after = task.TotalProcessorTime;
            }
            catch (Exception gone) when (gone is InvalidOperationException or Win32Exception)
            {
                // It ended between the question and the look, or within the look.
            }

            Thread.Sleep(1);
        }

        Assert.Equal(ExitCode.Interrupted, task.ExitCode);
        Assert.InRange((after - before) / before, 0, 0.33);
        Assert.Equal(Listed(run.At("farm/manifest.jsonl")), Directory.GetFiles(run.At("farm"), "creature-*.glb").Length);
    }

    private static void Terminate(Process task)
    {
        Signal(task, "TERM");
        AssertInterrupted(task);
    }

    private static void Signal(Process task, string name)
    {
        using Process signal = Process.Start("/bin/kill", ["-" + name, task.Id.ToString(CultureInfo.InvariantCulture)]);
        signal.WaitForExit();
    }

    private static void AssertInterrupted(Process task)
    {
        Assert.Contains("interrupted; no unfinished file is left", task.StandardError.ReadToEnd(), StringComparison.Ordinal);
        task.WaitForExit();
        Assert.Equal(ExitCode.Interrupted, task.ExitCode);
    }

    private static int Listed(string manifest) => File.Exists(manifest) ? Lines(manifest).Count(line => line.Contains("\"files\":", StringComparison.Ordinal)) : 0;

    private static IEnumerable<string> Lines(string path)
    {
        using var reader = new StreamReader(new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete));
        return reader.ReadToEnd().Split('\n');
    }

    private static void Await(Func<bool> condition)
    {
        for (int i = 0; i < 12_000 && !condition(); i++)
        {
            Thread.Sleep(5);
        }

        Assert.True(condition());
    }

    private static void RequireShell()
    {
        if (!File.Exists("/bin/bash"))
        {
            Assert.Skip("bash is not here");
        }
    }
}
