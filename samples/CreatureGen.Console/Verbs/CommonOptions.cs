using System;
using CreatureGen.Console.Arguments;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Console.Verbs;

/// <summary>Options that several verbs share.</summary>
internal static class CommonOptions
{
    private const int MostThreads = 256;

    public static readonly OptionSyntax Threads = new("--threads", "N", "threads that share the work, 1 to 256 (default: one for each processor)");

    public static readonly OptionSyntax Json = new("--json", null, "print JSON");

    public static readonly OptionSyntax Flat = new("--flat", null, "flat shading: every triangle shows");

    public static readonly OptionSyntax OutFile = new("--out", "FILE", "the file to write");

    public static readonly OptionSyntax View = new("--view", "VIEW", "three-quarter (the default), side, front, back or top");

    /// <summary>From where creatures are looked at.</summary>
    /// <exception cref="UsageError">There is no such view.</exception>
    public static View ReadView(ParsedArguments arguments)
    {
        string word = arguments.Value(View.Name) ?? Views.Word(Preview.Scenes.View.ThreeQuarter);
        string[] known = Array.ConvertAll(Enum.GetValues<View>(), Views.Word);
        return Views.TryParse(word, out View found) ? found : throw arguments.Wrong(View.Name, word, "one of " + string.Join(", ", known) + Suggestion.For(word, known));
    }

    /// <summary>Number of threads.</summary>
    public static int ReadThreads(ParsedArguments arguments) => arguments.Whole(Threads.Name, 1, MostThreads, Math.Clamp(Environment.ProcessorCount, 1, MostThreads));
}
