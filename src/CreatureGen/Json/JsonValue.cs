using System;
using System.Collections.Generic;

namespace CreatureGen.Json;

/// <summary>A value of a JSON document and its place in the text.</summary>
internal sealed class JsonValue
{
    private static readonly JsonValue[] noItems = System.Array.Empty<JsonValue>();
    private static readonly JsonMember[] noMembers = System.Array.Empty<JsonMember>();

    private readonly JsonPath path;
    private readonly IReadOnlyDictionary<string, JsonValue>? lookup;

    private JsonValue(
        JsonKind kind,
        JsonPath path,
        JsonPosition position,
        string text = "",
        double number = 0,
        IReadOnlyList<JsonValue>? items = null,
        IReadOnlyList<JsonMember>? members = null,
        IReadOnlyDictionary<string, JsonValue>? lookup = null)
    {
        Kind = kind;
        this.path = path;
        Position = position;
        Text = text;
        Number = number;
        Items = items ?? noItems;
        Members = members ?? noMembers;
        this.lookup = lookup;
    }

    /// <summary>What it is.</summary>
    public JsonKind Kind { get; }

    /// <summary>Where its text begins.</summary>
    public JsonPosition Position { get; }

    /// <summary>The way to it from the root.</summary>
    public string Path => path.ToString();

    /// <summary>The characters of a string; the text of a number, of null, true or false as it stands in the document; empty for arrays and objects.</summary>
    public string Text { get; }

    /// <summary>The double nearest to a number, infinite when the number is beyond the range of a double; 0 for other kinds.</summary>
    public double Number { get; }

    /// <summary>Whether it is true.</summary>
    public bool IsTrue => Kind == JsonKind.Boolean && Text == "true";

    /// <summary>The elements of an array; none for other kinds.</summary>
    public IReadOnlyList<JsonValue> Items { get; }

    /// <summary>The members of an object in the order of the text; none for other kinds. A name that is there twice is in the list once, with its first value.</summary>
    public IReadOnlyList<JsonMember> Members { get; }

    /// <summary>The element of an array.</summary>
    /// <exception cref="InvalidOperationException">There is no such element.</exception>
    public JsonValue this[int index] => index >= 0 && index < Items.Count
        ? Items[index]
        : throw new InvalidOperationException("no element " + path.Element(index) + "; expected an array of more than " + index + " elements");

    /// <summary>The member of an object.</summary>
    /// <exception cref="InvalidOperationException">There is no such member.</exception>
    public JsonValue this[string name] => TryGet(name, out JsonValue? value)
        ? value!
        : throw new InvalidOperationException("no member " + path.Member(name) + "; expected an object that has it");

    /// <summary>The member of an object, if there is one of that name.</summary>
    public bool TryGet(string name, out JsonValue? value)
    {
        if (lookup != null)
        {
            return lookup.TryGetValue(name, out value);
        }

        foreach (JsonMember member in Members)
        {
            if (string.Equals(member.Name, name, StringComparison.Ordinal))
            {
                value = member.Value;
                return true;
            }
        }

        value = null;
        return false;
    }

    /// <summary>This object with one more member, which keeps the place it has in the text; one of the same name is replaced.</summary>
    public JsonValue With(string name, JsonValue value)
    {
        var others = new List<JsonMember>();
        foreach (JsonMember member in Members)
        {
            if (!string.Equals(member.Name, name, StringComparison.Ordinal))
            {
                others.Add(member);
            }
        }

        others.Add(new JsonMember(name, value));
        return new JsonValue(JsonKind.Object, path, Position, members: others);
    }

    /// <summary>An object in the place of this value.</summary>
    public JsonValue Object(params (string Name, JsonValue Value)[] members) =>
        new(JsonKind.Object, path, Position, members: System.Array.ConvertAll(members, member => new JsonMember(member.Name, member.Value)));

    /// <summary>An array in the place of this value.</summary>
    public JsonValue Array(params JsonValue[] items) => new(JsonKind.Array, path, Position, items: items);

    /// <summary>A number in the place of this value.</summary>
    public JsonValue Numeral(string text, double number) => new(JsonKind.Number, path, Position, text, number);

    /// <summary>The value in a few words for a message: a scalar's text, or what kind of container it is.</summary>
    public override string ToString() => Kind switch
    {
        JsonKind.Text => Excerpt.Quoted(Text),
        JsonKind.Array => "an array",
        JsonKind.Object => "an object",
        _ => Excerpt.Of(Text),
    };

    internal static JsonValue OfWord(JsonKind kind, string word, JsonPath path, JsonPosition position) => new(kind, path, position, word);

    internal static JsonValue OfNumber(string text, double number, JsonPath path, JsonPosition position) => new(JsonKind.Number, path, position, text, number);

    internal static JsonValue OfText(string text, JsonPath path, JsonPosition position) => new(JsonKind.Text, path, position, text);

    internal static JsonValue OfArray(IReadOnlyList<JsonValue> items, JsonPath path, JsonPosition position) => new(JsonKind.Array, path, position, items: items);

    internal static JsonValue OfObject(
        IReadOnlyList<JsonMember> members,
        IReadOnlyDictionary<string, JsonValue>? lookup,
        JsonPath path,
        JsonPosition position) => new(JsonKind.Object, path, position, members: members, lookup: lookup);
}
