using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Batches;

/// <summary>
/// A manifest while its creatures are made: each line is on its way to the disk before the next creature is told of, so that whoever takes the work up again finds all that was done.
/// The file of the timings beside it is held as long as the work goes on: a second task with the same shard is refused.
/// </summary>
internal sealed class ManifestJournal : IDisposable
{
    private readonly string path;
    private readonly Batch batch;
    private readonly Shard shard;
    private readonly Surroundings surroundings;
    private readonly Stream times;
    private readonly List<string> lines = [];
    private Dictionary<Specimen, ManifestEntry> kept = [];
    private Stream? journal;
    private long creatures;
    private long missing;

    private ManifestJournal(string folder, Batch batch, Shard shard, Surroundings surroundings)
    {
        path = Path.Combine(folder, shard.FileName(Manifest.Stem));
        this.batch = batch;
        this.shard = shard;

        // What was made is told of even when the work is stopped.
        this.surroundings = surroundings with { Cancellation = default };
        times = Hold(Path.Combine(folder, shard.FileName(Manifest.TimesStem)));
    }

    private string Folder => Path.GetDirectoryName(path)!;

    /// <summary>Begins the manifest of a shard, or goes on with it.</summary>
    /// <param name="folder">Where the creatures are.</param>
    /// <param name="batch">Which creatures there are to be.</param>
    /// <param name="shard">Which of them are to be in this manifest.</param>
    /// <param name="existing">Whether what is listed already stays.</param>
    /// <param name="surroundings">Where files are.</param>
    /// <exception cref="UsageError">There is the manifest of another batch.</exception>
    /// <exception cref="WriteFailure">It cannot be written, or another task writes it.</exception>
    public static ManifestJournal Begin(string folder, Batch batch, Shard shard, Existing existing, Surroundings surroundings)
    {
        var journal = new ManifestJournal(folder, batch, shard, surroundings);
        try
        {
            journal.Begin(existing);
            return journal;
        }
        catch
        {
            journal.Dispose();
            throw;
        }
    }

    /// <summary>Which creatures a task that takes a shard up would keep; nothing is written or held.</summary>
    /// <exception cref="UsageError">There is the manifest of another batch.</exception>
    public static Func<Specimen, bool> Foresee(string folder, Batch batch, Shard shard, Existing existing, Surroundings surroundings)
    {
        Dictionary<Specimen, ManifestEntry> kept = ReadKept(Path.Combine(folder, shard.FileName(Manifest.Stem)), batch, existing, surroundings);
        return specimen => Keeps(kept, specimen, folder);
    }

    /// <summary>Whether a creature is listed and all its files are there as they are listed. Safe to call from several threads.</summary>
    public bool Keeps(Specimen specimen) => Keeps(kept, specimen, Folder);

    /// <summary>What came of the next creature.</summary>
    /// <exception cref="WriteFailure">It cannot be written.</exception>
    public void Add(GenerationResult result)
    {
        missing += result is MissingCreature ? 1 : 0;
        creatures += result is MissingCreature ? 0 : 1;
        if (result is KeptCreature there)
        {
            lines.Add(kept[there.Specimen].Line);
            return;
        }

        ManifestEntry entry = result is GeneratedCreature made ? ManifestEntry.Of(made, batch, Folder) : ManifestEntry.Of((MissingCreature)result, batch);
        if (kept.Count > 0)
        {
            lines.Add(entry.Line);
        }

        Append(journal!, path, entry.Line);
        if (result is GeneratedCreature timed)
        {
            Append(times, Path.Combine(Folder, shard.FileName(Manifest.TimesStem)), TimesOf(timed));
        }
    }

    /// <summary>All creatures are there. A manifest that was taken up again gets its lines in their order.</summary>
    /// <exception cref="WriteFailure">It cannot be written.</exception>
    public void Complete()
    {
        string closing = Manifest.Closing(creatures, missing);
        if (kept.Count == 0)
        {
            Append(journal!, path, closing);
        }

        journal!.Dispose();
        journal = null;
        if (kept.Count > 0)
        {
            Write(lines.Append(closing));
        }

        if (shard.Count == 1 && DatasetIndex.IsFor(batch))
        {
            DatasetIndex.Write(Folder, Manifest.Read(path, surroundings).Entries, surroundings);
        }
    }

    /// <summary>Closes the files.</summary>
    public void Dispose()
    {
        journal?.Dispose();
        times.Dispose();
    }

    private static Dictionary<Specimen, ManifestEntry> ReadKept(string path, Batch batch, Existing existing, Surroundings surroundings)
    {
        var kept = new Dictionary<Specimen, ManifestEntry>();
        if (File.Exists(path))
        {
            Manifest old = Manifest.Read(path, surroundings);
            if (batch.DifferenceFrom(old.Batch) is string difference)
            {
                throw new UsageError($"'{path}' is of another batch: {difference}; expected another --out, or that file removed");
            }

            if (existing == Existing.Resume)
            {
                // A line that was written twice counts as it was last.
                foreach (ManifestEntry entry in old.Entries.Where(entry => entry.IsThere))
                {
                    kept[entry.Specimen] = entry;
                }
            }
        }

        return kept;
    }

    private void Begin(Existing existing)
    {
        kept = ReadKept(path, batch, existing, surroundings);
        Write(kept.Values.Select(entry => entry.Line));
        journal = Open(path);
        if (kept.Count == 0)
        {
            times.SetLength(0);
        }
    }

    private static bool Keeps(Dictionary<Specimen, ManifestEntry> kept, Specimen specimen, string folder) => kept.TryGetValue(specimen, out ManifestEntry? entry) && entry.Files.All(file => file.ProblemIn(folder) == null);

    private void Write(IEnumerable<string> entries) => FileSet.Write(path, stream =>
    {
        using var writer = new StreamWriter(stream, new UTF8Encoding(false), 1 << 14, leaveOpen: true) { NewLine = "\n" };
        writer.WriteLine(batch.Header(shard));
        foreach (string line in entries)
        {
            writer.WriteLine(line);
        }
    }, surroundings);

    private Stream Open(string file)
    {
        try
        {
            return surroundings.Disk.Append(file);
        }
        catch (Exception problem) when (Reason.IsOfFiles(problem))
        {
            throw WriteFailure.At(file, Reason.Of(problem), problem);
        }
    }

    private Stream Hold(string file)
    {
        try
        {
            return surroundings.Disk.Hold(file);
        }
        catch (IOException problem) when (Reason.IsHeld(problem))
        {
            throw WriteFailure.At(file, $"another task is at work on shard {shard} of this folder; expected one task for each shard", problem);
        }
        catch (Exception problem) when (Reason.IsOfFiles(problem))
        {
            throw WriteFailure.At(file, Reason.Of(problem), problem);
        }
    }

    private static void Append(Stream stream, string file, string line)
    {
        try
        {
            stream.Write(Encoding.UTF8.GetBytes(line + "\n"));
            stream.Flush();
        }
        catch (Exception problem) when (Reason.IsOfFiles(problem))
        {
            throw WriteFailure.At(file, Reason.Of(problem), problem);
        }
    }

    private static string TimesOf(GeneratedCreature creature) => JsonText.Line(json =>
    {
        json.WriteStartObject();
        json.WriteString("creature", creature.Facts.Specimen.Name);
        json.WriteStartObject("milliseconds");
        foreach ((string stage, double milliseconds) in creature.Times.All)
        {
            json.WriteNumber(stage, Math.Round(milliseconds, 3));
        }

        json.WriteEndObject();
        json.WriteEndObject();
    });
}
