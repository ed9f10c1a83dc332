using System;
using System.IO;
using CreatureGen.Console.Arguments;

namespace CreatureGen.Console.Files;

/// <summary>Opens files that somebody named.</summary>
internal static class SourceFile
{
    // A creature's file is far smaller; a pipe that never ends must not take all memory.
    private const int MaxPiped = 1 << 29;

    /// <summary>Opens a file to be read, from its beginning. What can be read only once, as pipes can, is read into memory.</summary>
    /// <param name="path">Where it is; <c>-</c> is the standard input.</param>
    /// <param name="what">What it should be, for the message.</param>
    /// <param name="surroundings">Has the standard input.</param>
    /// <returns>A stream that can seek.</returns>
    /// <exception cref="UsageError">It cannot be read.</exception>
    public static Stream Open(string path, string what, Surroundings surroundings)
    {
        if (Directory.Exists(path))
        {
            throw new UsageError($"cannot read '{path}': it is a folder; expected {what}");
        }

        try
        {
            Stream stream = path == Surroundings.Standard ? surroundings.Input() : new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read);
            return stream.CanSeek && stream is FileStream ? stream : InMemory(stream, path, what);
        }
        catch (Exception problem) when (Reason.IsOfFiles(problem))
        {
            throw new UsageError($"cannot read '{path}': {Reason.Of(problem)}; expected {what}");
        }
    }

    private static MemoryStream InMemory(Stream stream, string path, string what)
    {
        using Stream source = stream;
        var content = new MemoryStream();
        byte[] part = new byte[1 << 16];
        for (int read = source.Read(part); read > 0; read = source.Read(part))
        {
            if (content.Length + read > MaxPiped)
            {
                throw new UsageError($"cannot read '{path}': it is longer than {MaxPiped >> 20} MiB; expected {what}");
            }

            content.Write(part, 0, read);
        }

        content.Position = 0;
        return content;
    }
}
