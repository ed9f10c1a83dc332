using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace CreatureGen.Benchmarks.Beside;

/// <summary>Times beside those of an earlier commit.</summary>
internal static class SpeedTable
{
    /// <summary>Measures rows beside an earlier commit and prints them as they come.</summary>
    /// <param name="commit">The commit that goals are shares of.</param>
    /// <param name="only">A row's name; all rows if empty.</param>
    /// <param name="output">Where to.</param>
    public static void PrintBeside(string commit, string only, TextWriter output)
    {
        using var bench = new Bench(commit, checkouts: null);
        output.WriteLine(Machine());
        output.WriteLine();
        output.WriteLine(Head(commit));
        foreach (Comparison comparison in Comparison.All.Where(c => only.Length == 0 || c.Row == only))
        {
            output.WriteLine(Line(bench.Measure(comparison)));
        }
    }

    /// <summary>Measures all rows, also in the runtime for browsers and beside peers, prints them and puts them into the document.</summary>
    /// <param name="commit">The commit that goals are shares of.</param>
    /// <param name="checkouts">A folder with checkouts of peers; null for none.</param>
    /// <param name="output">Where to print.</param>
    public static void Make(string commit, string? checkouts, TextWriter output)
    {
        using var bench = new Bench(commit, checkouts);
        Measurement[] measurements = bench.WithBrowser(Comparison.All.Select(bench.Measure).ToArray()).ToArray();
        var lines = new List<string> { Machine(), "", Head(commit) };
        lines.AddRange(measurements.Select(Line));
        lines.Add("");
        lines.AddRange(measurements.Where(m => m.Peer != null).Select(m => $"- {m.Comparison.Work}, beside {m.Comparison.Beside!.Peer.Name}: {m.Comparison.Beside.Work}."));
        SpeedDocument.Put("table", lines, output);
    }

    private static string Head(string commit) =>
        $"| work | {commit}, median, µs | p99 | now, median | p99 | share of the median | of p99 | goal | without tiers over now | in the browser's runtime, µs | share of {commit}'s there | goal there | peer, µs | now over the peer |\n"
        + "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |";

    private static string Line(Measurement m)
    {
        string there = m is { BrowserNow: Times now, BrowserThen: Times then } ? $"{Number(now.Median)} | {Share(now.Median / then.Median)} | {Goal(BrowserProbe.Goals[m.Comparison.Row])}" : "– | – | –";
        string peer = m.Peer is Times theirs ? $"{Number(theirs.Median)} | {Share(m.Now.Median / theirs.Median)}" : "– | –";
        return $"| {m.Comparison.Work} | {Number(m.Then.Median)} | {Number(m.Then.P99)} | {Number(m.Now.Median)} | {Number(m.Now.P99)} | {Share(m.Now.Median / m.Then.Median)} | {Share(m.Now.P99 / m.Then.P99)} | {Goal(m.Comparison.Goal)} | {Share(m.Untiered.Median / m.Now.Median)} | {there} | {peer} |";
    }

    private static string Goal(double? goal) => goal is double share ? FormattableString.Invariant($"{share:0.##}") : "–";

    private static string Share(double share) => FormattableString.Invariant($"{share:F2}");

    /// <summary>Three digits, and no power of ten.</summary>
    private static string Number(double value) => value >= 100 ? value.ToString("#,0", CultureInfo.InvariantCulture) : value.ToString("G3", CultureInfo.InvariantCulture);

    private static string Machine()
    {
        const string Processors = "/proc/cpuinfo", Name = "model name";
        string? model = File.Exists(Processors) ? File.ReadLines(Processors).FirstOrDefault(line => line.StartsWith(Name, StringComparison.Ordinal))?.Split(':')[1].Trim() : null;
        return FormattableString.Invariant($"{Environment.ProcessorCount} processors of {model ?? "unknown make"}, .NET {Environment.Version}, algorithm {Blueprints.CreatureBlueprint.CurrentAlgorithm}; {Bench.Blueprints} animals, of each the fastest of many rounds.");
    }
}
