using System;
using System.Collections.Generic;
using System.Linq;

namespace CreatureGen.Console.Arguments;

/// <summary>Takes the words after a verb apart.</summary>
internal static class ArgumentReader
{
    private const string EndOfOptions = "--";

    /// <summary>Whether somebody asks what a verb does, whatever else they typed.</summary>
    public static bool AsksForHelp(IEnumerable<string> words) =>
        words.TakeWhile(word => word != EndOfOptions).Any(word => word is "--help" or "-h");

    /// <summary>Reads the words after a verb.</summary>
    /// <exception cref="UsageError">A word is unknown, twice there, or lacks its value.</exception>
    public static ParsedArguments Read(VerbSyntax syntax, IReadOnlyList<string> words)
    {
        var options = new Dictionary<string, string?>(StringComparer.Ordinal);
        var operands = new List<string>();
        bool onlyOperands = false;
        for (int i = 0; i < words.Count; i++)
        {
            string word = words[i];
            if (!onlyOperands && word == EndOfOptions)
            {
                onlyOperands = true;
            }
            else if (onlyOperands || !word.StartsWith('-') || word.Length == 1)
            {
                operands.Add(word);
            }
            else
            {
                (string name, string? value) = Split(syntax, word);
                OptionSyntax option = Find(syntax, name);
                if (option.Value != null && value == null && i + 1 < words.Count && !IsOption(syntax, words[i + 1]))
                {
                    value = words[++i];
                }

                Add(syntax, options, option, value);
            }
        }

        RequireOperands(syntax, operands);
        return new ParsedArguments(syntax, options, operands);
    }

    /// <summary>Whether a word is an option rather than the value of the one before it.</summary>
    private static bool IsOption(VerbSyntax syntax, string word) =>
        word.StartsWith("--", StringComparison.Ordinal) || syntax.Options.Any(option => option.Is(word));

    /// <summary>A word as the name of an option and the value that stands in the same word: after an equals sign, or directly after a letter.</summary>
    private static (string Name, string? Value) Split(VerbSyntax syntax, string word)
    {
        int equals = word.IndexOf('=', StringComparison.Ordinal);
        if (equals >= 0)
        {
            return (word[..equals], word[(equals + 1)..]);
        }

        bool joined = word.Length > 2 && word[1] != '-' && syntax.Options.Any(option => option.Value != null && option.Short == word[..2]);
        return joined ? (word[..2], word[2..]) : (word, null);
    }

    private static OptionSyntax Find(VerbSyntax syntax, string name)
    {
        foreach (OptionSyntax option in syntax.Options)
        {
            if (option.Is(name))
            {
                return option;
            }
        }

        string[] known = syntax.Options.Select(option => option.Name).Append("--help").ToArray();
        throw new UsageError($"{syntax.Name}: unknown option '{name}'; expected one of {string.Join(", ", known)}{Suggestion.For(name, known)}");
    }

    private static void Add(VerbSyntax syntax, Dictionary<string, string?> options, OptionSyntax option, string? value)
    {
        if (option.Value is null && value != null)
        {
            throw new UsageError($"{syntax.Name}: {option.Name} = '{value}'; expected {option.Name} without a value");
        }

        if (option.Value != null && string.IsNullOrWhiteSpace(value))
        {
            throw new UsageError($"{syntax.Name}: {option.Name} has no value; expected {option}");
        }

        if (!options.TryAdd(option.Name, value))
        {
            throw new UsageError($"{syntax.Name}: {option.Name} is there twice; expected it once");
        }
    }

    private static void RequireOperands(VerbSyntax syntax, List<string> operands)
    {
        if (syntax.Operand is null && operands.Count > 0)
        {
            throw new UsageError($"{syntax.Name}: '{operands[0]}' is no option; expected only options, such as {syntax.Options[0]}");
        }

        string[] expected = syntax.Operand?.Split(' ') ?? [];
        int least = expected.Count(word => !word.StartsWith('['));
        if (operands.Count < least)
        {
            string missing = operands.Count == 0 && least == 1 ? "no file" : $"{operands.Count} of {least} creatures";
            throw new UsageError($"{syntax.Name}: {missing}; expected {syntax.Name} {syntax.Operand}");
        }

        if (operands.Count > expected.Length)
        {
            string most = expected.Length == 1 ? "one " + syntax.Operand : syntax.Operand!;
            throw new UsageError($"{syntax.Name}: '{operands[expected.Length]}' after '{operands[expected.Length - 1]}'; expected {most}");
        }
    }
}
