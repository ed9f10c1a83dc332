using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;

namespace CreatureGen.Console.Arguments;

/// <summary>Seeds from a least to a greatest, both included.</summary>
internal readonly record struct SeedRange(ulong First, ulong Last)
{
    /// <summary>Number of seeds: one more than 64 bits hold for the range of all.</summary>
    public UInt128 Count => (UInt128)(Last - First) + 1;

    /// <summary>As it is written.</summary>
    public override string ToString() => First == Last ? SeedText.Of(First) : SeedText.Of(First) + "-" + SeedText.Of(Last);
}

/// <summary>Seeds in the order in which they were asked for, each once. They are counted off, never stored: a range may be as long as it likes.</summary>
internal sealed class SeedList : IEnumerable<ulong>
{
    /// <summary>Ranges that a list may have.</summary>
    public const int MaxRanges = 1000;

    private readonly IReadOnlyList<SeedRange> ranges;

    private SeedList(IReadOnlyList<SeedRange> ranges) => this.ranges = ranges;

    /// <summary>Number of seeds.</summary>
    public UInt128 Count => ranges.Aggregate(UInt128.Zero, (sum, range) => sum + range.Count);

    /// <summary>The list of one seed.</summary>
    public static SeedList Of(ulong seed) => new([new SeedRange(seed, seed)]);

    /// <summary>Reads a list such as <c>1-1000,2000,0xBEEF</c>.</summary>
    /// <exception cref="FormatException">It is no such list; the message says what was wrong and what was expected.</exception>
    public static SeedList Read(string text)
    {
        string[] parts = text.Split(',', MaxRanges + 1);
        if (parts.Length > MaxRanges)
        {
            throw new FormatException(FormattableString.Invariant($"more than {MaxRanges} seeds and ranges; expected at most {MaxRanges}"));
        }

        SeedRange[] ranges = Array.ConvertAll(parts, ReadRange);
        RequireApart(ranges);
        return new SeedList(ranges);
    }

    /// <inheritdoc/>
    public IEnumerator<ulong> GetEnumerator()
    {
        foreach (SeedRange range in ranges)
        {
            // Tested at the end: the greatest seed of all has no successor.
            for (ulong seed = range.First; ; seed++)
            {
                yield return seed;
                if (seed == range.Last)
                {
                    break;
                }
            }
        }
    }

    /// <summary>As <see cref="Read"/> reads it.</summary>
    public override string ToString() => string.Join(",", ranges);

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    private static SeedRange ReadRange(string part)
    {
        string text = part.Trim();
        int dash = text.IndexOf('-', StringComparison.Ordinal);
        if (dash < 0)
        {
            ulong seed = ReadSeed(text, text);
            return new SeedRange(seed, seed);
        }

        ulong first = ReadSeed(text[..dash].Trim(), text);
        ulong last = ReadSeed(text[(dash + 1)..].Trim(), text);
        return first <= last
            ? new SeedRange(first, last)
            : throw new FormatException($"the range {text} runs backwards; expected the smaller seed first, {SeedText.Of(last)}-{SeedText.Of(first)}");
    }

    private static ulong ReadSeed(string text, string within)
    {
        if (SeedText.TryRead(text, out ulong seed))
        {
            return seed;
        }

        string where = text == within ? "" : $" in '{within}'";
        throw new FormatException($"'{text}'{where} is no seed; expected {SeedText.Expectation}, or a range of two such as 1-1000");
    }

    private static void RequireApart(SeedRange[] ranges)
    {
        SeedRange[] sorted = ranges.OrderBy(range => range.First).ToArray();
        for (int i = 1; i < sorted.Length; i++)
        {
            if (sorted[i].First <= sorted[i - 1].Last)
            {
                throw new FormatException($"{SeedText.Of(sorted[i].First)} is in {sorted[i - 1]} and in {sorted[i]}; expected each seed once");
            }
        }
    }
}
