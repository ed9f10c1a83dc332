using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace CreatureGen.Json;

/// <summary>The way from the root of a document to a value, written like <c>legs[2].girth</c>. The root's is empty.</summary>
internal sealed class JsonPath
{
    private readonly JsonPath? parent;
    private readonly string? name;
    private readonly int index;

    private JsonPath(JsonPath? parent, string? name, int index)
    {
        this.parent = parent;
        this.name = name;
        this.index = index;
    }

    /// <summary>The path of the root.</summary>
    public static JsonPath Root { get; } = new(null, null, 0);

    /// <summary>The path of a member of the object at this path.</summary>
    public JsonPath Member(string member) => new(this, member, 0);

    /// <summary>The path of an element of the array at this path.</summary>
    public JsonPath Element(int element) => new(this, null, element);

    /// <inheritdoc/>
    public override string ToString()
    {
        var steps = new List<JsonPath>();
        for (JsonPath step = this; step.parent != null; step = step.parent)
        {
            steps.Add(step);
        }

        var text = new StringBuilder();
        for (int i = steps.Count - 1; i >= 0; i--)
        {
            steps[i].AppendTo(text);
        }

        return text.ToString();
    }

    private static bool IsPlain(string name)
    {
        foreach (char c in name)
        {
            if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-'))
            {
                return false;
            }
        }

        return name.Length > 0 && name.Length <= Excerpt.MaximumLength;
    }

    private void AppendTo(StringBuilder text)
    {
        if (name is null)
        {
            text.Append('[').Append(index.ToString(CultureInfo.InvariantCulture)).Append(']');
        }
        else if (IsPlain(name))
        {
            text.Append(text.Length > 0 ? "." : "").Append(name);
        }
        else
        {
            text.Append('[').Append(Excerpt.Quoted(name)).Append(']');
        }
    }
}
