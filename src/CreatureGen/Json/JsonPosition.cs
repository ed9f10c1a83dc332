using System.Globalization;

namespace CreatureGen.Json;

/// <summary>A place in a text.</summary>
internal readonly struct JsonPosition
{
    public JsonPosition(int line, int column)
    {
        Line = line;
        Column = column;
    }

    /// <summary>Counted from 1; a line ends with a line feed.</summary>
    public int Line { get; }

    /// <summary>Counted from 1, in Unicode characters.</summary>
    public int Column { get; }

    /// <inheritdoc/>
    public override string ToString() =>
        "line " + Line.ToString(CultureInfo.InvariantCulture) + ", column " + Column.ToString(CultureInfo.InvariantCulture);
}
