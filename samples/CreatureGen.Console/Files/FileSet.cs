using System;
using System.Collections.Generic;
using System.IO;

namespace CreatureGen.Console.Files;

/// <summary>
/// Files that appear whole or not at all: each is written under another name in the folder where it will be, and all get their names when all are written and, unless <see cref="Surroundings.Durability"/> says otherwise, on the disk.
/// What was not given its name goes when the set is disposed of. The path <c>-</c> is the standard output, which gets everything at the end too.
/// </summary>
internal sealed class FileSet(Surroundings surroundings) : IDisposable
{
    // Where Unix keeps devices. Some can seek, so that they look like files, and none must be replaced by one.
    private const string Devices = "/dev/";

    private readonly IDisk disk = surroundings.Disk;
    private readonly List<Staged> staged = [];

    /// <summary>Writes one file, whole.</summary>
    /// <exception cref="WriteFailure">It cannot be written.</exception>
    /// <exception cref="OperationCanceledException">The work was stopped; nothing has changed.</exception>
    public static void Write(string path, Action<Stream> content, Surroundings surroundings)
    {
        using var files = new FileSet(surroundings);
        files.Stage(path, content);
        files.Commit();
    }

    /// <summary>Makes a folder and those that it is in, and removes from it what killed runs left unfinished.</summary>
    /// <exception cref="WriteFailure">It cannot be made.</exception>
    public static void MakeFolder(string path, Surroundings surroundings)
    {
        try
        {
            if (File.Exists(path))
            {
                throw WriteFailure.At(path, "there is a file of that name; expected a folder");
            }

            surroundings.Disk.MakeFolder(path);
        }
        catch (Exception problem) when (Reason.IsOfFiles(problem))
        {
            throw new WriteFailure($"cannot make the folder '{path}': {Reason.Of(problem)}", problem);
        }

        TemporaryFile.RemoveStale(path, surroundings.Disk);
    }

    /// <summary>Throws if a file could not be written to a place, as far as can be told before work begins. Removes from its folder what killed runs left unfinished.</summary>
    /// <exception cref="WriteFailure">It could not.</exception>
    public static void RequireWritable(string path, Surroundings surroundings)
    {
        using var files = new FileSet(surroundings);
        files.Stage(path, _ => { });
        if (path != Surroundings.Standard)
        {
            TemporaryFile.RemoveStale(Path.GetDirectoryName(path)!, surroundings.Disk);
        }
    }

    /// <summary>Writes a file under another name.</summary>
    /// <exception cref="WriteFailure">It cannot be written.</exception>
    public void Stage(string path, Action<Stream> content)
    {
        if (path == Surroundings.Standard)
        {
            var data = new MemoryStream();
            content(data);
            staged.Add(new Staged("", path, path, data));
            return;
        }

        try
        {
            string target = Target(path);
            string folder = Path.GetDirectoryName(target) ?? throw WriteFailure.At(path, "it is the root of a disk; expected a file");
            string temporary = TemporaryFile.In(folder);
            staged.Add(new Staged(temporary, target, path, null));
            using Stream stream = disk.Create(temporary);
            content(stream);
            if (surroundings.Durability == Durability.OnDisk)
            {
                disk.Keep(stream);
            }

            if (File.Exists(target))
            {
                disk.CopyPermissions(target, temporary);
            }
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
    public void Commit()
    {
        surroundings.Cancellation.ThrowIfCancellationRequested();
        while (staged.Count > 0)
        {
            Staged file = staged[0];
            try
            {
                if (file.Data != null)
                {
                    file.Data.WriteTo(surroundings.Data);
                    surroundings.Data.Flush();
                }
                else
                {
                    disk.Rename(file.Temporary, file.Target);
                }
            }
            catch (Exception problem) when (Reason.IsOfFiles(problem))
            {
                throw WriteFailure.At(file.Path, Reason.Of(problem), problem);
            }

            staged.RemoveAt(0);
        }
    }

    /// <summary>Removes what was not given its name.</summary>
    public void Dispose()
    {
        foreach (Staged file in staged)
        {
            try
            {
                if (file.Data == null)
                {
                    disk.Delete(file.Temporary);
                }
            }
            catch (Exception problem) when (Reason.IsOfFiles(problem))
            {
                // The failure that led here says more than this one; a later run removes the file.
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

    /// <summary>A file that waits for its name.</summary>
    /// <param name="Temporary">The name that it has.</param>
    /// <param name="Target">The name that it will have.</param>
    /// <param name="Path">What somebody typed.</param>
    /// <param name="Data">What goes to the standard output instead.</param>
    private sealed record Staged(string Temporary, string Target, string Path, MemoryStream? Data);
}
