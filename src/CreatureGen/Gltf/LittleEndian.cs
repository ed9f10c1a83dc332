using System;
using System.Buffers.Binary;

namespace CreatureGen.Gltf;

/// <summary>Numbers as the bytes that glTF prescribes, the lowest first, on every machine.</summary>
internal static class LittleEndian
{
    /// <summary>Writes a float at <paramref name="at"/>; −0 is written as 0, so that equal numbers are equal bytes.</summary>
    public static void Write(Span<byte> bytes, int at, float value) =>
        BinaryPrimitives.WriteInt32LittleEndian(bytes.Slice(at, 4), BitConverter.SingleToInt32Bits(value + 0f));

    /// <summary>Writes an unsigned 16-bit integer at <paramref name="at"/>.</summary>
    public static void Write(Span<byte> bytes, int at, ushort value) => BinaryPrimitives.WriteUInt16LittleEndian(bytes.Slice(at, 2), value);

    /// <summary>Writes an unsigned 32-bit integer at <paramref name="at"/>.</summary>
    public static void Write(Span<byte> bytes, int at, uint value) => BinaryPrimitives.WriteUInt32LittleEndian(bytes.Slice(at, 4), value);

    /// <summary>Reads an unsigned 32-bit integer at <paramref name="at"/>.</summary>
    public static uint ReadUInt32(ReadOnlySpan<byte> bytes, int at) => BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(at, 4));
}
