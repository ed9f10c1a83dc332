using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;

namespace CreatureGen.Benchmarks.Beside;

/// <summary>This library's probe beside that of an earlier commit and beside peers: all do the same rounds in turns, and of each item the fastest round counts, so that other programs on the machine do not.</summary>
internal sealed class Bench : IDisposable
{
    /// <summary>Creatures that both builds work on.</summary>
    public const int Blueprints = 180;

    /// <summary>Creatures that peers and the runtime for browsers work on.</summary>
    private const int FewBlueprints = 24;

    private const int MinRounds = 6;
    private static readonly TimeSpan perRow = TimeSpan.FromSeconds(8);

    private readonly string thenProgram;
    private readonly string nowProgram;
    private readonly string few;
    private readonly ProbeProcess then;
    private readonly ProbeProcess now;
    private readonly ProbeProcess untiered;
    private readonly Dictionary<Peer, ProbeProcess> peers = new();

    /// <summary>Builds everything.</summary>
    /// <param name="commit">The commit that goals are shares of.</param>
    /// <param name="checkouts">A folder with checkouts of peers; null for none.</param>
    public Bench(string commit, string? checkouts)
    {
        string folder = Path.Combine(Path.GetTempPath(), "creaturegen-beside-" + commit);
        string all = Directory.CreateDirectory(Path.Combine(folder, "blueprints")).FullName;
        few = Directory.CreateDirectory(Path.Combine(folder, "few")).FullName;
        thenProgram = ProbeBuild.Then(commit, folder);
        nowProgram = ProbeBuild.Now(folder);
        then = ProbeProcess.Dotnet(thenProgram, tiered: true);
        now = ProbeProcess.Dotnet(nowProgram, tiered: true);
        untiered = ProbeProcess.Dotnet(nowProgram, tiered: false);
        then.Write(few, FewBlueprints);
        then.Write(all, Blueprints);
        foreach (ProbeProcess probe in new[] { then, now, untiered })
        {
            probe.Read(all);
        }

        if (checkouts != null)
        {
            string subjects = Path.Combine(folder, "subjects");
            now.Export(subjects, FewBlueprints);
            foreach (Peer peer in Peer.All.Where(peer => peer.IsIn(checkouts)))
            {
                ProbeProcess probe = ProbeProcess.Native(peer.Build(checkouts, folder));
                peers.Add(peer, probe);
                probe.Read(subjects);
            }
        }
    }

    /// <summary>The peers that were found.</summary>
    public IEnumerable<Peer> Peers => peers.Keys;

    /// <summary>Measures a row.</summary>
    public Measurement Measure(Comparison comparison)
    {
        var turns = new List<(ProbeProcess Probe, string Row)> { (then, comparison.Row), (now, comparison.Row), (untiered, comparison.Row) };
        if (comparison.Beside is PeerWork work && peers.TryGetValue(work.Peer, out ProbeProcess? peer))
        {
            turns.Add((peer, work.Row));
        }

        double[][] best = turns.Select(turn => turn.Probe.Round(turn.Row)).ToArray();
        var watch = Stopwatch.StartNew();
        for (int round = 0; round < MinRounds || watch.Elapsed < perRow; round++)
        {
            for (int i = 0; i < best.Length; i++)
            {
                best[i] = best[i].Zip(turns[i].Probe.Round(turns[i].Row), Math.Min).ToArray();
            }
        }

        Times[] times = Array.ConvertAll(best, Times.Of);
        return new Measurement(comparison, times[0], times[1], times[2], times.Length > 3 ? times[3] : null);
    }

    /// <summary>Adds what the runtime for browsers takes, where it is at hand.</summary>
    public IEnumerable<Measurement> WithBrowser(IReadOnlyList<Measurement> measurements)
    {
        if (BrowserProbe.Find() is not BrowserProbe browser)
        {
            return measurements;
        }

        IReadOnlyDictionary<string, double[]> earlier = browser.Measure(thenProgram, few), later = browser.Measure(nowProgram, few);
        return measurements.Select(m => later.TryGetValue(m.Comparison.Row, out double[]? times)
            ? m with { BrowserThen = Times.Of(earlier[m.Comparison.Row]), BrowserNow = Times.Of(times) }
            : m);
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        foreach (ProbeProcess probe in peers.Values.Append(then).Append(now).Append(untiered))
        {
            probe.Dispose();
        }
    }
}
