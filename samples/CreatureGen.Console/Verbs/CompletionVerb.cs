using System.Linq;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Text;

namespace CreatureGen.Console.Verbs;

/// <summary>Prints a script by which a shell completes what is typed.</summary>
internal sealed class CompletionVerb : IVerb
{
    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "completion",
        "SHELL",
        "print a script that completes verbs, options and values in bash, zsh or PowerShell",
        [
            new("completion bash > ~/.local/share/bash-completion/completions/creaturegen", "for bash, from the next shell on"),
            new("completion zsh > ~/.zfunc/_creaturegen", "for zsh, with that folder in fpath"),
            new("completion powershell >> $PROFILE", "for PowerShell"),
        ],
        [])
    {
        Operands = CompletionScript.Shells.Keys.ToArray(),
    };

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        if (!CompletionScript.Shells.TryGetValue(arguments.Operand, out var write))
        {
            throw arguments.Wrong($"'{arguments.Operand}' is no shell that is known; expected one of {string.Join(", ", Syntax.Operands)}{Suggestion.For(arguments.Operand, Syntax.Operands)}");
        }

        write(surroundings.Out, Application.Verbs.Select(verb => verb.Syntax).ToArray());
        return ExitCode.Done;
    }
}
