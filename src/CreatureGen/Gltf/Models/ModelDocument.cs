using System.Collections.Generic;
using CreatureGen.Json;

namespace CreatureGen.Gltf.Models;

/// <summary>The two chunks of a GLB file, and strict ways to look into its JSON. Every way ends at the value or at a <see cref="ModelFault"/>.</summary>
internal sealed class ModelDocument
{
    private static readonly IReadOnlyList<JsonValue> none = System.Array.Empty<JsonValue>();

    public ModelDocument(JsonValue root, byte[] binary)
    {
        Root = root;
        Binary = binary;
    }

    /// <summary>The JSON.</summary>
    public JsonValue Root { get; }

    /// <summary>The bytes of buffer 0.</summary>
    public byte[] Binary { get; }

    /// <summary>The elements of a top-level array; none if it is not there.</summary>
    public IReadOnlyList<JsonValue> All(string name) => ItemsOf(Root, name);

    /// <summary>One element of a top-level array, named by a number of the document.</summary>
    public JsonValue At(string name, JsonValue index)
    {
        IReadOnlyList<JsonValue> all = All(name);
        int i = Whole(index, int.MaxValue);
        return i < all.Count ? all[i] : throw ModelFault.At(index, "one of the " + ModelFault.Text(all.Count) + " " + name);
    }

    /// <summary>A member that has to be there.</summary>
    public static JsonValue Need(JsonValue parent, string name, string expectation) =>
        parent.Kind == JsonKind.Object && parent.TryGet(name, out JsonValue? value) ? value! : throw ModelFault.Missing(parent, name, expectation);

    /// <summary>A member, null if it is not there.</summary>
    public static JsonValue? Find(JsonValue parent, string name) => parent.Kind == JsonKind.Object && parent.TryGet(name, out JsonValue? value) ? value : null;

    /// <summary>The elements of an array member; none if it is not there.</summary>
    public static IReadOnlyList<JsonValue> ItemsOf(JsonValue parent, string name)
    {
        JsonValue? value = Find(parent, name);
        return value is null ? none : value.Kind == JsonKind.Array ? value.Items : throw ModelFault.At(value, "an array");
    }

    /// <summary>A whole number from 0 to a bound.</summary>
    public static int Whole(JsonValue value, int max)
    {
        double number = value.Number;
        return value.Kind == JsonKind.Number && number >= 0 && number <= max && number == System.Math.Floor(number)
            ? (int)number
            : throw ModelFault.At(value, "a whole number of 0 to " + ModelFault.Text(max));
    }

    /// <summary>A whole number that may be missing.</summary>
    public static int Whole(JsonValue parent, string name, int fallback) => Find(parent, name) is { } value ? Whole(value, int.MaxValue) : fallback;

    /// <summary>The text of a member, or a fallback.</summary>
    public static string Text(JsonValue parent, string name, string fallback) =>
        Find(parent, name) is { } value ? value.Kind == JsonKind.Text ? value.Text : throw ModelFault.At(value, "text") : fallback;

    /// <summary>Numbers of an array member of a given length; false if it is not there.</summary>
    public static bool TryNumbers(JsonValue parent, string name, System.Span<float> numbers)
    {
        if (Find(parent, name) is not { } value)
        {
            return false;
        }

        if (value.Kind != JsonKind.Array || value.Items.Count != numbers.Length)
        {
            throw ModelFault.At(value, ModelFault.Text(numbers.Length) + " numbers");
        }

        for (int i = 0; i < numbers.Length; i++)
        {
            JsonValue item = value.Items[i];
            numbers[i] = (float)item.Number;
            if (item.Kind != JsonKind.Number || !float.IsFinite(numbers[i]))
            {
                throw ModelFault.At(item, "a finite number");
            }
        }

        return true;
    }
}
