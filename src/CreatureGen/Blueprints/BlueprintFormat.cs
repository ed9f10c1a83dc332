using System;
using System.Collections.Generic;
using CreatureGen.Json;

namespace CreatureGen.Blueprints;

/// <summary>
/// The formats that blueprints were ever written in, and the way from each to the next. A format is raised when text gets other fields; what the numbers build is told
/// apart by <see cref="CreatureBlueprint.CurrentAlgorithm"/>.
/// </summary>
/// <remarks>
/// A field that only has to be there gets <c>Since(n)</c> in its description and the value of the neutral record where text is older. A step is for what a
/// description cannot say: fields that are renamed, moved, or whose value follows from others. What a step supplies has no <c>Since</c>.
/// </remarks>
internal static class BlueprintFormat
{
    /// <summary>The name of the field that says in which format the rest is.</summary>
    public const string Field = "version";

    /// <summary>The oldest format.</summary>
    public const int First = 1;

    /// <summary>The format that is written.</summary>
    public const int Current = 2;

    /// <summary>All formats.</summary>
    public static WholeRange Range => new(First, Current);

    /// <summary>What is done with text of a format to make it text of the next one.</summary>
    private static readonly (int From, Func<JsonValue, JsonValue> Step)[] steps =
    {
        (1, NameAlgorithm),
    };

    /// <summary>Text of an older format as the current one would have it, but for fields that are younger than it.</summary>
    public static JsonValue Migrate(JsonValue source, int format)
    {
        foreach ((int from, Func<JsonValue, JsonValue> step) in steps)
        {
            source = from >= format ? step(source) : source;
        }

        return source;
    }

    /// <summary>In format 1 one number was both that of the format and that of the algorithm.</summary>
    private static JsonValue NameAlgorithm(JsonValue source) =>
        source.TryGet(Field, out JsonValue? version) ? source.With(CreatureFields.Algorithm, version!) : source;
}
