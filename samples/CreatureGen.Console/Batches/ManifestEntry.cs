using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text.Json;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Console.Batches;

/// <summary>A line of a manifest: a creature and its files, or why there is none. The names are a contract.</summary>
/// <param name="Specimen">Which creature.</param>
/// <param name="Files">Its files, by their paths from the manifest's folder; none if there is no creature.</param>
/// <param name="Line">The line, without its end.</param>
internal sealed record ManifestEntry(Specimen Specimen, IReadOnlyList<ListedFile> Files, string Line)
{
    /// <summary>Whether there is such a creature.</summary>
    public bool IsThere => Files.Count > 0;

    /// <summary>The line of what came of a seed.</summary>
    public static ManifestEntry Of(GeneratedCreature creature, Batch batch, string folder)
    {
        ListedFile[] files = creature.Files.Select(file => new ListedFile(Path.GetRelativePath(folder, file.Path).Replace('\\', '/'), file.Bytes, file.Sha256)).ToArray();
        return Of(creature.Facts.Specimen, batch, files, json =>
        {
            json.WriteStartArray("files");
            foreach (ListedFile file in files)
            {
                json.WriteStartObject();
                json.WriteString("path", file.Path);
                json.WriteNumber("bytes", file.Bytes);
                json.WriteString("sha256", file.Sha256);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            CreatureJson.WriteLooks(json, creature.Facts);
            json.WriteStartArray("clips");
            foreach (ClipFacts clip in creature.Clips)
            {
                json.WriteStartObject();
                json.WriteString("name", clip.Name);
                json.WriteNumber("seconds", clip.Seconds);
                json.WriteNumber("speed", clip.Speed);
                json.WriteString("end", WordList<ClipEnd>.Instance[clip.End]);
                json.WriteEndObject();
            }

            json.WriteEndArray();
        });
    }

    /// <summary>The line of a seed that gives no creature.</summary>
    public static ManifestEntry Of(MissingCreature creature, Batch batch) => Of(creature.Specimen, batch, [], json => json.WriteString("missing", creature.Reason));

    /// <summary>Reads a line that <see cref="Of(GeneratedCreature, Batch, string)"/> or <see cref="Of(MissingCreature, Batch)"/> gave.</summary>
    /// <exception cref="FormatException">It is none.</exception>
    public static ManifestEntry Read(string line)
    {
        try
        {
            using JsonDocument document = JsonDocument.Parse(line);
            JsonElement json = document.RootElement;
            var specimen = new Specimen(SeedIn(json.GetProperty("seed")), json.TryGetProperty("individual", out JsonElement individual) ? SeedIn(individual) : null);
            ListedFile[] files = json.TryGetProperty("missing", out _) ? []
                : json.GetProperty("files").EnumerateArray().Select(file => new ListedFile(PathIn(file), file.GetProperty("bytes").GetInt64(), file.GetProperty("sha256").GetString()!)).ToArray();
            return new ManifestEntry(specimen, files, line);
        }
        catch (Exception problem) when (problem is JsonException or KeyNotFoundException or InvalidOperationException)
        {
            throw new FormatException("expected a creature of a manifest", problem);
        }
    }

    private static ManifestEntry Of(Specimen specimen, Batch batch, IReadOnlyList<ListedFile> files, Action<Utf8JsonWriter> writeRest) => new(specimen, files, JsonText.Line(json =>
    {
        json.WriteStartObject();
        json.WriteString("seed", SeedText.Of(specimen.Seed));
        if (specimen.Individual is ulong individual)
        {
            json.WriteString("individual", SeedText.Of(individual));
        }

        batch.WriteVersions(json);
        writeRest(json);
        json.WriteEndObject();
    }));

    private static ulong SeedIn(JsonElement json) => SeedText.TryRead(json.GetString(), out ulong seed) ? seed : throw new FormatException($"'{json}' is no seed");

    /// <summary>A manifest names files in its own folder and those below, nowhere else.</summary>
    private static string PathIn(JsonElement file)
    {
        string path = file.GetProperty("path").GetString()!;
        return !Path.IsPathRooted(path) && !path.Split('/', '\\').Contains("..") ? path : throw new FormatException($"path '{path}'; expected one below the manifest's folder");
    }
}

/// <summary>A file as a manifest lists it.</summary>
/// <param name="Path">From the manifest's folder, with forward slashes.</param>
/// <param name="Bytes">Its size.</param>
/// <param name="Sha256">Of its content, 64 hexadecimal digits.</param>
internal sealed record ListedFile(string Path, long Bytes, string Sha256)
{
    /// <summary>What is wrong with the file in a folder; null if it is as listed.</summary>
    public string? ProblemIn(string folder)
    {
        var file = new FileInfo(System.IO.Path.Combine(folder, Path));
        if (!file.Exists)
        {
            return "is missing";
        }

        if (file.Length != Bytes)
        {
            return FormattableString.Invariant($"has {file.Length} bytes; expected {Bytes}");
        }

        using FileStream stream = file.OpenRead();
        return Convert.ToHexStringLower(SHA256.HashData(stream)) == Sha256 ? null : "has other content than the manifest says";
    }
}
