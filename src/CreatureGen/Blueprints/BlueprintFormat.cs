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
    public const int Current = 6;

    /// <summary>All formats.</summary>
    public static WholeRange Range => new(First, Current);

    /// <summary>What is done with text of a format to make it text of the next one.</summary>
    private static readonly (int From, Func<JsonValue, JsonValue> Step)[] steps =
    {
        (1, NameAlgorithm),
        (2, ListBodies),
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

    /// <summary>In format 2 a mix had three bodies by name and two weights for all of the body, and the first of them gave face, skin and manner.</summary>
    private static JsonValue ListBodies(JsonValue source)
    {
        if (!source.TryGet("body", out JsonValue? body) || !body!.TryGet("blend", out JsonValue? blend) || blend!.Kind != JsonKind.Object)
        {
            return source;
        }

        foreach (string field in new[] { "first", "second", "third", "secondWeight", "thirdWeight" })
        {
            if (!blend.TryGet(field, out _))
            {
                return source;
            }
        }

        JsonValue first = blend["first"];
        JsonValue all = blend.Numeral("1", 1);
        JsonValue bodies = blend.Array(
            Part(blend, first, all),
            Part(blend, blend["second"], blend["secondWeight"]),
            Part(blend, blend["third"], blend["thirdWeight"]));
        JsonValue mix = blend.Object(("bodies", bodies), ("face", first), ("skin", first), ("manner", first));
        return source.With("body", body.With("blend", mix));
    }

    private static JsonValue Part(JsonValue blend, JsonValue name, JsonValue weight) => blend.Object(("name", name), ("torso", weight), ("head", weight), ("tail", weight));
}
