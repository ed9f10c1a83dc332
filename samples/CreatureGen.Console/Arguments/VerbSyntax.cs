using System.Collections.Generic;

namespace CreatureGen.Console.Arguments;

/// <summary>An option of a verb.</summary>
/// <param name="Name">With its two dashes.</param>
/// <param name="Value">What its value is called in the help; null for an option without one.</param>
/// <param name="Meaning">A line for the help.</param>
internal sealed record OptionSyntax(string Name, string? Value, string Meaning)
{
    /// <summary>A dash and a letter that mean the same; null if there are none.</summary>
    public string? Short { get; init; }

    /// <summary>The words that its value may be, where they are few; otherwise none.</summary>
    public IReadOnlyList<string> Words { get; init; } = [];

    /// <summary>Whether a word is this option.</summary>
    public bool Is(string word) => word == Name || word == Short;

    /// <summary>The option and its value, as messages show them.</summary>
    public override string ToString() => Value is null ? Name : Name + " " + Value;
}

/// <summary>A command line and what it does.</summary>
/// <param name="Line">What to type after the program's name.</param>
/// <param name="Effect">What comes of it.</param>
internal sealed record Example(string Line, string Effect);

/// <summary>What a verb understands.</summary>
/// <param name="Name">The verb.</param>
/// <param name="Operand">What its operands are called, a word each, those that may be left out in brackets; null if it takes none.</param>
/// <param name="Summary">What it does, in a line.</param>
/// <param name="Examples">Command lines that work.</param>
/// <param name="Options">Its options, in the order of the help.</param>
internal sealed record VerbSyntax(string Name, string? Operand, string Summary, IReadOnlyList<Example> Examples, IReadOnlyList<OptionSyntax> Options)
{
    /// <summary>The words that its operand may be, where they are few; otherwise none.</summary>
    public IReadOnlyList<string> Operands { get; init; } = [];
}
