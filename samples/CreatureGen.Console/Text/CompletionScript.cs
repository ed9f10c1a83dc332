using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Console.Arguments;

namespace CreatureGen.Console.Text;

/// <summary>Scripts by which shells complete verbs, options and the words that are their values.</summary>
internal static class CompletionScript
{
    private static readonly OptionSyntax help = new("--help", null, "all options of the verb, with examples") { Short = "-h" };

    /// <summary>Shells that there are scripts for, and who writes them.</summary>
    public static IReadOnlyDictionary<string, Action<TextWriter, IReadOnlyList<VerbSyntax>>> Shells { get; } = new Dictionary<string, Action<TextWriter, IReadOnlyList<VerbSyntax>>>
    {
        ["bash"] = Bash,
        ["zsh"] = Zsh,
        ["powershell"] = PowerShell,
    };

    private static void Bash(TextWriter output, IReadOnlyList<VerbSyntax> verbs)
    {
        Lines(
            output,
            "# creaturegen in bash: source <(creaturegen completion bash)",
            "_creaturegen() {",
            "    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} verb=${COMP_WORDS[1]} words=''",
            "    if [ \"$COMP_CWORD\" -eq 1 ]; then",
            $"        COMPREPLY=($(compgen -W '{string.Join(' ', verbs.Select(verb => verb.Name))} help --help --version' -- \"$current\"))",
            "        return",
            "    fi",
            "    case \"$verb $before\" in");
        foreach (VerbSyntax verb in verbs)
        {
            foreach (OptionSyntax option in verb.Options.Where(option => option.Value != null))
            {
                string pattern = string.Join('|', Names(option).Select(name => $"'{verb.Name} {name}'"));
                string reply = option.Words.Count > 0 ? $"-W '{string.Join(' ', option.Words)}'" : IsFolder(option) ? "-d" : IsFile(option) ? "-f" : "";
                Lines(output, $"        {pattern}) COMPREPLY=({(reply.Length == 0 ? "" : $"$(compgen {reply} -- \"$current\")")}); return ;;");
            }
        }

        Lines(output, "    esac", "    case \"$verb\" in");
        foreach (VerbSyntax verb in verbs)
        {
            Lines(output, $"        {verb.Name}) words='{string.Join(' ', verb.Operands.Concat(verb.Options.Append(help).Select(option => option.Name)))}' ;;");
        }

        Lines(
            output,
            "    esac",
            "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))",
            "    case \"$current\" in -*) ;; *) COMPREPLY+=($(compgen -f -- \"$current\")) ;; esac",
            "}",
            "complete -o filenames -F _creaturegen creaturegen");
    }

    private static void Zsh(TextWriter output, IReadOnlyList<VerbSyntax> verbs)
    {
        Lines(output, "#compdef creaturegen", "# creaturegen in zsh: source <(creaturegen completion zsh)", "_creaturegen() {", "    local -a verbs", "    verbs=(");
        foreach (VerbSyntax verb in verbs)
        {
            Lines(output, $"        {Quoted(verb.Name + ":" + verb.Summary)}");
        }

        Lines(output, "    )", "    if (( CURRENT == 2 )); then", "        _describe verb verbs", "        return", "    fi", "    local verb=$words[2]", "    shift words", "    (( CURRENT-- ))", "    case $verb in");
        foreach (VerbSyntax verb in verbs)
        {
            Lines(output, $"        {verb.Name})", "            _arguments \\");
            foreach (OptionSyntax option in verb.Options.Append(help))
            {
                string meaning = option.Meaning.Replace("[", "(", StringComparison.Ordinal).Replace("]", ")", StringComparison.Ordinal);
                string value = option.Value is null ? "" : $":{option.Value.Replace(":", "", StringComparison.Ordinal)}:{(option.Words.Count > 0 ? $"({string.Join(' ', option.Words)})" : IsFolder(option) ? "_files -/" : IsFile(option) ? "_files" : "")}";
                Lines(output, $"                {string.Join(" \\\n                ", Names(option).Select(name => Quoted($"{name}[{meaning}]{value}")))} \\");
            }

            string rest = verb.Operands.Count > 0 ? $"({string.Join(' ', verb.Operands)})" : verb.Operand is null ? "" : "_files";
            Lines(output, $"                {Quoted("*: :" + rest)} ;;");
        }

        // In a folder of fpath the script is the body of the function; read by a shell it defines it.
        Lines(output, "    esac", "}", "if [ \"$funcstack[1]\" = _creaturegen ]; then _creaturegen \"$@\"; else compdef _creaturegen creaturegen; fi");
    }

    private static void PowerShell(TextWriter output, IReadOnlyList<VerbSyntax> verbs)
    {
        // Of each option the words that its value may be, of one without a value nothing. Only commands of PowerShell's core are used: the script runs where its modules are not loaded.
        Lines(output, "# creaturegen in PowerShell: creaturegen completion powershell | Out-String | Invoke-Expression", "Register-ArgumentCompleter -Native -CommandName creaturegen -ScriptBlock {", "    param($current, $line, $position)", "    $verbs = [ordered]@{");
        foreach (VerbSyntax verb in verbs)
        {
            Lines(output, $"        {Doubled(verb.Name)} = [ordered]@{{ '' = {WordArray(verb.Operands)}; {string.Join("; ", verb.Options.Append(help).SelectMany(option => Names(option).Select(name => $"{Doubled(name)} = {(option.Value is null ? "$null" : WordArray(option.Words))}")))} }}");
        }

        Lines(
            output,
            "    }",
            "    $words = @($line.CommandElements | ForEach-Object { $_.ToString() })",
            "    $count = $words.Count",
            "    if ($current -ne '') { $count-- }",
            "    $found = @()",
            "    if ($count -le 1) { $found = @($verbs.Keys) + @('help', '--help', '--version') }",
            "    elseif ($verbs.Contains($words[1])) {",
            "        $options = $verbs[$words[1]]",
            "        $before = $words[$count - 1]",
            "        if ($options.Contains($before) -and $null -ne $options[$before]) { $found = $options[$before] }",
            "        else { $found = $options[''] + @($options.Keys | Where-Object { $_ -like '--*' }) }",
            "    }",
            "    $found | Where-Object { $_ -and $_.StartsWith($current) } | ForEach-Object { [System.Management.Automation.CompletionResult]::new($_, $_, 'ParameterValue', $_) }",
            "}");
    }

    private static string WordArray(IReadOnlyList<string> words) => $"@({string.Join(", ", words.Select(Doubled))})";

    private static IEnumerable<string> Names(OptionSyntax option) => option.Short is null ? [option.Name] : [option.Short, option.Name];

    private static bool IsFolder(OptionSyntax option) => option.Value == "DIR";

    private static bool IsFile(OptionSyntax option) => option.Value?.StartsWith("FILE", StringComparison.Ordinal) == true;

    private static string Quoted(string text) => "'" + text.Replace("'", "'\\''", StringComparison.Ordinal) + "'";

    private static string Doubled(string text) => "'" + text.Replace("'", "''", StringComparison.Ordinal) + "'";

    private static void Lines(TextWriter output, params string[] lines)
    {
        foreach (string line in lines)
        {
            output.Write(line + "\n");
        }
    }
}
