using System;
using System.IO;
using System.Linq;
using System.Text;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Batches;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;

namespace CreatureGen.Console.Verbs;

/// <summary>Joins the manifests of the shards of a batch.</summary>
internal sealed class MergeVerb : IVerb
{
    private const int MaxTold = 20;

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "merge",
        "FOLDER",
        "join the manifests of all shards in a folder to manifest.jsonl, and tell what is missing, doubled or different; of a data set, write index.jsonl",
        [
            new("merge farm", "the manifest of all, as one task would have written it"),
            new("merge farm --out all.jsonl", "elsewhere"),
        ],
        [CommonOptions.OutFile with { Meaning = "the file to write (default: manifest.jsonl in the folder)" }, CommonOptions.Quiet]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        string folder = surroundings.Locate(arguments.Operand);
        if (!Directory.Exists(folder))
        {
            throw new UsageError($"cannot read '{folder}': there is no such folder; expected one with the manifests of shards");
        }

        string[] paths = Directory.GetFiles(folder, Manifest.Stem + "-*-of-*.jsonl").Order(StringComparer.Ordinal).ToArray();
        if (paths.Length == 0)
        {
            throw new UsageError($"no manifests of shards in '{folder}'; expected {Manifest.Stem}-0-of-N.jsonl and so on");
        }

        ManifestMerge merge = ManifestMerge.Of(paths.Select(path => Manifest.Read(path, surroundings)).ToArray());
        if (merge.Problems.Count > 0)
        {
            string more = merge.Problems.Count > MaxTold ? $" (the first {MaxTold})" : "";
            Complaint.Tell(surroundings, [$"'{folder}' cannot be merged, {Units.Count(merge.Problems.Count)} {(merge.Problems.Count == 1 ? "problem" : "problems")}{more}:", .. merge.Problems.Take(MaxTold)]);
            return ExitCode.CheckFailed;
        }

        string target = arguments.Value(CommonOptions.OutFile.Name) is string path ? surroundings.Locate(path) : Path.Combine(folder, Shard.Whole.FileName(Manifest.Stem));
        FileSet.Write(target, stream =>
        {
            using var writer = new StreamWriter(stream, new UTF8Encoding(false), leaveOpen: true) { NewLine = "\n" };
            foreach (string line in merge.Lines())
            {
                writer.WriteLine(line);
            }
        }, surroundings);
        if (DatasetIndex.IsFor(merge.Batch))
        {
            DatasetIndex.Write(folder, merge.Entries, surroundings);
        }

        surroundings.Telling(target).WriteLine($"{target}: {Units.Count(merge.Entries.Count)} creatures of {Units.Count(paths.Length)} shards");
        return ExitCode.Done;
    }
}
