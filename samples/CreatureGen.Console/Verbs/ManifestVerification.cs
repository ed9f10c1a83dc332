using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Batches;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Verbs;

/// <summary>The verb <c>verify</c> for the files of a batch.</summary>
internal static class ManifestVerification
{
    private static readonly OptionSyntax manifest = new("--manifest", "FILE", "the files that this manifest lists (or the one in a folder), by their SHA-256");
    private static readonly OptionSyntax grow = new("--grow", null, "with --manifest: make the creatures anew, too, and compare");

    /// <summary>Its options.</summary>
    public static OptionSyntax[] Syntax { get; } = [manifest, grow];

    /// <summary>Whether it is meant.</summary>
    /// <exception cref="UsageError">Half of it is.</exception>
    public static bool IsAskedFor(ParsedArguments arguments) =>
        arguments.Has(manifest.Name) || (arguments.Has(grow.Name) ? throw arguments.Wrong($"{grow.Name} without {manifest}; expected both") : false);

    /// <summary>Does it.</summary>
    public static int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        string[] allowed = [manifest.Name, grow.Name, CommonOptions.Threads.Name, CommonOptions.Json.Name];
        if (arguments.Names.FirstOrDefault(name => !allowed.Contains(name)) is string other)
        {
            throw arguments.Wrong($"{manifest.Name} and {other}; expected one of them: a manifest says itself which creatures it lists");
        }

        string path = surroundings.Locate(arguments.Required(manifest.Name));
        Manifest read = Manifest.Read(Directory.Exists(path) ? Path.Combine(path, Shard.Whole.FileName(Manifest.Stem)) : path, surroundings);
        ManifestCheck check = arguments.Has(grow.Name) ? ManifestCheck.ByGrowing(read) : ManifestCheck.ByHash(read);
        var problems = new List<string>();
        using (var progress = new ProgressLine(surroundings, "creatures checked", (UInt128)read.Entries.Count, ProgressKind.Shown))
        {
            OrderedWork<ManifestEntry, IReadOnlyList<string>>.Run(read.Entries, CommonOptions.ReadThreads(arguments), entry => check.ProblemsOf(entry, surroundings.Abandonment), found =>
            {
                problems.AddRange(found);
                progress.Step();
            }, surroundings.Cancellation);
        }

        problems.AddRange(check.Gaps());
        if (arguments.Has(CommonOptions.Json.Name))
        {
            Write(surroundings.Out, read, problems);
        }
        else
        {
            problems.ForEach(surroundings.Out.WriteLine);
            surroundings.Out.WriteLine($"{Units.Count(read.Entries.Count)} creatures listed, {Units.Count(problems.Count)} {(problems.Count == 1 ? "problem" : "problems")}");
        }

        return problems.Count == 0 ? ExitCode.Done : ExitCode.CheckFailed;
    }

    private static void Write(TextWriter output, Manifest manifest, IReadOnlyList<string> problems) => output.Write(JsonText.Document(json =>
    {
        json.WriteStartObject();
        json.WriteNumber("creatures", manifest.Entries.Count);
        json.WriteBoolean("complete", manifest.IsComplete);
        json.WriteStartArray("problems");
        foreach (string problem in problems)
        {
            json.WriteStringValue(problem);
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }));
}
