using System;
using System.Collections.Generic;
using System.Globalization;

namespace CreatureGen.Console.Arguments;

/// <summary>The words after a verb, taken apart.</summary>
internal sealed class ParsedArguments
{
    private readonly VerbSyntax syntax;
    private readonly IReadOnlyDictionary<string, string?> options;
    private readonly IReadOnlyList<string> operands;

    public ParsedArguments(VerbSyntax syntax, IReadOnlyDictionary<string, string?> options, IReadOnlyList<string> operands)
    {
        this.syntax = syntax;
        this.options = options;
        this.operands = operands;
    }

    /// <summary>The first operand of a verb that takes any.</summary>
    public string Operand => operands.Count > 0 ? operands[0] : throw new InvalidOperationException("this verb takes no operand");

    /// <summary>The second operand; null if it is not there.</summary>
    public string? SecondOperand => operands.Count > 1 ? operands[1] : null;

    /// <summary>The options that are there.</summary>
    public IEnumerable<string> Names => options.Keys;

    /// <summary>Whether an option is there.</summary>
    public bool Has(string name) => options.ContainsKey(name);

    /// <summary>The value of an option; null if it is not there.</summary>
    public string? Value(string name) => options.TryGetValue(name, out string? value) ? value : null;

    /// <summary>The value of an option that must be there.</summary>
    public string Required(string name) =>
        Value(name) ?? throw new UsageError($"{syntax.Name}: no {name}; expected {Syntax(name)}");

    /// <summary>The value of an option that is a whole number.</summary>
    public int Whole(string name, int least, int most, int absent)
    {
        if (Value(name) is not string text)
        {
            return absent;
        }

        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number >= least && number <= most)
        {
            return number;
        }

        throw Wrong(name, text, string.Create(CultureInfo.InvariantCulture, $"a whole number {least}..{most}"));
    }

    /// <summary>The value of an option that is a number.</summary>
    public double Number(string name, double least, double most, double absent)
    {
        if (Value(name) is not string text)
        {
            return absent;
        }

        if (double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double number) && number >= least && number <= most)
        {
            return number;
        }

        throw Wrong(name, text, string.Create(CultureInfo.InvariantCulture, $"a number {least}..{most}"));
    }

    /// <summary>The value of an option that is one of several words.</summary>
    public T Choice<T>(string name, WordList<T> words, T absent)
        where T : struct, Enum
    {
        if (Value(name) is not string text)
        {
            return absent;
        }

        return words.TryFind(text, out T value) ? value : throw Wrong(name, text, words + Suggestion.For(text, words.All));
    }

    /// <summary>What to throw when the value of an option is wrong.</summary>
    public UsageError Wrong(string name, string value, string expectation) => new($"{syntax.Name}: {name} = '{Shorten(value)}'; expected {expectation}");

    /// <summary>What to throw when options do not go together.</summary>
    public UsageError Wrong(string message) => new($"{syntax.Name}: {message}");

    private static string Shorten(string value) => value.Length <= 60 ? value : value[..57] + "...";

    private OptionSyntax Syntax(string name)
    {
        foreach (OptionSyntax option in syntax.Options)
        {
            if (option.Name == name)
            {
                return option;
            }
        }

        throw new InvalidOperationException("no option " + name);
    }
}
