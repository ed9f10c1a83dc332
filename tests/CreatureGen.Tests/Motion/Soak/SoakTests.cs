using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Threading;
using CreatureGen.Anatomy;
using Xunit;

namespace CreatureGen.Tests.Motion.Soak;

public sealed class SoakTests
{
    /// <summary>A sample of it; the long one is <see cref="For_hours_as_well"/>.</summary>
    [Fact(Explicit = true)]
    public void Whatever_creatures_are_told_all_numbers_stay_numbers_and_nothing_is_allocated() => Run(seed: 1, seconds: 400, each: 40);

    /// <summary>Run by <c>-explicit only -class "*SoakTests"</c>: as many hours of the creatures' time as the environment variable SOAK_HOURS says (1), beginning at the seed SOAK_SEED (1).</summary>
    [Fact(Explicit = true)]
    public void For_hours_as_well() => Run(ulong.Parse(Setting("SOAK_SEED", "1"), CultureInfo.InvariantCulture), 3600 * double.Parse(Setting("SOAK_HOURS", "1"), CultureInfo.InvariantCulture), 600);

    /// <summary>One creature of a long run again: the environment variable SOAK_CREATURE has its kind and seed as the long run told them.</summary>
    [Fact(Explicit = true)]
    public void For_one_creature_again()
    {
        string[] words = Setting("SOAK_CREATURE", "Walking 42").Split(' ');
        Twice(1, run => run.RunOne(ulong.Parse(words[1], CultureInfo.InvariantCulture), Enum.Parse<LocomotionKind>(words[0]), 600));
    }

    private static string Setting(string name, string otherwise) => Environment.GetEnvironmentVariable(name) is { Length: > 0 } value ? value : otherwise;

    private static void Run(ulong seed, double seconds, double each)
    {
        SoakRun run = Twice(seed, soak => soak.Run(seconds, each));
        Assert.True(run.Refused > 0 && run.Thrown > 0, Report(run));
    }

    /// <summary>
    /// The very same creatures do the very same things twice, and what goes wrong must go wrong both times: when tests beside this one bring about a collection, what is left of a thread's block of memory counts as
    /// allocated, in another update each time. An update that never ends would keep the run from its end: a watchdog looks whether it goes on.
    /// </summary>
    private static SoakRun Twice(ulong seed, Action<SoakRun> soak)
    {
        SoakRun[] runs = { new(seed), new(seed) };
        Exception? failure = null;
        var worker = new Thread(() =>
        {
            try
            {
                Array.ForEach(runs, soak);
            }
            catch (Exception problem)
            {
                failure = problem;
            }
        }) { IsBackground = true };
        worker.Start();
        for (long before = -1; !worker.Join(TimeSpan.FromMinutes(4)); before = runs.Sum(run => run.Updates))
        {
            Assert.True(runs.Sum(run => run.Updates) > before || before < 0, $"an update does not end: {runs[1].Current ?? runs[0].Current}");
        }

        Assert.True(failure is null, failure?.ToString());
        IEnumerable<string> failed = runs[1].Failures.Where(f => runs[0].Failures.ContainsKey(f.Key)).Select(f => FormattableString.Invariant($"{f.Value} × {f.Key}"));
        IEnumerable<string> allocating = runs[1].Rooms.Where(runs[0].Rooms.Contains).GroupBy(room => room.Who).Where(made => made.Count() > SoakRun.MaxRooms)
            .Select(made => FormattableString.Invariant($"{made.Key}: {made.Count()} updates allocated memory, the last was update {made.Max(room => room.Update)}"));
        string[] wrong = failed.Concat(allocating).ToArray();
        TestContext.Current.TestOutputHelper?.WriteLine(Report(runs[1]));
        Assert.True(wrong.Length == 0, Report(runs[1]) + "\nfirst: " + (runs[1].FirstException ?? runs[1].First) + "\n" + string.Join("\n", wrong.Take(40)));
        return runs[1];
    }

    private static string Report(SoakRun run) =>
        FormattableString.Invariant($"{run.SimulatedSeconds / 3600:0.00} h, {run.Creatures} creatures, {run.Updates} updates, {run.Refused} hits refused, {run.Thrown} exceptions of grounds, longest update {1000 * run.Longest:0.0} ms");
}
