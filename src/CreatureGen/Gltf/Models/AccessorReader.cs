using System;
using System.Buffers.Binary;
using CreatureGen.Json;

namespace CreatureGen.Gltf.Models;

/// <summary>Numbers of accessors, with every offset and count proved against the bytes that are there.</summary>
/// <remarks>Component types, normalised integers, strides and sparse accessors after: Khronos Group, "glTF 2.0 Specification" (2021), section 3.6.</remarks>
internal readonly struct AccessorReader
{
    /// <summary>Most numbers that one accessor may hold: more than any character needs, and too few to exhaust memory.</summary>
    private const int MaxNumbers = 1 << 25;

    private readonly ModelDocument document;

    public AccessorReader(ModelDocument document) => this.document = document;

    /// <summary>The numbers of an accessor, element after element; normalised integers as fractions.</summary>
    /// <param name="index">Number of the accessor, where the document says it.</param>
    /// <param name="type">Its type, as <c>VEC3</c>.</param>
    public float[] Floats(JsonValue index, string type)
    {
        JsonValue accessor = Of(index, type, out int count, out int width);
        int component = Component(accessor);
        bool normalised = ModelDocument.Find(accessor, "normalized")?.IsTrue ?? false;
        float[] numbers = new float[count * width];
        if (ModelDocument.Find(accessor, "bufferView") is { } view)
        {
            ReadOnlySpan<byte> bytes = View(view, out int stride);
            int offset = ModelDocument.Whole(accessor, "byteOffset", 0);
            RequireRoom(accessor, bytes.Length, offset, stride, count, width * SizeOf(component));
            Read(accessor, bytes, offset, stride == 0 ? width * SizeOf(component) : stride, component, normalised, width, numbers);
        }

        if (ModelDocument.Find(accessor, "sparse") is { } sparse)
        {
            Replace(accessor, sparse, component, normalised, width, numbers);
        }

        return numbers;
    }

    /// <summary>The whole numbers of an accessor, element after element.</summary>
    public int[] Integers(JsonValue index, string type)
    {
        JsonValue accessor = document.At("accessors", index);
        int component = Component(accessor);
        if (component == Float)
        {
            throw ModelFault.At(ModelDocument.Need(accessor, "componentType", "a type"), "5121, 5123 or 5125 (whole numbers)");
        }

        float[] numbers = Floats(index, type);
        int[] whole = new int[numbers.Length];
        for (int i = 0; i < whole.Length; i++)
        {
            // Above 2²⁴ single precision would lose whole numbers; no index of a bounded accessor is as large.
            whole[i] = numbers[i] >= 0f && numbers[i] < 1 << 24 ? (int)numbers[i] : throw new ModelFault(accessor.Path, FormattableString.Invariant($"{numbers[i]}"), "indices below 2^24");
        }

        return whole;
    }

    private const int Float = 5126;

    private static int SizeOf(int component) => component switch { 5120 or 5121 => 1, 5122 or 5123 => 2, _ => 4 };

    private static int Component(JsonValue accessor)
    {
        JsonValue value = ModelDocument.Need(accessor, "componentType", "5120 to 5126");
        int component = ModelDocument.Whole(value, ushort.MaxValue);
        return component is >= 5120 and <= 5126 and not 5124 ? component : throw ModelFault.At(value, "5120, 5121, 5122, 5123, 5125 or 5126");
    }

    private JsonValue Of(JsonValue index, string type, out int count, out int width)
    {
        JsonValue accessor = document.At("accessors", index);
        JsonValue given = ModelDocument.Need(accessor, "type", type);
        if (given.Text != type)
        {
            throw ModelFault.At(given, type);
        }

        width = type switch { "SCALAR" => 1, "VEC2" => 2, "VEC3" => 3, "VEC4" => 4, _ => 16 };
        count = ModelDocument.Whole(ModelDocument.Need(accessor, "count", "a number of elements"), MaxNumbers / width);
        return accessor;
    }

    private ReadOnlySpan<byte> View(JsonValue index, out int stride)
    {
        JsonValue view = document.At("bufferViews", index);
        JsonValue buffer = ModelDocument.Need(view, "buffer", "a buffer");
        JsonValue described = document.At("buffers", buffer);
        if (ModelDocument.Whole(buffer, int.MaxValue) != 0 || ModelDocument.Find(described, "uri") != null)
        {
            throw ModelFault.At(buffer, "buffer 0, the binary chunk of the file");
        }

        int offset = ModelDocument.Whole(view, "byteOffset", 0);
        int length = ModelDocument.Whole(ModelDocument.Need(view, "byteLength", "a length"), int.MaxValue);
        stride = ModelDocument.Whole(view, "byteStride", 0);
        if ((long)offset + length > document.Binary.Length)
        {
            throw new ModelFault(view.Path, FormattableString.Invariant($"bytes {offset} to {(long)offset + length}"), FormattableString.Invariant($"within the {document.Binary.Length} of the binary chunk"));
        }

        return document.Binary.AsSpan(offset, length);
    }

    private static void RequireRoom(JsonValue accessor, int length, int offset, int stride, int count, int size)
    {
        long end = offset + (count == 0 ? 0 : ((long)(count - 1) * (stride == 0 ? size : stride)) + size);
        if (end > length || (stride != 0 && stride < size))
        {
            throw new ModelFault(accessor.Path, FormattableString.Invariant($"{count} elements of {size} bytes from byte {offset} on, {stride} apart"), FormattableString.Invariant($"elements within the {length} bytes of the buffer view"));
        }
    }

    private static void Read(JsonValue accessor, ReadOnlySpan<byte> bytes, int offset, int stride, int component, bool normalised, int width, Span<float> numbers)
    {
        int size = SizeOf(component);
        for (int i = 0; i < numbers.Length; i++)
        {
            float number = Number(bytes.Slice(offset + (i / width * stride) + (i % width * size), size), component, normalised);
            numbers[i] = float.IsFinite(number) ? number : throw new ModelFault(accessor.Path, FormattableString.Invariant($"{number} in element {i / width}"), "finite numbers");
        }
    }

    private static float Number(ReadOnlySpan<byte> bytes, int component, bool normalised) => component switch
    {
        5120 => normalised ? Math.Max((sbyte)bytes[0] / 127f, -1f) : (sbyte)bytes[0],
        5121 => normalised ? bytes[0] / 255f : bytes[0],
        5122 => normalised ? Math.Max(BinaryPrimitives.ReadInt16LittleEndian(bytes) / 32767f, -1f) : BinaryPrimitives.ReadInt16LittleEndian(bytes),
        5123 => normalised ? BinaryPrimitives.ReadUInt16LittleEndian(bytes) / 65535f : BinaryPrimitives.ReadUInt16LittleEndian(bytes),
        5125 => BinaryPrimitives.ReadUInt32LittleEndian(bytes),
        _ => BitConverter.Int32BitsToSingle(BinaryPrimitives.ReadInt32LittleEndian(bytes)),
    };

    private void Replace(JsonValue accessor, JsonValue sparse, int component, bool normalised, int width, Span<float> numbers)
    {
        int count = ModelDocument.Whole(ModelDocument.Need(sparse, "count", "a number of elements"), numbers.Length / width);
        JsonValue indices = ModelDocument.Need(sparse, "indices", "indices of elements");
        JsonValue values = ModelDocument.Need(sparse, "values", "elements");
        int indexComponent = Component(indices);
        float[] places = new float[count];
        float[] replaced = new float[count * width];
        ReadOnlySpan<byte> bytes = View(ModelDocument.Need(indices, "bufferView", "a buffer view"), out _);
        int offset = ModelDocument.Whole(indices, "byteOffset", 0);
        RequireRoom(indices, bytes.Length, offset, 0, count, SizeOf(indexComponent));
        Read(indices, bytes, offset, SizeOf(indexComponent), indexComponent, normalised: false, 1, places);
        bytes = View(ModelDocument.Need(values, "bufferView", "a buffer view"), out _);
        offset = ModelDocument.Whole(values, "byteOffset", 0);
        RequireRoom(values, bytes.Length, offset, 0, count, width * SizeOf(component));
        Read(accessor, bytes, offset, width * SizeOf(component), component, normalised, width, replaced);
        for (int i = 0; i < count; i++)
        {
            if (!(places[i] >= 0f && places[i] < numbers.Length / width))
            {
                throw new ModelFault(indices.Path, FormattableString.Invariant($"element {places[i]}"), FormattableString.Invariant($"one of {numbers.Length / width}"));
            }

            replaced.AsSpan(i * width, width).CopyTo(numbers.Slice((int)places[i] * width, width));
        }
    }
}
