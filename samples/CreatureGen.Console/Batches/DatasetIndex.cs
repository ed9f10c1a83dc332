using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;

namespace CreatureGen.Console.Batches;

/// <summary>What a reader of a data set opens first: JSON, a line for each creature with its files by what is in them, those of views in the order of the views. The names are a contract.</summary>
internal static class DatasetIndex
{
    /// <summary>What it is called.</summary>
    public const string FileName = "index.jsonl";

    /// <summary>Whether creatures of a batch have what a data set has.</summary>
    public static bool IsFor(Batch batch)
    {
        using JsonDocument task = JsonDocument.Parse(batch.Task);
        return TaskJson.Read(task.RootElement).Dataset.Views > 0;
    }

    /// <summary>Writes it beside the manifest whose creatures it lists.</summary>
    /// <exception cref="WriteFailure">It cannot be written.</exception>
    public static void Write(string folder, IEnumerable<ManifestEntry> entries, Surroundings surroundings) => FileSet.Write(Path.Combine(folder, FileName), stream =>
    {
        using var writer = new StreamWriter(stream, new UTF8Encoding(false), leaveOpen: true) { NewLine = "\n" };
        foreach (ManifestEntry entry in entries.Where(entry => entry.IsThere))
        {
            writer.WriteLine(Line(entry));
        }
    }, surroundings);

    private static string Line(ManifestEntry entry) => JsonText.Line(json =>
    {
        using JsonDocument listed = JsonDocument.Parse(entry.Line);
        json.WriteStartObject();
        json.WriteString("creature", entry.Specimen.Name);
        foreach (string name in new[] { "seed", "individual", "kind", "plan", "joints", "vertices", "triangles" })
        {
            if (listed.RootElement.TryGetProperty(name, out JsonElement value))
            {
                json.WritePropertyName(name);
                value.WriteTo(json);
            }
        }

        // creature-7.glb is the "glb", creature-7-depth-1.npy the second "depth", creature-7-poses.npy the "poses".
        int stem = $"creature-{entry.Specimen.Name}.".Length;
        foreach (IGrouping<string, string> files in entry.Files.Select(file => file.Path).GroupBy(path => path[stem..].Split('-', '.')[0]))
        {
            bool ofViews = files.First()[stem..].Contains('-', StringComparison.Ordinal);
            json.WritePropertyName(files.Key);
            if (ofViews)
            {
                json.WriteStartArray();
            }

            foreach (string path in files)
            {
                json.WriteStringValue(path);
            }

            if (ofViews)
            {
                json.WriteEndArray();
            }
        }

        json.WriteEndObject();
    });
}
