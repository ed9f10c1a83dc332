using System.Globalization;

namespace CreatureGen.Blueprints;

/// <summary>One thing that is wrong with a blueprint, with options or with their text.</summary>
/// <param name="Path">What is wrong, by its names in the JSON text: <c>legs[2].girth</c>.</param>
/// <param name="Value">What it is; long text is cut off.</param>
/// <param name="Expectation">What it should be.</param>
/// <param name="Line">Line of the text it was read from, from 1; null if it was not read from text.</param>
/// <param name="Column">Column of the text it was read from, in characters from 1; null if it was not read from text.</param>
public sealed record Problem(string Path, string Value, string Expectation, int? Line = null, int? Column = null)
{
    /// <summary>The problem as a sentence: <c>legs[2].girth = 1.4; expected 0..1</c>, and where it stands if it was read from text.</summary>
    public override string ToString()
    {
        string sentence = Path + " = " + Value + "; expected " + Expectation;
        return Line is int line && Column is int column
            ? sentence + string.Format(CultureInfo.InvariantCulture, " (line {0}, column {1})", line, column)
            : sentence;
    }
}
