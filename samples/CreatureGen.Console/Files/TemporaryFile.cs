using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;

namespace CreatureGen.Console.Files;

/// <summary>The names of files that are not finished. A name tells machine and process, so that what a killed process left can be told from what another one is writing.</summary>
internal static class TemporaryFile
{
    private const string Pattern = ".creaturegen-*.tmp";

    // After that nobody is still writing, on whatever machine.
    private static readonly TimeSpan longest = TimeSpan.FromDays(1);

    private static readonly string run = Guid.NewGuid().ToString("N");

    private static long count;

    /// <summary>A new name in a folder.</summary>
    public static string In(string folder) =>
        Path.Combine(folder, string.Create(CultureInfo.InvariantCulture, $".creaturegen-{Machine}-{Environment.ProcessId}-{run}-{System.Threading.Interlocked.Increment(ref count)}.tmp"));

    /// <summary>Removes from a folder what processes that have ended left unfinished there. Never fails: what cannot be removed stays.</summary>
    public static void RemoveStale(string folder, IDisk disk)
    {
        try
        {
            foreach (string path in Directory.EnumerateFiles(folder, Pattern, new EnumerationOptions { AttributesToSkip = 0 }))
            {
                if (IsStale(Path.GetFileName(path), DateTime.UtcNow - File.GetLastWriteTimeUtc(path)))
                {
                    disk.Delete(path);
                }
            }
        }
        catch (Exception problem) when (Reason.IsOfFiles(problem))
        {
            // Tidying up must not keep anybody from work.
        }
    }

    /// <summary>Whether nobody is writing a file any more.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="age">Time since it was last written to.</param>
    public static bool IsStale(string name, TimeSpan age)
    {
        if (age > longest)
        {
            return true;
        }

        string[] parts = name.Split('-', '.');
        return parts.Length == 7 && parts[2] == Machine && parts[4] != run
            && int.TryParse(parts[3], NumberStyles.None, CultureInfo.InvariantCulture, out int process)
            && (process == Environment.ProcessId || !IsAlive(process));
    }

    /// <summary>The machine or container, as eight hexadecimal digits of its name (FNV-1a).</summary>
    private static string Machine
    {
        get
        {
            uint hash = 2166136261;
            foreach (char c in Environment.MachineName)
            {
                hash = (hash ^ c) * 16777619;
            }

            return hash.ToString("x8", CultureInfo.InvariantCulture);
        }
    }

    private static bool IsAlive(int process)
    {
        try
        {
            using Process found = Process.GetProcessById(process);
            return true;
        }
        catch (Exception problem) when (problem is ArgumentException or InvalidOperationException)
        {
            return false;
        }
    }
}
