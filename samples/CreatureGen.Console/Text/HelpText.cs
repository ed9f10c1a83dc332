using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Console.Arguments;

namespace CreatureGen.Console.Text;

/// <summary>What the program says of itself: examples first.</summary>
internal static class HelpText
{
    private static readonly OptionSyntax help = new("--help", null, "this text");
    private static readonly OptionSyntax version = new("--version", null, "the program's version");

    /// <summary>Name and version.</summary>
    public static string Version { get; } = Application.Name + " " + typeof(HelpText).Assembly.GetName().Version?.ToString(3);

    /// <summary>What the program says to the script that started it.</summary>
    public static IReadOnlyList<(string Code, string Meaning)> ExitCodes { get; } =
    [
        ("0", "done"),
        ("1", "a check failed, or a seed of a batch gave no creature"),
        ("2", "bad usage or input"),
        ("3", "a file could not be written"),
        ("130", "interrupted; no unfinished file is left"),
    ];

    /// <summary>Writes the help of the whole program.</summary>
    public static void Write(TextWriter output, IReadOnlyList<VerbSyntax> verbs, Ink ink)
    {
        output.WriteLine(ink.Heading("creaturegen") + " grows complete game creatures from seeds: mesh, skeleton, skin, colours.");
        output.WriteLine();
        IEnumerable<Example> examples = verbs.Select(verb => verb.Examples[0]).Prepend(new Example("", "creature 101: a GLB, a picture and its blueprint, here"));
        Write(output, "Examples", examples.Select(example => (Command(example.Line), example.Effect)), ink);
        Write(output, "Verbs", verbs.Select(verb => (verb.Name, verb.Summary)), ink);
        Write(output, "Options", [Row(new OptionSyntax("VERB --help", null, "all options of a verb, with examples")), Row(help), Row(version)], ink);
        Write(output, "Exit codes", ExitCodes, ink);
        output.WriteLine("Data goes to the standard output, progress and complaints to the standard error. NO_COLOR is respected.");
    }

    /// <summary>Writes the help of a verb.</summary>
    public static void Write(TextWriter output, VerbSyntax verb, Ink ink)
    {
        output.WriteLine(ink.Heading(Command(verb.Name + (verb.Operand is null ? "" : " " + verb.Operand) + " [options]")) + ": " + verb.Summary + ".");
        output.WriteLine();
        Write(output, "Examples", verb.Examples.Select(example => (Command(example.Line), example.Effect)), ink);
        Write(output, "Options", verb.Options.Append(help).Select(Row), ink);
    }

    private static (string Left, string Right) Row(OptionSyntax option) => (option.Short is null ? option.ToString() : option.Short + ", " + option, option.Meaning);

    private static string Command(string line) => line.Length == 0 ? Application.Name : Application.Name + " " + line;

    private static void Write(TextWriter output, string heading, IEnumerable<(string Left, string Right)> rows, Ink ink)
    {
        (string Left, string Right)[] all = rows.ToArray();
        int width = all.Max(row => row.Left.Length <= WidestColumn ? row.Left.Length : 0);
        output.WriteLine(ink.Heading(heading));
        foreach ((string left, string right) in all)
        {
            if (left.Length <= width)
            {
                output.WriteLine("  " + left.PadRight(width + 2) + right);
            }
            else
            {
                output.WriteLine("  " + left);
                output.WriteLine(new string(' ', width + 4) + right);
            }
        }

        output.WriteLine();
    }

    // What is longer gets a line of its own.
    private const int WidestColumn = 58;
}
