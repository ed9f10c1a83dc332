using System;
using System.Collections.Generic;

namespace CreatureGen.Gltf;

/// <summary>Where every accessor lies in the binary chunk: one after the other, each in a buffer view of its own that starts at a multiple of four bytes.</summary>
internal sealed class BufferPlan
{
    private readonly List<Accessor> accessors = new();
    private readonly List<(int Offset, int ByteLength)> blocks = new();

    /// <summary>All accessors in the order of their numbers and of their bytes.</summary>
    public IReadOnlyList<Accessor> Accessors => accessors;

    /// <summary>Blocks of bytes that are no accessors, behind all accessors; their buffer views follow those of the accessors.</summary>
    public IReadOnlyList<(int Offset, int ByteLength)> Blocks => blocks;

    /// <summary>Bytes of the binary chunk with all padding.</summary>
    public int ByteLength { get; private set; }

    /// <summary>Appends an accessor of <paramref name="count"/> elements.</summary>
    /// <exception cref="InvalidOperationException">The chunk would be longer than an array can be.</exception>
    public Accessor Add(ElementShape shape, ComponentFormat format, int count, BufferTarget target)
    {
        var accessor = new Accessor(accessors.Count, ByteLength, count, shape, format, target);
        accessors.Add(accessor);
        Extend((long)count * Accessor.ElementSize(shape, format));
        return accessor;
    }

    /// <summary>Appends a block of bytes; no accessor may follow it.</summary>
    /// <exception cref="InvalidOperationException">The chunk would be longer than an array can be.</exception>
    public void AddBlock(int byteLength)
    {
        blocks.Add((ByteLength, byteLength));
        Extend(byteLength);
    }

    /// <summary>The next multiple of four.</summary>
    public static int Align(int bytes) => (bytes + 3) & ~3;

    /// <summary>The bytes of an accessor in the binary chunk.</summary>
    public static Span<byte> Bytes(Accessor accessor, Span<byte> binary) => binary.Slice(accessor.Offset, accessor.ByteLength);

    /// <summary>Zeroes the bytes between the accessors and blocks.</summary>
    public void Pad(Span<byte> binary)
    {
        foreach (Accessor accessor in accessors)
        {
            int end = accessor.Offset + accessor.ByteLength;
            binary.Slice(end, Align(end) - end).Clear();
        }

        foreach ((int offset, int byteLength) in blocks)
        {
            int end = offset + byteLength;
            binary.Slice(end, Align(end) - end).Clear();
        }
    }

    private void Extend(long bytes)
    {
        long end = ByteLength + bytes;
        if (end > int.MaxValue - 3)
        {
            throw ExportError.At("the mesh", FormattableString.Invariant($"its buffers need {end} bytes"), "less than 2 GiB");
        }

        ByteLength = Align((int)end);
    }
}
