using System;
using System.Buffers;
using System.Buffers.Binary;

namespace CreatureGen.Png;

/// <summary>Collects bits into bytes, lowest bit first, as deflate packs them; the bytes lie in memory borrowed from the pool.</summary>
internal sealed class BitSink : IDisposable
{
    // What the runtime allows for arrays of bytes.
    private const int LongestArray = 0x7FFFFFC7;

    private byte[] bytes;
    private int count;
    private ulong pending;
    private int pendingBits;

    public BitSink(int capacity) => bytes = ArrayPool<byte>.Shared.Rent(Math.Max(64, capacity));

    /// <summary>All whole bytes so far; gone when this is disposed of.</summary>
    public ReadOnlySpan<byte> Bytes => bytes.AsSpan(0, count);

    /// <summary>Makes room for so many bits more, which <see cref="Write"/> takes for granted.</summary>
    public void Reserve(long bits) => ReserveBytes(checked((int)((bits + 7) / 8) + sizeof(ulong)));

    /// <summary>Appends the lowest <paramref name="length"/> bits (at most 56), whose higher bits are zero, where room is reserved for them.</summary>
    public void Write(ulong bits, int length)
    {
        // Eight bytes are stored, of which those count that are whole: the others are stored again with what follows.
        pending |= bits << pendingBits;
        pendingBits += length;
        BinaryPrimitives.WriteUInt64LittleEndian(bytes.AsSpan(count), pending);
        count += pendingBits >> 3;
        pending >>= pendingBits & ~7;
        pendingBits &= 7;
    }

    /// <summary>Fills the last byte with zero bits.</summary>
    public void Align()
    {
        ReserveBytes(8);
        while (pendingBits > 0)
        {
            bytes[count++] = (byte)pending;
            pending >>= 8;
            pendingBits -= 8;
        }

        pending = 0;
        pendingBits = 0;
    }

    /// <summary>Appends whole bytes; the sink must be aligned.</summary>
    public void Append(ReadOnlySpan<byte> more)
    {
        ReserveBytes(more.Length);
        more.CopyTo(bytes.AsSpan(count));
        count += more.Length;
    }

    /// <summary>Appends a number of four bytes, highest first; the sink must be aligned.</summary>
    public void AppendBigEndian(uint value) =>
        Append([(byte)(value >> 24), (byte)(value >> 16), (byte)(value >> 8), (byte)value]);

    /// <summary>Gives the memory back.</summary>
    public void Dispose()
    {
        if (bytes.Length > 0)
        {
            ArrayPool<byte>.Shared.Return(bytes);
            bytes = Array.Empty<byte>();
            count = 0;
        }
    }

    private void ReserveBytes(int more)
    {
        if (bytes.Length - count < more)
        {
            byte[] larger = ArrayPool<byte>.Shared.Rent(Math.Max(checked(count + more), (int)Math.Min(LongestArray, bytes.Length * 2L)));
            Bytes.CopyTo(larger);
            ArrayPool<byte>.Shared.Return(bytes);
            bytes = larger;
        }
    }
}
