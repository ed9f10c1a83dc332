using System;
using CreatureGen.Console.Arguments;

namespace CreatureGen.Console.Verbs;

/// <summary>Options that several verbs share.</summary>
internal static class CommonOptions
{
    private const int MostThreads = 256;

    public static readonly OptionSyntax Threads = new("--threads", "N", "threads that share the work, 1 to 256 (default: one for each processor)");

    public static readonly OptionSyntax Json = new("--json", null, "print JSON");

    public static readonly OptionSyntax Flat = new("--flat", null, "flat shading: every triangle shows");

    public static readonly OptionSyntax OutFile = new("--out", "FILE", "the file to write");

    /// <summary>Number of threads.</summary>
    public static int ReadThreads(ParsedArguments arguments) => arguments.Whole(Threads.Name, 1, MostThreads, Math.Clamp(Environment.ProcessorCount, 1, MostThreads));
}
