using System;
using System.Globalization;
using System.Linq;
using System.Threading;
using CreatureGen.Anatomy;
using Xunit;

namespace CreatureGen.Tests.Motion.Soak;

public sealed class SoakTests
{
    /// <summary>A sample of it; the long one is <see cref="For_hours_as_well"/>.</summary>
    [Fact]
    public void Whatever_creatures_are_told_all_numbers_stay_numbers_and_nothing_is_allocated() => Run(seed: 1, seconds: 400, each: 40);

    /// <summary>Run by <c>-explicit only -class "*SoakTests"</c>: as many hours of the creatures' time as the environment variable SOAK_HOURS says (24), beginning at the seed SOAK_SEED (1).</summary>
    [Fact(Explicit = true)]
    public void For_hours_as_well() => Run(ulong.Parse(Setting("SOAK_SEED", "1"), CultureInfo.InvariantCulture), 3600 * double.Parse(Setting("SOAK_HOURS", "24"), CultureInfo.InvariantCulture), 600);

    /// <summary>One creature of a long run again: the environment variable SOAK_CREATURE has its kind and seed as the long run told them.</summary>
    [Fact(Explicit = true)]
    public void For_one_creature_again()
    {
        string[] words = Setting("SOAK_CREATURE", "Walking 42").Split(' ');
        var run = new SoakRun(1);
        run.RunOne(ulong.Parse(words[1], CultureInfo.InvariantCulture), Enum.Parse<LocomotionKind>(words[0]), 600);
        Assert.True(run.Failures.Count == 0, (run.FirstException ?? run.First) + "\n" + string.Join("\n", run.Failures.Take(10).Select(f => FormattableString.Invariant($"{f.Value} × {f.Key}"))));
    }

    private static string Setting(string name, string otherwise) => Environment.GetEnvironmentVariable(name) is { Length: > 0 } value ? value : otherwise;

    /// <summary>An update that never ends would keep the run from its end: a watchdog looks whether it goes on.</summary>
    private static void Run(ulong seed, double seconds, double each)
    {
        var run = new SoakRun(seed);
        Exception? failure = null;
        var worker = new Thread(() =>
        {
            try
            {
                // What happens once in a process, such as the making of tables, happens here: the very same creatures do the very same things twice.
                new SoakRun(seed).Run(Math.Min(seconds, 400), each);
                run.Run(seconds, each);
            }
            catch (Exception problem)
            {
                failure = problem;
            }
        }) { IsBackground = true };
        worker.Start();
        for (long before = -1; !worker.Join(TimeSpan.FromMinutes(4)); before = run.Updates)
        {
            Assert.True(run.Updates > before || before < 0, $"an update does not end: {run.Current}");
        }

        Assert.True(failure is null, failure?.ToString());
        string report = FormattableString.Invariant($"{run.SimulatedSeconds / 3600:0.00} h, {run.Creatures} creatures, {run.Updates} updates, {run.Refused} hits refused, {run.Thrown} exceptions of grounds, longest update {1000 * run.Longest:0.0} ms");
        TestContext.Current.TestOutputHelper?.WriteLine(report);
        Assert.True(run.Failures.Count == 0, report + "\nfirst: " + (run.FirstException ?? run.First) + "\n" + string.Join("\n", run.Failures.Take(40).Select(f => FormattableString.Invariant($"{f.Value} × {f.Key}"))));
        Assert.True(run.Refused > 0 && run.Thrown > 0, report);
    }
}
