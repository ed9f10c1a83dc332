using System;
using System.IO;
using CreatureGen.Blueprints;
using CreatureGen.Json;

namespace CreatureGen.Sampling;

/// <summary>
/// Options as JSON text. The same options give the same bytes everywhere, and what is read equals what was written.
/// </summary>
/// <remarks>Text needs to name only what it asks for: a field that is missing has its default. All else is strict; unknown fields are reported.</remarks>
public static class OptionsJson
{
    /// <summary>Longer text is not read, bytes of UTF-8.</summary>
    public const int MaximumBytes = 1 << 20;

    internal const string What = "options";

    private static JsonLimits Limits => new(MaximumBytes, 10_000);

    /// <summary>The text of options: indented, lines ended by line feeds.</summary>
    /// <exception cref="ArgumentNullException">The options are null.</exception>
    /// <exception cref="ArgumentException">The options hold what no text can: NaN, infinity, null or an undefined value. The message tells where.</exception>
    public static string Write(CreatureOptions options) => RecordJson.DocumentOf(options, OptionsFields.Options, What);

    /// <summary>Writes the text of options to a stream, in UTF-8 without a byte order mark.</summary>
    /// <exception cref="ArgumentNullException">The options or the stream are null.</exception>
    /// <exception cref="ArgumentException">The options hold what no text can: NaN, infinity, null or an undefined value. The message tells where.</exception>
    public static void Write(CreatureOptions options, Stream stream) =>
        RecordJson.WriteUtf8(stream ?? throw new ArgumentNullException(nameof(stream)), Write(options));

    /// <summary>Reads options and validates them.</summary>
    /// <exception cref="ArgumentNullException">The text is null.</exception>
    public static OptionsReading Read(string text) => Read(JsonReader.Read(text ?? throw new ArgumentNullException(nameof(text)), Limits));

    /// <summary>Reads options in UTF-8, from the stream's position to its end, and validates them.</summary>
    /// <exception cref="ArgumentNullException">The stream is null.</exception>
    public static OptionsReading Read(Stream stream) =>
        Read(JsonReader.Read(RecordJson.Bytes(stream ?? throw new ArgumentNullException(nameof(stream)), MaximumBytes), Limits));

    /// <summary>Writes options as the writer's next value.</summary>
    /// <exception cref="ArgumentException">The options hold what no text can.</exception>
    internal static void Write(JsonWriter writer, CreatureOptions options) => RecordJson.Write(writer, options, OptionsFields.Options, What);

    /// <summary>Reads options that are part of a document and validates them.</summary>
    internal static OptionsReading Read(JsonValue source)
    {
        var problems = new ProblemList(What);
        CreatureOptions options = FieldReader.Read(source, OptionsFields.Options, BlueprintFormat.Current, MissingField.Neutral, problems);
        if (problems.All.Count == 0)
        {
            OptionsRules.Check(options, problems);
        }

        return new OptionsReading(options, problems.All);
    }

    private static OptionsReading Read(JsonReading reading)
    {
        var problems = new ProblemList(What);
        JsonValue? root = RecordJson.Parse(reading, problems);
        return root is null ? new OptionsReading(null, problems.All) : Read(root);
    }
}
