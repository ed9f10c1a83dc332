using System;
using System.Buffers.Binary;
using System.Numerics;
using System.Security.Cryptography;

namespace CreatureGen.Digest;

/// <summary>Hashes numbers by their bits, low bytes first.</summary>
internal sealed class BitHash(IncrementalHash hash)
{
    public void Add(int value)
    {
        Span<byte> bytes = stackalloc byte[sizeof(int)];
        BinaryPrimitives.WriteInt32LittleEndian(bytes, value);
        hash.AppendData(bytes);
    }

    public void Add(float value) => Add(BitConverter.SingleToInt32Bits(value));

    public void Add(Vector3 value)
    {
        Add(value.X);
        Add(value.Y);
        Add(value.Z);
    }

    public void Add(Quaternion value)
    {
        Add(value.X);
        Add(value.Y);
        Add(value.Z);
        Add(value.W);
    }
}
