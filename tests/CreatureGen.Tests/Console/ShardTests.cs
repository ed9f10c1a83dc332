using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Console;
using CreatureGen.Console.Batches;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class ShardTests
{
    [Theory]
    [InlineData(1, 0)]
    [InlineData(1, 5)]
    [InlineData(4, 3)]
    [InlineData(4, 17)]
    [InlineData(64, 100)]
    public void Shards_share_everything_once(int count, int things)
    {
        int[] all = Enumerable.Range(0, things).ToArray();
        int[][] shares = Enumerable.Range(0, count).Select(i => new Shard(i, count).Of(all).ToArray()).ToArray();
        Assert.Equal(all, shares.SelectMany(share => share).Order());
        Assert.All(shares, (share, i) => Assert.All(share, ordinal => Assert.Equal(i, ordinal % count)));
        Assert.Equal(shares.Select(share => (UInt128)share.Length), Enumerable.Range(0, count).Select(i => new Shard(i, count).CountOf((UInt128)things)));
    }

    [Theory]
    [InlineData("0/1", true)]
    [InlineData("63/64", true)]
    [InlineData("64/64", false)]
    [InlineData("0/0", false)]
    [InlineData("-1/4", false)]
    [InlineData("1/4/2", false)]
    [InlineData("1", false)]
    [InlineData("", false)]
    [InlineData("0/1000001", false)]
    [InlineData("a/b", false)]
    public void A_shard_is_an_index_below_a_count(string text, bool good)
    {
        Assert.Equal(good, Shard.TryRead(text, out Shard shard));
        Assert.Equal(good ? text : "0/1", shard.ToString());
    }

    [Theory]
    [InlineData("--shards 8", "JOB_COMPLETION_INDEX=5", "5/8")]
    [InlineData("--manifest", "SLURM_ARRAY_TASK_ID=12 SLURM_ARRAY_TASK_MIN=10 SLURM_ARRAY_TASK_COUNT=4", "2/4")]
    [InlineData("--resume", "SLURM_ARRAY_TASK_ID=16 SLURM_ARRAY_TASK_MIN=10 SLURM_ARRAY_TASK_COUNT=4 SLURM_ARRAY_TASK_STEP=2", "3/4")]
    [InlineData("--shard 1/2", "JOB_COMPLETION_INDEX=5", "1/2")]
    [InlineData("--manifest", "", "0/1")]
    [InlineData("--shards 1", "", "0/1")]
    public void The_scheduler_tells_the_shard_of_a_batch(string options, string environment, string shard)
    {
        using ConsoleRun run = InEnvironment(environment);
        Assert.Equal(ExitCode.Done, run.Run(["generate", "--seeds", "1-12", "--no-picture", "--textures", "none", "--dry-run", .. options.Split(' ')]));
        Assert.True(Shard.TryRead(shard, out Shard expected));
        Assert.Equal(expected.Of(Enumerable.Range(1, 12)).Select(seed => run.At(FormattableString.Invariant($"creature-{seed}.glb"))), run.Out.Split(Environment.NewLine).Where(line => line.EndsWith("glb", StringComparison.Ordinal)));
    }

    [Fact(Explicit = true)]
    public void A_run_that_is_no_batch_makes_everything_whatever_the_scheduler_tells()
    {
        using ConsoleRun run = InEnvironment("JOB_COMPLETION_INDEX=1");
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seeds", "1-3", "--no-picture", "--dry-run"));
        Assert.Equal(6, run.Out.Count(letter => letter == '\n'));
    }

    [Theory]
    [InlineData("--shard 4/4", "", "--shard = '4/4'; expected i/n")]
    [InlineData("--manifest", "JOB_COMPLETION_INDEX=5", "does not tell of how many; expected --shards N")]
    [InlineData("--shards 4", "JOB_COMPLETION_INDEX=5", "expected an index below the number of shards")]
    [InlineData("--shards 4", "JOB_COMPLETION_INDEX=five", "JOB_COMPLETION_INDEX = 'five'; expected a whole number")]
    [InlineData("--shards 4", "", "--shards 4 without an index")]
    [InlineData("--shard 1/2 --shards 3", "", "expected the same number")]
    [InlineData("--manifest", "SLURM_ARRAY_TASK_ID=1", "SLURM_ARRAY_TASK_ID is there without SLURM_ARRAY_TASK_MIN")]
    [InlineData("--manifest", "SLURM_ARRAY_TASK_ID=7 SLURM_ARRAY_TASK_MIN=1 SLURM_ARRAY_TASK_COUNT=3", "expected an array without gaps")]
    [InlineData("--shards 4", "SLURM_ARRAY_TASK_ID=1 SLURM_ARRAY_TASK_MIN=1 SLURM_ARRAY_TASK_COUNT=3", "expected the same number")]
    [InlineData("--resume --skip-existing", "", "--resume and --skip-existing; expected one of them")]
    public void A_shard_that_cannot_be_is_refused(string options, string environment, string message)
    {
        using ConsoleRun run = InEnvironment(environment);
        Assert.Contains(message, run.Refusal(ExitCode.BadInput, ["generate", "--seeds", "1-12", .. options.Split(' ')]), StringComparison.Ordinal);
        Assert.Empty(run.Files);
    }

    private static ConsoleRun InEnvironment(string variables)
    {
        Dictionary<string, string> all = variables.Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(pair => pair.Split('=')).ToDictionary(pair => pair[0], pair => pair[1]);
        return new ConsoleRun { Variable = name => all.GetValueOrDefault(name) };
    }
}
