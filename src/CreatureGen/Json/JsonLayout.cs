namespace CreatureGen.Json;

/// <summary>How JSON text is set out.</summary>
internal enum JsonLayout
{
    /// <summary>No white space at all.</summary>
    Compact,

    /// <summary>All on one line, with spaces for the eye.</summary>
    Line,

    /// <summary>A line for each member and element, indented by two spaces, lines ended by a line feed.</summary>
    Indented,
}
