using System;
using System.Collections.Generic;

namespace CreatureGen.Console.Arguments;

/// <summary>The words for the values of an enumeration: their names in camel case, which are those of the library's JSON texts.</summary>
/// <typeparam name="T">The enumeration.</typeparam>
internal sealed class WordList<T>
    where T : struct, Enum
{
    private readonly T[] values = Enum.GetValues<T>();
    private readonly string[] words;

    private WordList() => words = Array.ConvertAll(values, value => Camel(value.ToString()));

    /// <summary>The only one.</summary>
    public static WordList<T> Instance { get; } = new();

    /// <summary>All words.</summary>
    public IReadOnlyList<string> All => words;

    /// <summary>The word of a value.</summary>
    public string this[T value] => words[Array.IndexOf(values, value)];

    /// <summary>The value of a word.</summary>
    public bool TryFind(string word, out T value)
    {
        int index = Array.IndexOf(words, word);
        value = index < 0 ? default : values[index];
        return index >= 0;
    }

    /// <summary>What is expected, as a message says it.</summary>
    public override string ToString() => "one of " + string.Join(", ", words);

    private static string Camel(string name) => char.ToLowerInvariant(name[0]) + name[1..];
}
