using System.Linq;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Text;

namespace CreatureGen.Console.Verbs;

/// <summary>Prints the help of all verbs.</summary>
internal sealed class ManualVerb : IVerb
{
    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new("manual", null, "print the help of all verbs as a page of Markdown", [new("manual > docs/console.md", "the page of the documents")], []);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        Manual.Write(surroundings.Out, Application.Verbs.Select(verb => verb.Syntax).ToArray());
        return ExitCode.Done;
    }
}
