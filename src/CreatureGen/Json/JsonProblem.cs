namespace CreatureGen.Json;

/// <summary>Why a text is not the JSON that was asked for.</summary>
internal sealed class JsonProblem
{
    public JsonProblem(string path, JsonPosition position, string found, string expectation)
    {
        Path = path;
        Position = position;
        Found = found;
        Expectation = expectation;
    }

    /// <summary>The way from the root to the value in which it is.</summary>
    public string Path { get; }

    /// <summary>Where it is.</summary>
    public JsonPosition Position { get; }

    /// <summary>What stands there.</summary>
    public string Found { get; }

    /// <summary>What should.</summary>
    public string Expectation { get; }

    /// <inheritdoc/>
    public override string ToString() => Position + ": " + (Path.Length > 0 ? Path + ": " : "") + Found + "; expected " + Expectation;
}
