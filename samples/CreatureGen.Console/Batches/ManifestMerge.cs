using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Console.Arguments;

namespace CreatureGen.Console.Batches;

/// <summary>The manifests of all shards as that of one task, or what stands against it.</summary>
/// <param name="Batch">Which creatures there are to be.</param>
/// <param name="Entries">The creatures that are listed, in the order of their ordinals.</param>
/// <param name="Problems">Creatures and shards that are missing, creatures that are listed twice, and those that are listed differently.</param>
internal sealed record ManifestMerge(Batch Batch, IReadOnlyList<ManifestEntry> Entries, IReadOnlyList<string> Problems)
{
    /// <summary>Joins manifests.</summary>
    /// <param name="manifests">At least one.</param>
    /// <exception cref="UsageError">They are of different batches, or of different numbers of shards.</exception>
    public static ManifestMerge Of(IReadOnlyList<Manifest> manifests)
    {
        Manifest first = manifests[0];
        foreach (Manifest manifest in manifests.Skip(1))
        {
            if (manifest.Batch.DifferenceFrom(first.Batch) is string difference)
            {
                throw new UsageError($"'{manifest.Path}' and '{first.Path}' are of different batches: {difference}");
            }

            if (manifest.Shard.Count != first.Shard.Count)
            {
                throw new UsageError(FormattableString.Invariant($"'{manifest.Path}' is of {manifest.Shard.Count} shards, '{first.Path}' of {first.Shard.Count}; expected those of one batch"));
            }
        }

        var problems = new List<string>();
        var shards = manifests.ToDictionary(manifest => manifest.Shard.Index);
        for (int i = 0; i < first.Shard.Count; i++)
        {
            if (!shards.TryGetValue(i, out Manifest? shard))
            {
                problems.Add($"shard {new Shard(i, first.Shard.Count)} is missing");
            }
            else if (!shard.IsComplete)
            {
                problems.Add($"shard {shard.Shard} is not complete: --resume makes the rest");
            }
        }

        Dictionary<Specimen, ManifestEntry> listed = Collect(manifests, problems);
        var entries = new List<ManifestEntry>();
        int ordinal = 0;
        foreach (Specimen specimen in first.Batch.Specimens)
        {
            int place = ordinal;
            ordinal = ordinal + 1 == first.Shard.Count ? 0 : ordinal + 1;
            if (listed.Remove(specimen, out ManifestEntry? entry))
            {
                entries.Add(entry);
            }
            else if (shards.TryGetValue(place, out Manifest? shard) && shard.IsComplete)
            {
                problems.Add($"creature {specimen.Name} is missing in shard {shard.Shard}");
            }
        }

        problems.AddRange(listed.Keys.Select(specimen => $"creature {specimen.Name} does not belong to the batch"));
        return new ManifestMerge(first.Batch, entries, problems);
    }

    /// <summary>All lines of the manifest of one task.</summary>
    public IEnumerable<string> Lines()
    {
        long there = Entries.Count(entry => entry.IsThere);
        return Entries.Select(entry => entry.Line).Prepend(Batch.Header(Shard.Whole)).Append(Manifest.Closing(there, Entries.Count - there));
    }

    private static Dictionary<Specimen, ManifestEntry> Collect(IReadOnlyList<Manifest> manifests, List<string> problems)
    {
        var listed = new Dictionary<Specimen, ManifestEntry>();
        foreach (Manifest manifest in manifests)
        {
            foreach (ManifestEntry entry in manifest.Entries)
            {
                if (!listed.TryAdd(entry.Specimen, entry))
                {
                    string how = listed[entry.Specimen].Line == entry.Line ? "is listed twice" : "is listed twice, differently";
                    problems.Add($"creature {entry.Specimen.Name} {how}, at last in shard {manifest.Shard}");
                }
            }
        }

        return listed;
    }
}
