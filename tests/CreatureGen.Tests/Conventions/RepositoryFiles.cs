using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace CreatureGen.Tests.Conventions;

/// <summary>The files of the repository as they lie in the folder it was cloned to, found upwards from that of the tests.</summary>
internal static class RepositoryFiles
{
    private static readonly string[] NotOurs = [".git", "bin", "obj", "node_modules", "TestResults", "artifacts", "BenchmarkDotNet.Artifacts", ".vs", ".idea", ".installing"];

    /// <summary>The folder that holds the solution.</summary>
    public static string Root { get; } = FindRoot();

    /// <summary>Paths below a folder, relative to the root, with forward slashes, in ordinal order; what is built or downloaded is left out.</summary>
    public static IReadOnlyList<string> Below(string folder, string pattern = "*")
    {
        var found = new List<string>();
        Collect(Path.Combine(Root, folder), pattern, found);
        found.Sort(StringComparer.Ordinal);
        return found;
    }

    /// <summary>The text of a file.</summary>
    public static string Text(string path) => File.ReadAllText(Path.Combine(Root, path));

    private static void Collect(string folder, string pattern, List<string> found)
    {
        found.AddRange(Directory.EnumerateFiles(folder, pattern).Where(f => !NotOurs.Contains(Path.GetFileName(f), StringComparer.Ordinal)).Select(f => Path.GetRelativePath(Root, f).Replace('\\', '/')));
        foreach (string inner in Directory.EnumerateDirectories(folder).Where(d => !NotOurs.Contains(Path.GetFileName(d), StringComparer.Ordinal)))
        {
            Collect(inner, pattern, found);
        }
    }

    private static string FindRoot()
    {
        for (string? folder = AppContext.BaseDirectory; folder != null; folder = Path.GetDirectoryName(folder))
        {
            if (File.Exists(Path.Combine(folder, "CreatureGen.sln")))
            {
                return folder;
            }
        }

        throw new DirectoryNotFoundException("no CreatureGen.sln above " + AppContext.BaseDirectory);
    }
}
