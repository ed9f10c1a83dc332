using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;

namespace CreatureGen.Console.Files;

/// <summary>
/// Files that appear whole or not at all: each is written under another name in the folder where it will be, and all get their names when all are written.
/// What was not given its name goes when the set is disposed of.
/// </summary>
internal sealed class FileSet : IDisposable
{
    // Where Unix keeps devices. Some can seek, so that they look like files, and none must be replaced by one.
    private const string Devices = "/dev/";

    private readonly List<(string Temporary, string Target, string Path)> staged = [];

    /// <summary>Writes one file, whole.</summary>
    /// <exception cref="WriteFailure">It cannot be written.</exception>
    public static void Write(string path, Action<Stream> content, CancellationToken cancellation)
    {
        using var files = new FileSet();
        files.Stage(path, content);
        files.Commit(cancellation);
    }

    /// <summary>Makes a folder and those that it is in.</summary>
    /// <exception cref="WriteFailure">It cannot be made.</exception>
    public static void MakeFolder(string path)
    {
        try
        {
            if (File.Exists(path))
            {
                throw WriteFailure.At(path, "there is a file of that name; expected a folder");
            }

            Directory.CreateDirectory(path);
        }
        catch (Exception problem) when (Reason.IsOfFiles(problem))
        {
            throw new WriteFailure($"cannot make the folder '{path}': {Reason.Of(problem)}", problem);
        }
    }

    /// <summary>Throws if a file could not be written to a place, as far as can be told before work begins.</summary>
    /// <exception cref="WriteFailure">It could not.</exception>
    public static void RequireWritable(string path)
    {
        using var files = new FileSet();
        files.Stage(path, _ => { });
    }

    /// <summary>Writes a file under another name.</summary>
    /// <exception cref="WriteFailure">It cannot be written.</exception>
    public void Stage(string path, Action<Stream> content)
    {
        try
        {
            string target = Target(path);
            string folder = Path.GetDirectoryName(target) ?? throw WriteFailure.At(path, "it is the root of a disk; expected a file");
            string temporary = Path.Combine(folder, $".creaturegen-{Guid.NewGuid():N}.tmp");
            using var stream = new FileStream(temporary, FileMode.CreateNew, FileAccess.Write, FileShare.None);
            staged.Add((temporary, target, path));
            content(stream);
        }
        catch (FileNotFoundException problem)
        {
            throw WriteFailure.At(path, "no file can be made there", problem);
        }
        catch (Exception problem) when (Reason.IsOfFiles(problem))
        {
            throw WriteFailure.At(path, Reason.Of(problem), problem);
        }
    }

    /// <summary>Gives all files their names; those that had them before are replaced.</summary>
    /// <exception cref="WriteFailure">One cannot be put in its place.</exception>
    /// <exception cref="OperationCanceledException">The work was stopped; nothing has changed.</exception>
    public void Commit(CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        while (staged.Count > 0)
        {
            (string temporary, string target, string path) = staged[0];
            try
            {
                File.Move(temporary, target, overwrite: true);
            }
            catch (Exception problem) when (Reason.IsOfFiles(problem))
            {
                throw WriteFailure.At(path, Reason.Of(problem), problem);
            }

            staged.RemoveAt(0);
        }
    }

    /// <summary>Removes what was not given its name.</summary>
    public void Dispose()
    {
        foreach ((string temporary, _, _) in staged)
        {
            try
            {
                File.Delete(temporary);
            }
            catch (Exception problem) when (Reason.IsOfFiles(problem))
            {
                // The failure that led here says more than this one.
            }
        }

        staged.Clear();
    }

    /// <summary>The place behind a path: a link stays a link. What is there must be a file that may be written, for a renaming asks no permission of it.</summary>
    private static string Target(string path)
    {
        if (Directory.Exists(path))
        {
            throw WriteFailure.At(path, "there is a folder of that name; expected a file");
        }

        if (!File.Exists(path))
        {
            return path;
        }

        if (path.StartsWith(Devices, StringComparison.Ordinal))
        {
            throw WriteFailure.At(path, "it is a device; expected a file");
        }

        string target = File.ResolveLinkTarget(path, returnFinalTarget: true)?.FullName ?? path;
        if ((File.GetAttributes(target) & FileAttributes.ReadOnly) != 0)
        {
            throw WriteFailure.At(path, "the file is read-only");
        }

        using var stream = new FileStream(target, FileMode.Open, FileAccess.ReadWrite, FileShare.ReadWrite | FileShare.Delete);
        return stream.CanSeek && !target.StartsWith(Devices, StringComparison.Ordinal) ? target : throw WriteFailure.At(path, "it is a device; expected a file");
    }
}
