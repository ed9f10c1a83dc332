using System.Collections.Generic;

namespace CreatureGen.Json;

/// <summary>What came of reading a text.</summary>
internal sealed class JsonReading
{
    public JsonReading(JsonValue? root, IReadOnlyList<JsonProblem> problems)
    {
        Root = root;
        Problems = problems;
    }

    /// <summary>The document; null when the text is not JSON.</summary>
    public JsonValue? Root { get; }

    /// <summary>What is wrong: at most one error of syntax, which ends the reading, and every name that an object has twice. Empty for good text.</summary>
    public IReadOnlyList<JsonProblem> Problems { get; }
}
