using System;
using System.Collections.Generic;
using System.Globalization;

namespace CreatureGen.Console.Batches;

/// <summary>One of several tasks that share the creatures of a batch: it takes each whose ordinal leaves its index when divided by their number.</summary>
/// <param name="Index">Which of them, from 0.</param>
/// <param name="Count">How many there are.</param>
internal readonly record struct Shard(int Index, int Count)
{
    /// <summary>Tasks that may share a batch.</summary>
    public const int Max = 1_000_000;

    /// <summary>The one task that does all.</summary>
    public static Shard Whole { get; } = new(0, 1);

    /// <summary>Which words are a shard, as a message says it.</summary>
    public static string Expectation { get; } = FormattableString.Invariant($"i/n with n from 1 to {Max} and i from 0 to n - 1, such as 0/4");

    /// <summary>Reads what <see cref="ToString"/> writes.</summary>
    public static bool TryRead(string text, out Shard shard)
    {
        string[] sides = text.Split('/', 3);
        shard = Whole;
        if (sides.Length != 2 || !TryNumber(sides[0], out int index) || !TryNumber(sides[1], out int count) || count is < 1 or > Max || index >= count)
        {
            return false;
        }

        shard = new Shard(index, count);
        return true;
    }

    /// <summary>Those of all that this task takes, in their order.</summary>
    public IEnumerable<T> Of<T>(IEnumerable<T> all)
    {
        int place = 0;
        foreach (T item in all)
        {
            if (place == Index)
            {
                yield return item;
            }

            place = place + 1 == Count ? 0 : place + 1;
        }
    }

    /// <summary>How many of so many this task takes.</summary>
    public UInt128 CountOf(UInt128 all) => all > (UInt128)Index ? ((all - (UInt128)Index - 1) / (UInt128)Count) + 1 : 0;

    /// <summary>The name of a file that each task has of its own.</summary>
    /// <param name="stem">What it is.</param>
    public string FileName(string stem) => Count == 1 ? stem + ".jsonl" : string.Create(CultureInfo.InvariantCulture, $"{stem}-{Index}-of-{Count}.jsonl");

    /// <summary>As it is written: <c>3/64</c>.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Index}/{Count}");

    private static bool TryNumber(string text, out int number) => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out number);
}
