using System.Text;

namespace CreatureGen.Tests.Conventions;

/// <summary>C# text without what the compiler does not read as code.</summary>
internal static class SourceText
{
    /// <summary>The text with its comments, strings and characters blanked; line breaks stay, so that lines keep their numbers.</summary>
    public static string CodeOf(string text)
    {
        var code = new StringBuilder(text.Length);
        int at = 0;
        while (at < text.Length)
        {
            int end = EndOfIgnored(text, at);
            if (end == at)
            {
                code.Append(text[at++]);
                continue;
            }

            for (; at < end; at++)
            {
                code.Append(text[at] == '\n' ? '\n' : ' ');
            }
        }

        return code.ToString();
    }

    /// <summary>Number of the line that a place is on, from 1.</summary>
    public static int LineAt(string text, int place)
    {
        int line = 1;
        for (int i = 0; i < place; i++)
        {
            line += text[i] == '\n' ? 1 : 0;
        }

        return line;
    }

    private static int EndOfIgnored(string text, int at)
    {
        if (Starts(text, at, "//"))
        {
            return IndexOrEnd(text, "\n", at, 0);
        }

        if (Starts(text, at, "/*"))
        {
            return IndexOrEnd(text, "*/", at + 2, 2);
        }

        if (Starts(text, at, "\"\"\""))
        {
            int quotes = 3;
            while (at + quotes < text.Length && text[at + quotes] == '"')
            {
                quotes++;
            }

            string fence = new('"', quotes);
            return IndexOrEnd(text, fence, at + quotes, quotes);
        }

        if (Starts(text, at, "@\"") || Starts(text, at, "$@\"") || Starts(text, at, "@$\""))
        {
            return EndOfVerbatim(text, text.IndexOf('"', at) + 1);
        }

        return text[at] is '"' or '\'' ? EndOfQuoted(text, at + 1, text[at]) : at;
    }

    private static int EndOfVerbatim(string text, int at)
    {
        while (at < text.Length && (text[at] != '"' || Starts(text, at, "\"\"")))
        {
            at += text[at] == '"' ? 2 : 1;
        }

        return System.Math.Min(at + 1, text.Length);
    }

    private static int EndOfQuoted(string text, int at, char quote)
    {
        while (at < text.Length && text[at] != quote && text[at] != '\n')
        {
            at += text[at] == '\\' ? 2 : 1;
        }

        return System.Math.Min(at + 1, text.Length);
    }

    private static int IndexOrEnd(string text, string wanted, int from, int length)
    {
        int found = text.IndexOf(wanted, System.Math.Min(from, text.Length), System.StringComparison.Ordinal);
        return found < 0 ? text.Length : found + length;
    }

    private static bool Starts(string text, int at, string with) => string.CompareOrdinal(text, at, with, 0, with.Length) == 0;
}
