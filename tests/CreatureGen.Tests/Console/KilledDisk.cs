using System.IO;
using CreatureGen.Console.Files;

namespace CreatureGen.Tests.Console;

/// <summary>The file system as a process sees it that is killed in the operation of a given number, counted from 1: nothing that it does then or later happens, and nothing is tidied up. Of a write the first half still arrives.</summary>
internal sealed class KilledDisk(int diesAt) : IDisk
{
    private readonly LocalDisk disk = new();
    private int count;

    public bool IsDead => count >= diesAt;

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

    public void Delete(string path)
    {
        if (!IsDead)
        {
            disk.Delete(path);
        }
    }

    private void Step()
    {
        count++;
        if (IsDead)
        {
            throw new IOException("killed");
        }
    }

    private sealed class Written(Stream inner, KilledDisk disk) : Stream
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

        public override int Read(byte[] buffer, int offset, int count) => inner.Read(buffer, offset, count);

        public override long Seek(long offset, SeekOrigin origin) => inner.Seek(offset, origin);

        public override void SetLength(long value) => inner.SetLength(value);

        public override void Write(byte[] buffer, int offset, int count)
        {
            if (disk.count == disk.Last)
            {
                inner.Write(buffer, offset, count / 2);
            }

            disk.Step();
            inner.Write(buffer, offset, count);
        }

        protected override void Dispose(bool disposing) => inner.Dispose();
    }

    private int Last => diesAt - 1;
}
