using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;

namespace CreatureGen.Fuzz;

/// <summary>Counts what came of inputs, by verdict and by the way they were made. Its text can be read back.</summary>
internal sealed class FuzzTally
{
    private readonly SortedDictionary<string, long> counts = new(StringComparer.Ordinal);

    /// <summary>Number of the next input.</summary>
    public long Next { get; private set; }

    /// <summary>Whether nothing crashed and nothing was too dear.</summary>
    public bool IsClean => !counts.Keys.Any(k => k.EndsWith("/Crashed", StringComparison.Ordinal) || k.EndsWith("/Dear", StringComparison.Ordinal) || k.StartsWith("crosses/crashed", StringComparison.Ordinal) || k == "crosses/broken");

    /// <summary>Inputs of which a verdict came.</summary>
    public long Count(FuzzVerdict verdict) => counts.GetValueOrDefault("all/" + verdict);

    /// <summary>Reads a tally.</summary>
    public static FuzzTally Parse(string text)
    {
        var tally = new FuzzTally();
        foreach (string line in text.Split('\n', StringSplitOptions.RemoveEmptyEntries))
        {
            int end = line.LastIndexOf(' ');
            long number = long.Parse(line[(end + 1)..], CultureInfo.InvariantCulture);
            if (line[..end] == "next")
            {
                tally.Next = number;
            }
            else
            {
                tally.counts[line[..end]] = number;
            }
        }

        return tally;
    }

    /// <summary>Counts an input.</summary>
    public void Add(FuzzInput input, FuzzTrial trial)
    {
        Next = input.Index + 1;
        Count("all/" + trial.Verdict);
        Count(input.Way + "/" + trial.Verdict);
        foreach (string broken in trial.Verdict is FuzzVerdict.Repaired or FuzzVerdict.Beyond ? trial.Detail.Split(" -> ")[0].Split(", ").Distinct() : [])
        {
            Count("broken/" + broken);
        }
    }

    /// <summary>Counts what came of the cross of a number.</summary>
    public void Add(long index, string outcome)
    {
        Next = index + 1;
        Count("crosses/" + outcome);
    }

    /// <inheritdoc/>
    public override string ToString()
    {
        StringBuilder text = new StringBuilder("next ").Append(Next.ToString(CultureInfo.InvariantCulture)).Append('\n');
        foreach ((string name, long count) in counts)
        {
            text.Append(name).Append(' ').Append(count.ToString(CultureInfo.InvariantCulture)).Append('\n');
        }

        return text.ToString();
    }

    private void Count(string name) => counts[name] = counts.GetValueOrDefault(name) + 1;
}
