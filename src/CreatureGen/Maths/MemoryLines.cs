using System;
#if NET
using System.Runtime.CompilerServices;
#endif
using System.Runtime.InteropServices;

namespace CreatureGen.Maths;

/// <summary>Lines of memory, each of which processors fetch as one.</summary>
internal static class MemoryLines
{
    /// <summary>Whole numbers in a line.</summary>
    private const int Numbers = 16;

    /// <summary>Whether to ask for them is worth while: not in browsers, where each number that is read is an operation of its own.</summary>
    public static bool Pay =>
#if NET
        !OperatingSystem.IsBrowser();
#else
        true;
#endif

    /// <summary>Reads a number of each line that a list lies in: all are asked for at once, and none waits for another.</summary>
    /// <param name="list">The list.</param>
    /// <param name="count">How long it is, at most, as is known without it; no bounds are checked. Asked itself, it would have to come from memory before it is known how often the loop goes round, and so would the next one.</param>
    /// <returns>What was read, mixed: it means nothing, but has to go somewhere, or the compiler would leave the reading out.</returns>
    public static int Touch<T>(T[] list, int count)
        where T : struct
    {
#if NET
        return Read(ref Unsafe.As<T, int>(ref MemoryMarshal.GetArrayDataReference(list)), (nint)count * Unsafe.SizeOf<T>() / sizeof(int));
#else
        return Read(MemoryMarshal.Cast<T, int>(list.AsSpan(0, count)));
#endif
    }

    /// <summary>Reads a number of each line that a part of an object lies in, and so fetches what lies beside it too.</summary>
    /// <param name="part">A field of it, of four bytes or more.</param>
    /// <returns>What was read, mixed, as above.</returns>
    public static int Touch<T>(ref T part)
        where T : unmanaged
    {
#if NET
        return Read(ref Unsafe.As<T, int>(ref part), Unsafe.SizeOf<T>() / sizeof(int));
#else
        return Read(MemoryMarshal.Cast<T, int>(MemoryMarshal.CreateReadOnlySpan(ref part, 1)));
#endif
    }

#if NET
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Read(ref int numbers, nint count)
    {
        int read = 0;
        for (nint i = 0; i < count; i += Numbers)
        {
            read ^= Unsafe.Add(ref numbers, i);
        }

        return read;
    }
#else
    private static int Read(ReadOnlySpan<int> numbers)
    {
        int read = 0;
        for (int i = 0; i < numbers.Length; i += Numbers)
        {
            read ^= numbers[i];
        }

        return read;
    }
#endif
}
