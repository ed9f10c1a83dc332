using System;
using System.IO;

namespace CreatureGen.Console.Files;

/// <summary>The streams that a program is started with. Any of them may be closed, or may be a pipe whose reader has gone.</summary>
internal static class StandardStreams
{
    /// <summary>Takes data. What it cannot write it refuses as a <see cref="WriteFailure"/>.</summary>
    public static Stream Output() => new Checked(Open(System.Console.OpenStandardOutput), Refuse);

    /// <summary>Takes complaints. What it cannot write is lost: there is nobody to tell.</summary>
    public static Stream Error() => new Checked(Open(System.Console.OpenStandardError), _ => { });

    /// <summary>Gives data.</summary>
    /// <exception cref="IOException">It is closed.</exception>
    public static Stream Input() => DescriptorTable.HasOwnPipeAsInput() ? throw new IOException("the standard input is closed") : System.Console.OpenStandardInput();

    private static Lazy<Stream> Open(Func<Stream> open) => new(open);

    private static void Refuse(Exception problem) => throw new WriteFailure("cannot write to the standard output: " + Reason.Of(problem), problem);

    /// <summary>A stream to write to, opened when it is first needed, that hands over its failures.</summary>
    private sealed class Checked(Lazy<Stream> stream, Action<Exception> onFailure) : Stream
    {
        public override bool CanRead => false;

        public override bool CanSeek => false;

        public override bool CanWrite => true;

        public override long Length => throw new NotSupportedException();

        public override long Position
        {
            get => throw new NotSupportedException();
            set => throw new NotSupportedException();
        }

        public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

        public override void Write(ReadOnlySpan<byte> buffer)
        {
            try
            {
                stream.Value.Write(buffer);
            }
            catch (Exception problem) when (Reason.IsOfFiles(problem))
            {
                onFailure(problem);
            }
        }

        public override void Flush()
        {
            try
            {
                if (stream.IsValueCreated)
                {
                    stream.Value.Flush();
                }
            }
            catch (Exception problem) when (Reason.IsOfFiles(problem))
            {
                onFailure(problem);
            }
        }

        public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();
    }
}
