using System;
using System.IO;
using CreatureGen.Json;

namespace CreatureGen.Blueprints;

/// <summary>
/// Blueprints as JSON text. The same blueprint gives the same bytes everywhere, a blueprint that was read gives its text again when the text was written by this
/// library, and what is read equals what was written.
/// </summary>
/// <remarks>
/// Objects and names are those of the records, in camel case; enumerations are written by name, the seed is a string of digits, all numbers are as short as they
/// can be read back exactly. Reading is strict: a field that is missing, unknown, of the wrong type or out of range is reported, never guessed or clamped.
/// </remarks>
public static class BlueprintJson
{
    /// <summary>Longer text is not read, bytes of UTF-8. A blueprint has some ten thousand.</summary>
    public const int MaximumBytes = 4 << 20;

    /// <summary>The format of the text that is written; text of this and of all older formats is read.</summary>
    public const int FormatVersion = BlueprintFormat.Current;

    private const string What = "blueprint";

    private static JsonLimits Limits => new(MaximumBytes, 100_000);

    /// <summary>The text of a blueprint: indented, lines ended by line feeds.</summary>
    /// <exception cref="ArgumentNullException">The blueprint is null.</exception>
    /// <exception cref="ArgumentException">The blueprint holds what no text can: NaN, infinity, null or an undefined value. The message tells where.</exception>
    public static string Write(CreatureBlueprint blueprint) => RecordJson.DocumentOf(blueprint, CreatureFields.Creature, What);

    /// <summary>Writes the text of a blueprint to a stream, in UTF-8 without a byte order mark.</summary>
    /// <exception cref="ArgumentNullException">The blueprint or the stream is null.</exception>
    /// <exception cref="ArgumentException">The blueprint holds what no text can: NaN, infinity, null or an undefined value. The message tells where.</exception>
    public static void Write(CreatureBlueprint blueprint, Stream stream) =>
        RecordJson.WriteUtf8(stream ?? throw new ArgumentNullException(nameof(stream)), Write(blueprint));

    /// <summary>Reads a blueprint and validates it.</summary>
    /// <exception cref="ArgumentNullException">The text is null.</exception>
    public static BlueprintReading Read(string text) => Read(JsonReader.Read(text ?? throw new ArgumentNullException(nameof(text)), Limits));

    /// <summary>Reads a blueprint in UTF-8, from the stream's position to its end, and validates it.</summary>
    /// <exception cref="ArgumentNullException">The stream is null.</exception>
    public static BlueprintReading Read(Stream stream) =>
        Read(JsonReader.Read(RecordJson.Bytes(stream ?? throw new ArgumentNullException(nameof(stream)), MaximumBytes), Limits));

    /// <summary>Writes a blueprint as the writer's next value.</summary>
    /// <exception cref="ArgumentException">The blueprint holds what no text can.</exception>
    internal static void Write(JsonWriter writer, CreatureBlueprint blueprint) => RecordJson.Write(writer, blueprint, CreatureFields.Creature, What);

    /// <summary>Reads a blueprint that is part of a document and validates it.</summary>
    internal static BlueprintReading Read(JsonValue source)
    {
        var problems = new ProblemList(What);
        int format = FormatOf(source, problems);
        if (source.Kind != JsonKind.Object)
        {
            problems.Add(source.Position, source.Path, source.ToString(), FieldChecker.AnObject);
        }

        if (problems.All.Count > 0)
        {
            return new BlueprintReading(null, problems.All);
        }

        JsonValue migrated = BlueprintFormat.Migrate(source, format);
        CreatureBlueprint blueprint = FieldReader.Read(migrated, CreatureFields.Creature, format, MissingField.Reported, problems);
        if (problems.All.Count == 0)
        {
            BlueprintRules.Check(blueprint, problems);
        }

        return new BlueprintReading(blueprint, problems.All);
    }

    private static BlueprintReading Read(JsonReading reading)
    {
        var problems = new ProblemList(What);
        JsonValue? root = RecordJson.Parse(reading, problems);
        return root is null ? new BlueprintReading(null, problems.All) : Read(root);
    }

    /// <summary>The format that text says it has. Text of an unknown one may have any fields: it gets one problem, not one for each field.</summary>
    private static int FormatOf(JsonValue source, ProblemList problems)
    {
        if (!source.TryGet(BlueprintFormat.Field, out JsonValue? version) || version!.Kind != JsonKind.Number)
        {
            return BlueprintFormat.Current;
        }

        for (int format = BlueprintFormat.First; format <= BlueprintFormat.Current; format++)
        {
            if (version.Number == format)
            {
                return format;
            }
        }

        string reason = version.Number > BlueprintFormat.Current ? ", this text is for a newer version of the library" : "";
        problems.Add(version.Position, version.Path, version.ToString(), BlueprintFormat.Range + reason);
        return BlueprintFormat.Current;
    }
}
