using System;
using System.Globalization;
using System.IO;

namespace CreatureGen.Console.Files;

/// <summary>The open files of this process, on systems that list them below <c>/proc</c>.</summary>
internal static class DescriptorTable
{
    private const string Links = "/proc/self/fd";
    private const string Flags = "/proc/self/fdinfo";

    /// <summary>
    /// Whether the standard input is a pipe of this process itself. Where a program is started with a closed input, the runtime gets its number for a pipe of its own: nobody ever writes to it, and a read would wait for ever.
    /// </summary>
    public static bool HasOwnPipeAsInput()
    {
        try
        {
            string? input = Target(Links + "/0");
            if (input == null || !input.StartsWith("pipe:", StringComparison.Ordinal))
            {
                return false;
            }

            foreach (string link in Directory.EnumerateFileSystemEntries(Links))
            {
                string number = Path.GetFileName(link);
                if (number != "0" && Target(link) == input && IsForWriting(number))
                {
                    return true;
                }
            }
        }
        catch (Exception problem) when (problem is IOException or UnauthorizedAccessException)
        {
            // Elsewhere there is no such list, or nobody may read it.
        }

        return false;
    }

    private static string? Target(string link) => new FileInfo(link).LinkTarget;

    private static bool IsForWriting(string number)
    {
        foreach (string line in File.ReadLines(Path.Combine(Flags, number)))
        {
            // Octal; the last two bits are 0 for reading, 1 for writing, 2 for both.
            if (line.StartsWith("flags:", StringComparison.Ordinal))
            {
                return (int.Parse(line.AsSpan()[^1..], NumberStyles.None, CultureInfo.InvariantCulture) & 3) != 0;
            }
        }

        return false;
    }
}
