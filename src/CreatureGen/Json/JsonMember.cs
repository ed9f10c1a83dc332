namespace CreatureGen.Json;

/// <summary>A named value of an object.</summary>
internal readonly struct JsonMember
{
    public JsonMember(string name, JsonValue value)
    {
        Name = name;
        Value = value;
    }

    /// <summary>Its name, not escaped.</summary>
    public string Name { get; }

    /// <summary>Its value.</summary>
    public JsonValue Value { get; }
}
