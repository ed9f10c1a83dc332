using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Threading;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Batches;

/// <summary>Checks the files of a manifest.</summary>
internal sealed class ManifestCheck
{
    private readonly Manifest manifest;
    private readonly CreatureTask? task;

    private ManifestCheck(Manifest manifest, CreatureTask? task) => (this.manifest, this.task) = (manifest, task);

    /// <summary>Holds the files against what the manifest says of them.</summary>
    public static ManifestCheck ByHash(Manifest manifest) => new(manifest, null);

    /// <summary>Makes the creatures anew, too, and holds what comes of them against what the manifest says.</summary>
    /// <exception cref="UsageError">The manifest is of another version.</exception>
    public static ManifestCheck ByGrowing(Manifest manifest)
    {
        CreatureTask task;
        try
        {
            using JsonDocument document = JsonDocument.Parse(manifest.Batch.Task);
            task = TaskJson.Read(document.RootElement);
        }
        catch (Exception problem) when (problem is FormatException or KeyNotFoundException or InvalidOperationException)
        {
            throw new UsageError($"'{manifest.Path}', line 1: {problem.Message}");
        }

        return Batch.Of(manifest.Batch.Specimens, task).DifferenceFrom(manifest.Batch) is string difference
            ? throw new UsageError($"'{manifest.Path}' cannot be grown by this version: {difference}")
            : new ManifestCheck(manifest, task);
    }

    /// <summary>What is wrong with the files of a creature; nothing if all is well.</summary>
    /// <param name="entry">The creature.</param>
    /// <param name="cancellation">Gives a creature up that is made anew.</param>
    /// <exception cref="OperationCanceledException">It was given up.</exception>
    public IReadOnlyList<string> ProblemsOf(ManifestEntry entry, CancellationToken cancellation)
    {
        var problems = new List<string>();
        foreach (ListedFile file in entry.Files)
        {
            if (file.ProblemIn(manifest.Folder) is string problem)
            {
                problems.Add($"{file.Path} {problem}");
            }
        }

        if (task != null && entry.IsThere)
        {
            problems.AddRange(Regrown(entry, cancellation));
        }

        return problems;
    }

    /// <summary>What the manifest lacks of its shard's creatures.</summary>
    public IReadOnlyList<string> Gaps()
    {
        var listed = manifest.Entries.Select(entry => entry.Specimen).ToHashSet();
        return manifest.Shard.Of(manifest.Batch.Specimens).Where(specimen => !listed.Contains(specimen)).Select(specimen => $"creature {specimen.Name} is not listed").ToArray();
    }

    private IEnumerable<string> Regrown(ManifestEntry entry, CancellationToken cancellation)
    {
        IReadOnlyList<(string Form, byte[] Content)> contents = task!.Make(entry.Specimen, 1, cancellation).Contents;
        foreach ((string form, byte[] content) in contents)
        {
            CreatureFile grown = CreatureFile.Of(form, CreatureFiles.PathOf("", entry.Specimen.Name, form), content);
            ListedFile? listed = entry.Files.FirstOrDefault(file => file.Path == grown.Path.Replace(Path.DirectorySeparatorChar, '/'));
            if (listed is null)
            {
                yield return $"{grown.Path} is not listed";
            }
            else if (listed.Sha256 != grown.Sha256)
            {
                yield return $"{grown.Path} grows with other content than the manifest says";
            }
        }
    }
}
