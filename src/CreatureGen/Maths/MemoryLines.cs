using System;
using System.Runtime.InteropServices;

namespace CreatureGen.Maths;

/// <summary>Lines of memory, each of which processors fetch as one.</summary>
internal static class MemoryLines
{
    /// <summary>Whole numbers in a line.</summary>
    private const int Numbers = 16;

    /// <summary>Reads a number of each line that a list lies in: all are asked for at once, and none waits for another.</summary>
    /// <returns>What was read, mixed: it means nothing, but has to go somewhere, or the compiler would leave the reading out.</returns>
    public static int Touch<T>(ReadOnlySpan<T> list)
        where T : struct
    {
        ReadOnlySpan<int> numbers = MemoryMarshal.Cast<T, int>(list);
        int read = 0;
        for (int i = 0; i < numbers.Length; i += Numbers)
        {
            read ^= numbers[i];
        }

        return read;
    }
}
