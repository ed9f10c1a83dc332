using System;
using System.IO;
using CreatureGen.Blueprints;
using CreatureGen.Json;

namespace CreatureGen.Gltf;

/// <summary>Reads back what <see cref="GlbWriter"/> keeps in a file beside the creature's looks.</summary>
public static class GlbReader
{
    private static readonly string[] way = { "asset", "extras", DocumentWriter.ExtrasName, DocumentWriter.BlueprintName };

    /// <summary>Reads the blueprint of a creature from its GLB file and validates it. Whatever the bytes are, the answer is a blueprint or a report.</summary>
    /// <param name="source">A GLB file, read from the stream's position to the end of its JSON; need not be able to seek, is not closed.</param>
    /// <returns>The blueprint, or what is wrong: with the file, with its JSON, or with the blueprint in it, whose paths then begin at the root of the JSON. JSON of more than 64 MiB is not read.</returns>
    /// <exception cref="ArgumentNullException">The stream is null.</exception>
    /// <exception cref="ArgumentException">The stream cannot be read.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public static BlueprintReading ReadBlueprint(Stream source)
    {
        _ = source ?? throw new ArgumentNullException(nameof(source));
        if (!source.CanRead)
        {
            throw new ArgumentException("the stream cannot be read", nameof(source));
        }

        byte[]? text = GlbContainer.ReadJson(source, JsonLimits.Bulk.MaximumBytes, out Problem? problem);
        if (text is null)
        {
            return new BlueprintReading(null, new[] { problem! });
        }

        var problems = new ProblemList("JSON chunk");
        JsonValue? value = RecordJson.Parse(JsonReader.Read(text, JsonLimits.Bulk, way), problems);
        for (int i = 0; i < way.Length && value != null; i++)
        {
            if (!value.TryGet(way[i], out JsonValue? member))
            {
                problems.Add(value.Position, string.Join(".", way), "nothing", "a blueprint, which files written by CreatureGen have");
            }

            value = member;
        }

        return value is null ? new BlueprintReading(null, problems.All) : BlueprintJson.Read(value);
    }
}
