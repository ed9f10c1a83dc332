using System;
using System.Collections.Generic;

namespace CreatureGen.Gltf;

/// <summary>Where every accessor lies in the binary chunk: one after the other, each in a buffer view of its own that starts at a multiple of four bytes.</summary>
internal sealed class BufferPlan
{
    private readonly List<Accessor> accessors = new();

    /// <summary>All accessors in the order of their numbers and of their bytes.</summary>
    public IReadOnlyList<Accessor> Accessors => accessors;

    /// <summary>Bytes of the binary chunk with all padding.</summary>
    public int ByteLength { get; private set; }

    /// <summary>Appends an accessor of <paramref name="count"/> elements.</summary>
    /// <exception cref="InvalidOperationException">The chunk would be longer than an array can be.</exception>
    public Accessor Add(ElementShape shape, ComponentFormat format, int count, BufferTarget target)
    {
        long end = ByteLength + ((long)count * Accessor.ElementSize(shape, format));
        if (end > int.MaxValue - 3)
        {
            throw ExportError.At("the mesh", FormattableString.Invariant($"its buffers need {end} bytes"), "less than 2 GiB");
        }

        var accessor = new Accessor(accessors.Count, ByteLength, count, shape, format, target);
        accessors.Add(accessor);
        ByteLength = Align((int)end);
        return accessor;
    }

    /// <summary>The next multiple of four.</summary>
    public static int Align(int bytes) => (bytes + 3) & ~3;

    /// <summary>The bytes of an accessor in the binary chunk.</summary>
    public static Span<byte> Bytes(Accessor accessor, Span<byte> binary) => binary.Slice(accessor.Offset, accessor.ByteLength);

    /// <summary>Zeroes the bytes between the accessors.</summary>
    public void Pad(Span<byte> binary)
    {
        foreach (Accessor accessor in accessors)
        {
            int end = accessor.Offset + accessor.ByteLength;
            binary.Slice(end, Align(end) - end).Clear();
        }
    }
}
