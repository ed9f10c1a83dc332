using CreatureGen.Console.Arguments;

namespace CreatureGen.Console.Verbs;

/// <summary>Something that the program does.</summary>
internal interface IVerb
{
    /// <summary>What it understands.</summary>
    VerbSyntax Syntax { get; }

    /// <summary>Does it.</summary>
    /// <returns>One of <see cref="ExitCode"/>.</returns>
    int Run(ParsedArguments arguments, Surroundings surroundings);
}
