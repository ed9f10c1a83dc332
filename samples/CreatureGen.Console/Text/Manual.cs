using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Console.Arguments;

namespace CreatureGen.Console.Text;

/// <summary>The help of the whole program as one page of Markdown.</summary>
internal static class Manual
{
    /// <summary>Writes the page, lines ended by line feeds on every system.</summary>
    public static void Write(TextWriter output, IReadOnlyList<VerbSyntax> verbs)
    {
        var lines = new List<string>
        {
            "# The console, verb by verb",
            "",
            "This page is what `creaturegen manual` prints: help and page have one source, the tables of options of the program itself.",
            "",
            "`creaturegen VERB [options]`; `creaturegen VERB --help` tells of one verb. Without a verb it makes creature 101 in the current folder.",
            "",
            "| verb | what it does |",
            "| --- | --- |",
        };
        lines.AddRange(verbs.Select(verb => $"| [{verb.Name}](#{verb.Name}) | {Prose(verb.Summary)} |"));
        lines.AddRange(
        [
            "",
            "Values stand after an option or behind an equals sign (`--seed 7`, `--seed=7`), after a short option also without a space (`-s7`). After `--` nothing is an option. `-` as a file is the standard input or output.",
            "Data goes to the standard output, progress and complaints to the standard error; progress and colours are shown on terminals alone, and neither where `NO_COLOR` is set or `TERM` is `dumb`.",
            "",
            "| exit code | meaning |",
            "| --- | --- |",
        ]);
        lines.AddRange(HelpText.ExitCodes.Select(row => $"| {row.Code} | {row.Meaning} |"));
        foreach (VerbSyntax verb in verbs)
        {
            lines.AddRange(["", "## " + verb.Name, Prose(verb.Summary[..1].ToUpperInvariant() + verb.Summary[1..] + "."), "", "```"]);
            int width = verb.Examples.Max(example => example.Line.Length);
            lines.AddRange(verb.Examples.Select(example => $"{Application.Name} {example.Line.PadRight(width)}  # {example.Effect}"));
            lines.Add("```");
            if (verb.Operand != null)
            {
                lines.AddRange(["", $"Takes `{verb.Operand}`."]);
            }

            if (verb.Options.Count > 0)
            {
                lines.AddRange(["", "| option | meaning |", "| --- | --- |"]);
                lines.AddRange(verb.Options.Select(option => $"| {(option.Short is null ? "" : $"`{option.Short}`, ")}`{Cell(option.ToString())}` | {Prose(option.Meaning)} |"));
            }
        }

        lines.ForEach(line => output.Write(line + "\n"));
    }

    private static string Prose(string text) => Cell(text).Replace("<", "\\<", StringComparison.Ordinal);

    private static string Cell(string text) => text.Replace("|", "\\|", StringComparison.Ordinal);
}
