using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

namespace CreatureGen.Benchmarks.Beside;

/// <summary>The probe in the runtime for browsers, on Node.</summary>
internal sealed class BrowserProbe
{
    private const string Script = "tests/browser/run.mjs";

    /// <summary>Names the version of the runtime.</summary>
    private const string Page = "samples/CreatureGen.Lab.Runtime/CreatureGen.Lab.Runtime.csproj";

    /// <summary>For a row's rounds.</summary>
    private const int Milliseconds = 600;

    private readonly string pack;

    private BrowserProbe(string pack) => this.pack = pack;

    /// <summary>Rows that are timed there, and the goals there as parts of the earlier commit's time there.</summary>
    public static IReadOnlyDictionary<string, double?> Goals { get; } = new Dictionary<string, double?>
    {
        ["creature"] = 0.3,
        ["profile"] = null,
        ["walk"] = 0.35,
        ["fly"] = null,
        ["swim"] = null,
        ["blend"] = null,
        ["mixer"] = null,
        ["chain"] = null,
        ["twobone"] = null,
        ["skinning"] = null,
    };

    /// <summary>The runtime that the lab's page has; null where it has not been restored.</summary>
    public static BrowserProbe? Find()
    {
        string version = Regex.Match(File.ReadAllText(Path.Combine(ProbeBuild.Root, Page)), "<PageRuntime>(.*)</PageRuntime>").Groups[1].Value;
        string packages = Environment.GetEnvironmentVariable("NUGET_PACKAGES") is { Length: > 0 } set ? set : Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.UserProfile), ".nuget", "packages");
        string pack = Path.Combine(packages, "microsoft.netcore.app.runtime.mono.browser-wasm", version, "runtimes", "browser-wasm");
        return Directory.Exists(pack) ? new BrowserProbe(pack) : null;
    }

    /// <summary>Nanoseconds of each item of each row, its fastest round.</summary>
    /// <param name="program">The probe's assembly.</param>
    /// <param name="blueprints">What it works on.</param>
    public IReadOnlyDictionary<string, double[]> Measure(string program, string blueprints)
    {
        string[] rows = Goals.Keys.ToArray();
        string printed = ProbeBuild.Run("node", ProbeBuild.Root, new[] { Script, pack, program, blueprints, "/files", Milliseconds.ToString(CultureInfo.InvariantCulture) }.Concat(rows).ToArray());
        string[] lines = printed.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        return rows.Zip(lines[^rows.Length..]).ToDictionary(pair => pair.First, pair => Array.ConvertAll(pair.Second.Trim().Split(' '), word => double.Parse(word, CultureInfo.InvariantCulture)));
    }
}
