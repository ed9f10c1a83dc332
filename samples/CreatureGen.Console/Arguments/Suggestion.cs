using System;
using System.Collections.Generic;

namespace CreatureGen.Console.Arguments;

/// <summary>Finds the word that somebody meant who typed another.</summary>
internal static class Suggestion
{
    /// <summary>The rest of a message, <c>; did you mean X?</c>, or nothing if no known word is near.</summary>
    public static string For(string typed, IEnumerable<string> known)
    {
        string? nearest = null;
        int least = int.MaxValue;
        foreach (string word in known)
        {
            int distance = IsStart(typed, word) ? 1 : Distance(typed.ToLowerInvariant(), word.ToLowerInvariant());
            if (distance < least && distance <= Math.Max(1, word.TrimStart('-').Length / 3))
            {
                least = distance;
                nearest = word;
            }
        }

        return nearest is null ? "" : "; did you mean " + nearest + "?";
    }

    private static bool IsStart(string typed, string word) =>
        typed.TrimStart('-').Length >= 2 && word.StartsWith(typed, StringComparison.OrdinalIgnoreCase);

    /// <summary>Letters to insert, delete, replace or swap with their neighbours to make one word of another.</summary>
    /// <remarks>Based on: Damerau, "A technique for computer detection and correction of spelling errors" (1964).</remarks>
    internal static int Distance(string a, string b)
    {
        int[,] steps = new int[a.Length + 1, b.Length + 1];
        for (int i = 0; i <= a.Length; i++)
        {
            for (int k = 0; k <= b.Length; k++)
            {
                if (i == 0 || k == 0)
                {
                    steps[i, k] = i + k;
                    continue;
                }

                int replaced = steps[i - 1, k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1);
                int best = Math.Min(replaced, 1 + Math.Min(steps[i - 1, k], steps[i, k - 1]));
                bool swapped = i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1];
                steps[i, k] = swapped ? Math.Min(best, 1 + steps[i - 2, k - 2]) : best;
            }
        }

        return steps[a.Length, b.Length];
    }
}
