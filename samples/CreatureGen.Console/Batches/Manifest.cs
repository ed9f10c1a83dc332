using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using System.Text.Json;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;

namespace CreatureGen.Console.Batches;

/// <summary>What a manifest says: JSON, a line for the batch, one for each creature, and one at the end when all are there.</summary>
/// <param name="Path">Where it is.</param>
/// <param name="Batch">Which creatures there are to be.</param>
/// <param name="Shard">Which of them are to be in this manifest.</param>
/// <param name="Entries">Those that are, in the order of the lines.</param>
/// <param name="IsComplete">Whether it has its last line.</param>
internal sealed record Manifest(string Path, Batch Batch, Shard Shard, IReadOnlyList<ManifestEntry> Entries, bool IsComplete)
{
    /// <summary>What manifests are called.</summary>
    public const string Stem = "manifest";

    /// <summary>What files of timings are called.</summary>
    public const string TimesStem = "times";

    /// <summary>The folder that its paths start from.</summary>
    public string Folder => System.IO.Path.GetDirectoryName(Path)!;

    /// <summary>The last line of a manifest.</summary>
    /// <param name="creatures">How many are listed.</param>
    /// <param name="missing">How many seeds gave none.</param>
    public static string Closing(long creatures, long missing) => JsonText.Line(json =>
    {
        json.WriteStartObject();
        json.WriteBoolean("complete", true);
        json.WriteNumber("creatures", creatures);
        json.WriteNumber("missing", missing);
        json.WriteEndObject();
    });

    /// <summary>Reads a manifest. A last line without an end is what a killed process left of one; it counts as not there.</summary>
    /// <exception cref="UsageError">It is none, or cannot be read.</exception>
    public static Manifest Read(string path, Surroundings surroundings)
    {
        string text;
        using (Stream stream = SourceFile.Open(path, "a manifest written by creaturegen", surroundings))
        {
            using var reader = new StreamReader(stream, Encoding.UTF8);
            text = reader.ReadToEnd();
        }

        string[] lines = text.Split('\n');
        int count = lines.Length - 1;
        int number = 1;
        try
        {
            (Batch batch, Shard shard) = Batch.ReadHeader(lines[0]);
            var entries = new List<ManifestEntry>(count);
            bool complete = count > 1 && IsClosing(lines[count - 1]);
            for (int i = 1; i < count - (complete ? 1 : 0); i++)
            {
                number = i + 1;
                entries.Add(ManifestEntry.Read(lines[i]));
            }

            return new Manifest(path, batch, shard, entries, complete);
        }
        catch (FormatException problem)
        {
            throw new UsageError(FormattableString.Invariant($"'{path}', line {number}: {problem.Message}"));
        }
    }

    private static bool IsClosing(string line)
    {
        try
        {
            using JsonDocument document = JsonDocument.Parse(line);
            return document.RootElement.ValueKind == JsonValueKind.Object && document.RootElement.TryGetProperty("complete", out _);
        }
        catch (JsonException)
        {
            return false;
        }
    }
}
