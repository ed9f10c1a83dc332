using System;
using System.IO;
using CreatureGen.Png;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Preview.Png;

/// <summary>
/// Writes moving pictures as animated PNG (PNG Third Edition, acTL, fcTL and fdAT chunks), frame by frame, the same bytes on every platform.
/// Viewers that know no animation show the first frame.
/// </summary>
/// <remarks>Of each frame after the first only the rectangle that changed is stored.</remarks>
public sealed class AnimatedPngWriter
{
    private readonly Stream stream;
    private readonly int frames;
    private readonly int millisecondsPerFrame;
    private Picture? last;
    private int written;
    private uint sequence;

    /// <summary>Starts a file on <paramref name="stream"/>, which stays open at the end.</summary>
    /// <param name="stream">Where to write.</param>
    /// <param name="frames">Number of frames that will be added, at least 1.</param>
    /// <param name="millisecondsPerFrame">How long a frame shows, 1..65535.</param>
    /// <exception cref="ArgumentException">The stream cannot be written.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public AnimatedPngWriter(Stream stream, int frames, int millisecondsPerFrame)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentOutOfRangeException.ThrowIfLessThan(frames, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(millisecondsPerFrame, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(millisecondsPerFrame, ushort.MaxValue);
        if (!stream.CanWrite)
        {
            throw new ArgumentException("the stream cannot be written; expected one that can", nameof(stream));
        }

        this.stream = stream;
        this.frames = frames;
        this.millisecondsPerFrame = millisecondsPerFrame;
    }

    /// <summary>Adds the next frame and, with the last, ends the file. The picture must not change before the next frame has been added.</summary>
    /// <exception cref="ArgumentException">The frame differs from the first in size or layout.</exception>
    /// <exception cref="InvalidOperationException">All frames have been added.</exception>
    public void Add(Picture frame)
    {
        ArgumentNullException.ThrowIfNull(frame);
        if (written == frames)
        {
            throw new InvalidOperationException(FormattableString.Invariant($"frame {written + 1} of {frames}; expected no more"));
        }

        if (last is not null && (frame.Width != last.Width || frame.Height != last.Height || frame.Layout != last.Layout))
        {
            throw new ArgumentException(
                FormattableString.Invariant($"frame {written + 1} is {frame.Width} × {frame.Height} {frame.Layout}; expected {last.Width} × {last.Height} {last.Layout} like the first"), nameof(frame));
        }

        int left = 0;
        int top = 0;
        int width = frame.Width;
        int height = frame.Height;
        if (last is null)
        {
            PngChunks.WriteStart(stream, width, height, frame.Layout == PixelLayout.Rgb ? PngPixels.Rgb : PngPixels.Rgba);
            Span<byte> control = stackalloc byte[8];
            PngChunks.PutBigEndian(control, (uint)frames);
            PngChunks.PutBigEndian(control[4..], 0);
            PngChunks.Write(stream, "acTL"u8, control, default);
        }
        else
        {
            FindChange(last, frame, out left, out top, out width, out height);
        }

        WriteFrameControl(left, top, width, height);
        ReadOnlySpan<byte> bytes = frame.Bytes[((top * frame.Stride) + (left * frame.BytesPerPixel))..];
        using BitSink packed = PngFilter.Compress(bytes, frame.Stride, width * frame.BytesPerPixel, height, frame.BytesPerPixel);
        if (last is null)
        {
            PngChunks.Write(stream, "IDAT"u8, packed.Bytes, default);
        }
        else
        {
            Span<byte> number = stackalloc byte[4];
            PngChunks.PutBigEndian(number, sequence++);
            PngChunks.Write(stream, "fdAT"u8, number, packed.Bytes);
        }

        last = frame;
        written++;
        if (written == frames)
        {
            PngChunks.WriteEnd(stream);
        }
    }

    private static void FindChange(Picture before, Picture after, out int left, out int top, out int width, out int height)
    {
        int stride = before.Stride;
        top = 0;
        int bottom = before.Height - 1;
        while (top < bottom && RowsEqual(before, after, top))
        {
            top++;
        }

        while (bottom > top && RowsEqual(before, after, bottom))
        {
            bottom--;
        }

        int first = stride - 1;
        int final = 0;
        for (int y = top; y <= bottom; y++)
        {
            ReadOnlySpan<byte> a = before.Bytes.Slice(y * stride, stride);
            ReadOnlySpan<byte> b = after.Bytes.Slice(y * stride, stride);
            int same = a.CommonPrefixLength(b);
            if (same == stride)
            {
                continue;
            }

            first = Math.Min(first, same);
            int end = stride - 1;
            while (end > final && a[end] == b[end])
            {
                end--;
            }

            final = Math.Max(final, end);
        }

        left = Math.Min(first, final) / before.BytesPerPixel;
        width = (Math.Max(first, final) / before.BytesPerPixel) - left + 1;
        if (first > final)
        {
            left = 0;
            width = 1;
        }

        height = bottom - top + 1;
    }

    private static bool RowsEqual(Picture a, Picture b, int y) =>
        a.Bytes.Slice(y * a.Stride, a.Stride).SequenceEqual(b.Bytes.Slice(y * a.Stride, a.Stride));

    private void WriteFrameControl(int left, int top, int width, int height)
    {
        Span<byte> control = stackalloc byte[26];
        PngChunks.PutBigEndian(control, sequence++);
        PngChunks.PutBigEndian(control[4..], (uint)width);
        PngChunks.PutBigEndian(control[8..], (uint)height);
        PngChunks.PutBigEndian(control[12..], (uint)left);
        PngChunks.PutBigEndian(control[16..], (uint)top);
        control[20] = (byte)(millisecondsPerFrame >> 8);
        control[21] = (byte)millisecondsPerFrame;
        control[22] = 1000 >> 8;
        control[23] = 1000 & 0xFF;

        // Leave the frame as it is, and replace pixels rather than draw over them.
        control[24] = 0;
        control[25] = 0;
        PngChunks.Write(stream, "fcTL"u8, control, default);
    }
}
