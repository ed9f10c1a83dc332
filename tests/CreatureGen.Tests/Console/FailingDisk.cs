using System;
using System.IO;
using CreatureGen.Console.Files;

namespace CreatureGen.Tests.Console;

/// <summary>The file system of the machine, but for one operation that fails as on a full disk: the one of a given number, counted from 1. Tidying up afterwards works.</summary>
internal sealed class FailingDisk(int failsAt) : IDisk
{
    private readonly LocalDisk disk = new();

    /// <summary>Operations until now.</summary>
    public int Count { get; private set; }

    public void MakeFolder(string path)
    {
        Step();
        disk.MakeFolder(path);
    }

    public Stream Create(string path)
    {
        Step();
        return new Written(disk.Create(path), this);
    }

    public Stream Append(string path)
    {
        Step();
        return new Written(disk.Append(path), this);
    }

    public Stream Hold(string path)
    {
        Step();
        return new Written(disk.Hold(path), this);
    }

    public void Keep(Stream file)
    {
        Step();
        disk.Keep(((Written)file).Inner);
    }

    public void CopyPermissions(string from, string to)
    {
        Step();
        disk.CopyPermissions(from, to);
    }

    public void Rename(string from, string to)
    {
        Step();
        disk.Rename(from, to);
    }

    public void Delete(string path) => disk.Delete(path);

    private void Step()
    {
        if (++Count == failsAt)
        {
            throw new IOException("no space left on device", 28);
        }
    }

    /// <summary>A file of which each write is an operation.</summary>
    private sealed class Written(Stream inner, FailingDisk disk) : Stream
    {
        public Stream Inner => inner;

        public override bool CanRead => false;

        public override bool CanSeek => inner.CanSeek;

        public override bool CanWrite => true;

        public override long Length => inner.Length;

        public override long Position
        {
            get => inner.Position;
            set => inner.Position = value;
        }

        public override void Flush() => inner.Flush();

        public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

        public override long Seek(long offset, SeekOrigin origin) => inner.Seek(offset, origin);

        public override void SetLength(long value) => inner.SetLength(value);

        public override void Write(byte[] buffer, int offset, int count)
        {
            disk.Step();
            inner.Write(buffer, offset, count);
        }

        protected override void Dispose(bool disposing) => inner.Dispose();
    }
}
