using System;
using System.Collections.Generic;
using System.IO;
using CreatureGen.Benchmarks.Beside;

namespace CreatureGen.Benchmarks;

/// <summary>The document that keeps what was measured, each part between two comments.</summary>
internal static class SpeedDocument
{
    private const string Place = "docs/performance.md";

    /// <summary>The folder of its plots, from the root of the repository.</summary>
    public const string Plots = "docs/performance";

    /// <summary>Prints lines and puts them between the comments of a mark.</summary>
    /// <exception cref="InvalidDataException">The document lacks the comments.</exception>
    public static void Put(string mark, IReadOnlyList<string> lines, TextWriter output)
    {
        string part = string.Join('\n', lines).TrimEnd() + "\n";
        output.Write(part);
        string path = Path.Combine(ProbeBuild.Root, Place);
        string text = File.ReadAllText(path);
        string first = $"<!-- {mark} -->\n", last = $"<!-- end of {mark} -->";
        int from = text.IndexOf(first, StringComparison.Ordinal), to = text.IndexOf(last, StringComparison.Ordinal);
        if (from < 0 || to < from)
        {
            throw new InvalidDataException($"{Place} has no '<!-- {mark} -->' before '{last}'; expected both, each on a line of its own");
        }

        File.WriteAllText(path, text[..(from + first.Length)] + part + text[to..]);
    }
}
