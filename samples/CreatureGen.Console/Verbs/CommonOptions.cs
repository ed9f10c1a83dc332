using System;
using CreatureGen.Console.Arguments;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Console.Verbs;

/// <summary>Options that several verbs share.</summary>
internal static class CommonOptions
{
    private const int MaxThreads = 256;

    public static readonly OptionSyntax Threads = new("--threads", "N", "threads that share the work, 1 to 256 (default: one for each processor)");

    public static readonly OptionSyntax Json = new("--json", null, "print JSON");

    public static readonly OptionSyntax Quiet = new("--quiet", null, "print nothing but complaints") { Short = "-q" };

    public static readonly OptionSyntax Flat = new("--flat", null, "flat shading: every triangle shows");

    public static readonly OptionSyntax OutFile = new("--out", "FILE", "the file to write") { Short = "-o" };

    public static readonly OptionSyntax View = new("--view", "VIEW", "three-quarter (the default), side, front, back or top") { Words = Array.ConvertAll(Enum.GetValues<View>(), Views.Word) };

    /// <summary>Whether nothing is to be told but what went wrong.</summary>
    /// <exception cref="UsageError">JSON is asked for too.</exception>
    public static bool IsQuiet(ParsedArguments arguments) => arguments.Has(Quiet.Name) && (!arguments.Has(Json.Name) ? true : throw arguments.Wrong($"{Quiet.Name} and {Json.Name}; expected one of them"));

    /// <summary>From where creatures are looked at.</summary>
    /// <exception cref="UsageError">There is no such view.</exception>
    public static View ReadView(ParsedArguments arguments)
    {
        string word = arguments.Value(View.Name) ?? Views.Word(Preview.Scenes.View.ThreeQuarter);
        string[] known = Array.ConvertAll(Enum.GetValues<View>(), Views.Word);
        return Views.TryParse(word, out View found) ? found : throw arguments.Wrong(View.Name, word, "one of " + string.Join(", ", known) + Suggestion.For(word, known));
    }

    /// <summary>Number of threads.</summary>
    public static int ReadThreads(ParsedArguments arguments) => arguments.Whole(Threads.Name, 1, MaxThreads, Math.Clamp(Environment.ProcessorCount, 1, MaxThreads));
}
