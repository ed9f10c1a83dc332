using System;
using System.Collections.Generic;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Batches;

/// <summary>What all shards of a batch have in common: which creatures, made how, by which version.</summary>
/// <param name="Seeds">Their seeds.</param>
/// <param name="Individuals">The individuals of each; null for the types alone.</param>
/// <param name="Library">Version of the library.</param>
/// <param name="Algorithm">Version of its algorithm.</param>
/// <param name="Task">What is made of each, as <see cref="TaskJson"/> writes it.</param>
internal sealed record Batch(string Seeds, string? Individuals, string Library, int Algorithm, string Task)
{
    /// <summary>Version of the manifests that are written.</summary>
    private const int Format = 1;

    /// <summary>SHA-256 of what is made of each, 64 hexadecimal digits.</summary>
    public string TaskHash { get; } = Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(Task)));

    /// <summary>The creatures, in the order of their ordinals.</summary>
    public SpecimenList Specimens => new(SeedList.Read(Seeds), Individuals is null ? null : SeedList.Read(Individuals));

    /// <summary>A batch as this version makes it.</summary>
    public static Batch Of(SpecimenList specimens, CreatureTask task) =>
        new(specimens.Seeds.ToString(), specimens.Individuals?.ToString(), typeof(CreatureGenerator).Assembly.GetName().Version!.ToString(3), CreatureBlueprint.CurrentAlgorithm, JsonText.Line(json => TaskJson.Write(json, task)));

    /// <summary>The first line of a manifest.</summary>
    public string Header(Shard shard) => JsonText.Line(json =>
    {
        json.WriteStartObject();
        json.WriteNumber("manifest", Format);
        json.WriteString("shard", shard.ToString());
        json.WriteString("seeds", Seeds);
        if (Individuals != null)
        {
            json.WriteString("individuals", Individuals);
        }

        WriteVersions(json);
        json.WritePropertyName("task");
        json.WriteRawValue(Task);
        json.WriteEndObject();
    });

    /// <summary>Writes the versions, and the hash of what is made, as members of the object that is open.</summary>
    public void WriteVersions(Utf8JsonWriter json)
    {
        json.WriteString("library", Library);
        json.WriteNumber("algorithm", Algorithm);
        json.WriteString("taskSha256", TaskHash);
    }

    /// <summary>Reads what <see cref="Header"/> wrote.</summary>
    /// <exception cref="FormatException">It is none.</exception>
    public static (Batch Batch, Shard Shard) ReadHeader(string line)
    {
        try
        {
            using JsonDocument document = JsonDocument.Parse(line);
            JsonElement json = document.RootElement;
            if (json.GetProperty("manifest").GetInt32() != Format)
            {
                throw new FormatException(FormattableString.Invariant($"manifest = {json.GetProperty("manifest")}; expected {Format}"));
            }

            string? individuals = json.TryGetProperty("individuals", out JsonElement list) ? list.GetString() : null;
            var batch = new Batch(json.GetProperty("seeds").GetString()!, individuals, json.GetProperty("library").GetString()!, json.GetProperty("algorithm").GetInt32(), json.GetProperty("task").GetRawText());
            _ = batch.Specimens;
            return Shard.TryRead(json.GetProperty("shard").GetString()!, out Shard shard) ? (batch, shard) : throw new FormatException("shard: expected " + Shard.Expectation);
        }
        catch (Exception problem) when (problem is JsonException or KeyNotFoundException or InvalidOperationException)
        {
            throw new FormatException("expected the first line of a manifest", problem);
        }
    }

    /// <summary>What two batches do not have in common, in a few words; null if they are the same.</summary>
    public string? DifferenceFrom(Batch other)
    {
        (string Name, string Mine, string Theirs)[] all =
        [
            ("library", Library, other.Library),
            ("algorithm", FormattableString.Invariant($"{Algorithm}"), FormattableString.Invariant($"{other.Algorithm}")),
            ("seeds", Seeds, other.Seeds),
            ("individuals", Individuals ?? "none", other.Individuals ?? "none"),
        ];
        string[] told = all.Where(part => part.Mine != part.Theirs).Select(part => $"{part.Name} {part.Mine}, not {part.Theirs}").ToArray();
        return told.Length > 0 ? string.Join("; ", told) : Task == other.Task ? null : "other options of the creatures or their files";
    }
}
