using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using CreatureGen.Creatures;
using CreatureGen.Gltf;

namespace CreatureGen.Tests.Gltf;

/// <summary>A GLB as the tests read it, sharing no code with the writer.</summary>
internal sealed class GlbFile
{
    private GlbFile(byte[] bytes)
    {
        Bytes = bytes;
        JsonLength = (int)U32(12);
        Json = JsonDocument.Parse(bytes.AsMemory(20, JsonLength)).RootElement;
        int header = 20 + JsonLength;
        BinaryLength = (int)U32(header);
        BinaryStart = header + 8;
    }

    public byte[] Bytes { get; }

    public JsonElement Json { get; }

    public int JsonLength { get; }

    public int BinaryStart { get; }

    public int BinaryLength { get; }

    public JsonElement Primitive => Json.GetProperty("meshes")[0].GetProperty("primitives")[0];

    public static byte[] Write(Creature creature, GltfOptions? options = null)
    {
        using var stream = new MemoryStream();
        GlbWriter.Write(creature, options ?? GltfOptions.Default, stream);
        return stream.ToArray();
    }

    public static GlbFile Of(Creature creature, GltfOptions? options = null) => new(Write(creature, options));

    public uint U32(int at) => BinaryPrimitives.ReadUInt32LittleEndian(Bytes.AsSpan(at, 4));

    public JsonElement Accessor(int index) => Json.GetProperty("accessors")[index];

    public JsonElement View(int accessor) => Json.GetProperty("bufferViews")[Accessor(accessor).GetProperty("bufferView").GetInt32()];

    public int Attribute(string semantic) => Primitive.GetProperty("attributes").GetProperty(semantic).GetInt32();

    /// <summary>All numbers of an accessor as they are stored, one element after the other.</summary>
    public double[] Numbers(int index)
    {
        JsonElement accessor = Accessor(index);
        int width = Width(accessor.GetProperty("type").GetString()!);
        int count = accessor.GetProperty("count").GetInt32() * width;
        int offset = BinaryStart + View(index).GetProperty("byteOffset").GetInt32();
        int type = accessor.GetProperty("componentType").GetInt32();
        var numbers = new double[count];
        for (int i = 0; i < count; i++)
        {
            numbers[i] = type switch
            {
                5126 => BinaryPrimitives.ReadSingleLittleEndian(Bytes.AsSpan(offset + (4 * i), 4)),
                5125 => BinaryPrimitives.ReadUInt32LittleEndian(Bytes.AsSpan(offset + (4 * i), 4)),
                5123 => BinaryPrimitives.ReadUInt16LittleEndian(Bytes.AsSpan(offset + (2 * i), 2)),
                5121 => Bytes[offset + i],
                _ => throw new InvalidDataException($"component type {type}"),
            };
        }

        return numbers;
    }

    /// <summary>World matrices of all nodes, column-major, by the nodes' translations and rotations.</summary>
    public double[][] WorldMatrices()
    {
        JsonElement[] nodes = Json.GetProperty("nodes").EnumerateArray().ToArray();
        var worlds = new double[nodes.Length][];
        var pending = new Stack<(int Node, double[] Parent)>();
        foreach (JsonElement root in Json.GetProperty("scenes")[0].GetProperty("nodes").EnumerateArray())
        {
            pending.Push((root.GetInt32(), Local([0, 0, 0], [0, 0, 0, 1])));
        }

        while (pending.Count > 0)
        {
            (int index, double[] parent) = pending.Pop();
            JsonElement node = nodes[index];
            worlds[index] = Multiply(parent, Local(Array(node, "translation") ?? [0, 0, 0], Array(node, "rotation") ?? [0, 0, 0, 1]));
            foreach (int child in (Array(node, "children") ?? []).Select(c => (int)c))
            {
                pending.Push((child, worlds[index]));
            }
        }

        return worlds;
    }

    public static double[]? Array(JsonElement element, string name) =>
        element.TryGetProperty(name, out JsonElement array) ? array.EnumerateArray().Select(x => x.GetDouble()).ToArray() : null;

    /// <summary>Product of two column-major matrices.</summary>
    public static double[] Multiply(double[] a, double[] b)
    {
        var product = new double[16];
        for (int column = 0; column < 4; column++)
        {
            for (int row = 0; row < 4; row++)
            {
                for (int k = 0; k < 4; k++)
                {
                    product[(4 * column) + row] += a[(4 * k) + row] * b[(4 * column) + k];
                }
            }
        }

        return product;
    }

    private static int Width(string type) => type switch { "SCALAR" => 1, "VEC2" => 2, "VEC3" => 3, "VEC4" => 4, "MAT4" => 16, _ => throw new InvalidDataException(type) };

    /// <summary>Matrix of a rotation and a translation, written as the glTF specification does.</summary>
    private static double[] Local(double[] t, double[] q)
    {
        double x = q[0], y = q[1], z = q[2], w = q[3];
        return
        [
            1 - (2 * ((y * y) + (z * z))), 2 * ((x * y) + (w * z)), 2 * ((x * z) - (w * y)), 0,
            2 * ((x * y) - (w * z)), 1 - (2 * ((x * x) + (z * z))), 2 * ((y * z) + (w * x)), 0,
            2 * ((x * z) + (w * y)), 2 * ((y * z) - (w * x)), 1 - (2 * ((x * x) + (y * y))), 0,
            t[0], t[1], t[2], 1,
        ];
    }
}
