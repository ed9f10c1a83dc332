using System.Globalization;
using System.Text;

namespace CreatureGen.Json;

/// <summary>Shows foreign text in messages: short, on one line, printable.</summary>
internal static class Excerpt
{
    /// <summary>Longer text is cut off.</summary>
    public const int MaximumLength = 48;

    /// <summary>The text in quotation marks; controls and halves of surrogate pairs are escaped, and what is too long is cut off with an ellipsis.</summary>
    public static string Quoted(string text) => "\"" + Of(text) + "\"";

    /// <summary>The text; controls and halves of surrogate pairs are escaped, and what is too long is cut off with an ellipsis.</summary>
    public static string Of(string text)
    {
        var result = new StringBuilder();
        for (int i = 0; i < text.Length; i++)
        {
            if (i >= MaximumLength)
            {
                return result.Append('…').ToString();
            }

            if (char.IsHighSurrogate(text[i]) && i + 1 < text.Length && char.IsLowSurrogate(text[i + 1]))
            {
                result.Append(text, i++, 2);
            }
            else if (char.IsControl(text[i]) || char.IsSurrogate(text[i]) || text[i] == '\u2028' || text[i] == '\u2029')
            {
                result.Append("\\u").Append(((int)text[i]).ToString("x4", CultureInfo.InvariantCulture));
            }
            else
            {
                result.Append(text[i]);
            }
        }

        return result.ToString();
    }
}
