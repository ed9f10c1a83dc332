using System;
using System.IO;

namespace CreatureGen.Console.Files;

/// <summary>The file system of the machine.</summary>
internal sealed class LocalDisk : IDisk
{
    /// <inheritdoc/>
    public void MakeFolder(string path) => Directory.CreateDirectory(path);

    /// <inheritdoc/>
    public Stream Create(string path) => new FileStream(path, FileMode.CreateNew, FileAccess.Write, FileShare.None);

    /// <inheritdoc/>
    public Stream Append(string path) => OpenAtEnd(path, FileShare.Read);

    /// <inheritdoc/>
    public Stream Hold(string path) => OpenAtEnd(path, FileShare.None);

    /// <inheritdoc/>
    public void Keep(Stream file)
    {
        ((FileStream)file).Flush(flushToDisk: true);
        file.Dispose();
    }

    /// <inheritdoc/>
    public void CopyPermissions(string from, string to)
    {
        if (!OperatingSystem.IsWindows())
        {
            File.SetUnixFileMode(to, File.GetUnixFileMode(from));
        }
    }

    /// <inheritdoc/>
    public void Rename(string from, string to) => File.Move(from, to, overwrite: true);

    /// <inheritdoc/>
    public void Delete(string path) => File.Delete(path);

    private static FileStream OpenAtEnd(string path, FileShare share)
    {
        var file = new FileStream(path, FileMode.OpenOrCreate, FileAccess.Write, share, bufferSize: 0);
        file.Seek(0, SeekOrigin.End);
        return file;
    }
}
