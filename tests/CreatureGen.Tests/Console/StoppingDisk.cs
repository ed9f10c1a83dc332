using System;
using System.IO;
using System.Threading;
using CreatureGen.Console.Files;

namespace CreatureGen.Tests.Console;

/// <summary>The file system of the machine, which asks the program to stop in the very operation that makes a file one waits for, or gives it its name: however quick the machine is, what comes after is still to be done.</summary>
/// <param name="awaited">Whether a path is what one waits for; asked on the thread that makes it.</param>
internal sealed class StoppingDisk(Func<string, bool> awaited) : IDisk, IDisposable
{
    private readonly LocalDisk disk = new();
    private readonly CancellationTokenSource stop = new();

    public CancellationToken Token => stop.Token;

    public void MakeFolder(string path) => disk.MakeFolder(path);

    public Stream Create(string path)
    {
        Stream file = disk.Create(path);
        StopAt(path);
        return file;
    }

    public Stream Append(string path) => disk.Append(path);

    public Stream Hold(string path) => disk.Hold(path);

    public void Keep(Stream file) => disk.Keep(file);

    public void CopyPermissions(string from, string to) => disk.CopyPermissions(from, to);

    public void Rename(string from, string to)
    {
        disk.Rename(from, to);
        StopAt(to);
    }

    public void Delete(string path) => disk.Delete(path);

    public void Dispose() => stop.Dispose();

    private void StopAt(string path)
    {
        if (awaited(path))
        {
            stop.Cancel();
        }
    }
}
