namespace CreatureGen.Json;

/// <summary>Writes values that were read.</summary>
internal static class JsonCopy
{
    /// <summary>Writes a value with all that is in it as the writer's next value.</summary>
    public static void Write(JsonWriter json, JsonValue value)
    {
        switch (value.Kind)
        {
            case JsonKind.Object:
                json.BeginObject();
                foreach (JsonMember member in value.Members)
                {
                    json.Name(member.Name);
                    Write(json, member.Value);
                }

                json.EndObject();
                break;
            case JsonKind.Array:
                json.BeginArray();
                foreach (JsonValue item in value.Items)
                {
                    Write(json, item);
                }

                json.EndArray();
                break;
            case JsonKind.Text:
                json.Text(value.Text);
                break;
            case JsonKind.Number:
                json.Number(value.Number);
                break;
            case JsonKind.Boolean:
                json.Boolean(value.IsTrue);
                break;
            default:
                json.Null();
                break;
        }
    }
}
