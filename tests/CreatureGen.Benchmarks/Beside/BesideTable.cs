using System;
using System.Diagnostics;
using System.IO;
using System.Linq;

namespace CreatureGen.Benchmarks.Beside;

/// <summary>This library's times beside those of an earlier commit: both do the same rounds in turns, and of each item the fastest round counts, so that other programs on the machine do not.</summary>
internal static class BesideTable
{
    private const int Blueprints = 180;
    private const int MinRounds = 6;
    private static readonly TimeSpan perRow = TimeSpan.FromSeconds(8);

    /// <summary>Builds, measures and prints.</summary>
    /// <param name="commit">The commit that goals are shares of.</param>
    /// <param name="only">A row's name; all rows if empty.</param>
    /// <param name="output">Where to.</param>
    public static void Print(string commit, string only, TextWriter output)
    {
        string folder = Path.Combine(Path.GetTempPath(), "creaturegen-beside-" + commit);
        string blueprints = Path.Combine(folder, "blueprints");
        Directory.CreateDirectory(blueprints);
        string thenProgram = ProbeBuild.Then(commit, folder);
        string nowProgram = ProbeBuild.Now(folder);
        using var then = new ProbeProcess(thenProgram);
        using var now = new ProbeProcess(nowProgram);
        using var untiered = new ProbeProcess(nowProgram, tiered: false);
        then.Write(blueprints, Blueprints);
        ProbeProcess[] probes = { then, now, untiered };
        foreach (ProbeProcess probe in probes)
        {
            probe.Read(blueprints);
        }

        output.WriteLine(FormattableString.Invariant($"{Environment.ProcessorCount} processors, .NET {Environment.Version}; {Blueprints} animals of commit {commit}, of each the fastest of many rounds; µs"));
        output.WriteLine();
        output.WriteLine($"| work | {commit}, median | p99 | now, median | p99 | share of the median | of p99 | goal | without tiers over now |");
        output.WriteLine("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
        foreach (Comparison comparison in Comparison.All.Where(c => only.Length == 0 || c.Row == only))
        {
            double[][] best = Fastest(probes, comparison.Row);
            (double thenMedian, double thenP99) = Quantiles(best[0]);
            (double nowMedian, double nowP99) = Quantiles(best[1]);
            (double untieredMedian, _) = Quantiles(best[2]);
            string goal = comparison.Goal is double share ? FormattableString.Invariant($"{share:0.##}") : "–";
            output.WriteLine(FormattableString.Invariant($"| {comparison.Work} | {thenMedian:G3} | {thenP99:G3} | {nowMedian:G3} | {nowP99:G3} | {nowMedian / thenMedian:F2} | {nowP99 / thenP99:F2} | {goal} | {untieredMedian / nowMedian:F2} |"));
        }
    }

    private static double[][] Fastest(ProbeProcess[] probes, string row)
    {
        double[][] best = Array.ConvertAll(probes, probe => probe.Round(row));
        var watch = Stopwatch.StartNew();
        for (int round = 0; round < MinRounds || watch.Elapsed < perRow; round++)
        {
            for (int i = 0; i < probes.Length; i++)
            {
                double[] times = probes[i].Round(row);
                best[i] = best[i].Zip(times, Math.Min).ToArray();
            }
        }

        return best;
    }

    /// <summary>Microseconds of the middle item and of the dearest but one in a hundred.</summary>
    private static (double Median, double P99) Quantiles(double[] nanoseconds)
    {
        double[] sorted = nanoseconds.Order().ToArray();
        return (sorted[sorted.Length / 2] / 1000, sorted[(int)(0.99 * (sorted.Length - 1))] / 1000);
    }
}
