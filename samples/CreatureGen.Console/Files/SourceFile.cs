using System;
using System.IO;
using CreatureGen.Console.Arguments;

namespace CreatureGen.Console.Files;

/// <summary>Opens files that somebody named.</summary>
internal static class SourceFile
{
    /// <summary>Opens a file to be read.</summary>
    /// <param name="path">Where it is.</param>
    /// <param name="what">What it should be, for the message.</param>
    /// <exception cref="UsageError">It cannot be read.</exception>
    public static FileStream Open(string path, string what)
    {
        if (Directory.Exists(path))
        {
            throw new UsageError($"cannot read '{path}': it is a folder; expected {what}");
        }

        try
        {
            return new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read);
        }
        catch (Exception problem) when (Reason.IsOfFiles(problem))
        {
            throw new UsageError($"cannot read '{path}': {Reason.Of(problem)}; expected {what}");
        }
    }
}
