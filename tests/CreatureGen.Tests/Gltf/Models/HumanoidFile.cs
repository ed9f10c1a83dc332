using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace CreatureGen.Tests.Gltf.Models;

/// <summary>
/// A humanoid as other programs write it: an armature in centimetres that lies on its back until a node turns it upright, names with colons, bones along −X, joints before their
/// parents in the skin, a mesh bound in a pose other than the rest pose, cubic, linear and stepping keys, normalised bytes as weights.
/// </summary>
internal sealed class HumanoidFile
{
    private readonly MemoryStream binary = new();
    private readonly JsonArray views = [];
    private readonly JsonArray accessors = [];

    private HumanoidFile()
    {
        var nodes = new JsonArray
        {
            new JsonObject { ["name"] = "Figure", ["mesh"] = 0, ["skin"] = 0 },
            new JsonObject { ["name"] = "Armature", ["children"] = new JsonArray(2), ["rotation"] = Numbers(-0.70710678f, 0f, 0f, 0.70710678f), ["scale"] = Numbers(0.01f, 0.01f, 0.01f) },
            new JsonObject { ["name"] = "mixamorig:Hips", ["children"] = new JsonArray(3, 5, 7), ["matrix"] = Matrix(Matrix4x4.CreateRotationX(0.1f) * Matrix4x4.CreateTranslation(0f, 0f, 100f)) },
            Bone("mixamorig:LeftUpLeg", 4, new Vector3(0.2f, 0.1f, 1.4f), new Vector3(10f, 0f, 0f)),
            Bone("mixamorig:LeftLeg", -1, new Vector3(0.1f, 0f, 0.3f), new Vector3(-45f, 0f, 0f)),
            Bone("mixamorig:RightUpLeg", 6, new Vector3(-0.2f, 0.1f, 1.6f), new Vector3(-10f, 0f, 0f)),
            Bone("mixamorig:RightLeg", -1, new Vector3(0.1f, 0f, -0.2f), new Vector3(-45f, 0f, 0f)),
            Bone("mixamorig:Spine", -1, new Vector3(0f, 0.3f, 0f), new Vector3(0f, 0f, 50f)),
        };
        int[] joints = [4, 2, 3, 6, 5, 7];
        var random = new Random(7);
        int count = 60;
        float[] positions = new float[3 * count];
        byte[] bones = new byte[4 * count];
        byte[] fractions = new byte[4 * count];
        for (int i = 0; i < count; i++)
        {
            for (int k = 0; k < 3; k++)
            {
                positions[(3 * i) + k] = (random.NextSingle() - 0.5f) * 150f;
            }

            bones[4 * i] = (byte)random.Next(6);
            bones[(4 * i) + 1] = (byte)((bones[4 * i] + 1 + random.Next(5)) % 6);
            fractions[4 * i] = (byte)random.Next(128, 256);
            fractions[(4 * i) + 1] = (byte)(255 - fractions[4 * i]);
        }

        float[] inverses = new float[16 * joints.Length];
        for (int j = 0; j < joints.Length; j++)
        {
            var bound = Matrix4x4.CreateFromYawPitchRoll(0.3f * j, 0.2f, 1f - (0.4f * j)) * Matrix4x4.CreateTranslation(10f * j, 5f, 80f - (20f * j));
            Matrix4x4.Invert(bound, out Matrix4x4 inverse);
            Rows(inverse).CopyTo(inverses, 16 * j);
        }

        float[] times = [0.25f, 0.5f, 1.25f];
        Json = new JsonObject
        {
            ["asset"] = new JsonObject { ["version"] = "2.0" },
            ["scene"] = 0,
            ["scenes"] = new JsonArray(new JsonObject { ["nodes"] = new JsonArray(0, 1) }),
            ["nodes"] = nodes,
            ["meshes"] = new JsonArray(new JsonObject
            {
                ["primitives"] = new JsonArray(new JsonObject
                {
                    ["attributes"] = new JsonObject
                    {
                        ["POSITION"] = Add(Bytes(positions), count, "VEC3", 5126),
                        ["JOINTS_0"] = Add(bones, count, "VEC4", 5121),
                        ["WEIGHTS_0"] = Add(fractions, count, "VEC4", 5121, normalised: true),
                    },
                    ["material"] = 0,
                }),
            }),
            ["materials"] = new JsonArray(new JsonObject { ["name"] = "Cloth", ["pbrMetallicRoughness"] = new JsonObject { ["baseColorFactor"] = Numbers(0.8f, 0.25f, 0.1f, 1f) } }),
            ["skins"] = new JsonArray(new JsonObject { ["joints"] = new JsonArray([.. Array.ConvertAll(joints, j => (JsonNode)j)]), ["inverseBindMatrices"] = Add(Bytes(inverses), joints.Length, "MAT4", 5126) }),
            ["animations"] = new JsonArray(new JsonObject
            {
                ["name"] = "Wave",
                ["channels"] = new JsonArray(Channel(0, 3, "rotation"), Channel(1, 2, "translation"), Channel(2, 7, "rotation"), Channel(3, 4, "translation")),
                ["samplers"] = new JsonArray(
                    Sampler(times, "LINEAR", Turns(random, 3), "VEC4"),
                    Sampler(times, "CUBICSPLINE", Some(random, 27, 40f), "VEC3"),
                    Sampler(times, "CUBICSPLINE", Turns(random, 9), "VEC4"),
                    Sampler(times, "STEP", Some(random, 9, 30f), "VEC3")),
                ["extras"] = new JsonObject
                {
                    ["loop"] = true,
                    ["events"] = new JsonArray(new JsonObject { ["time"] = 0.5, ["name"] = "clap", ["joint"] = "mixamorig:Spine", ["strength"] = 0.5 }),
                },
            }),
            ["bufferViews"] = views,
            ["accessors"] = accessors,
            ["buffers"] = new JsonArray(new JsonObject { ["byteLength"] = binary.Length }),
        };
    }

    /// <summary>The document; may be changed before it is written.</summary>
    public JsonObject Json { get; }

    public static HumanoidFile Create() => new();

    /// <summary>Lays the attributes of its vertices one vertex after the other, as many programs do, with room between them that says nothing.</summary>
    public HumanoidFile Interleave()
    {
        const int gap = 4;
        (string Name, int Size)[] layout = [("WEIGHTS_0", 4), ("POSITION", 12), ("JOINTS_0", 4)];
        int stride = layout.Sum(part => part.Size) + gap;
        JsonNode attributes = Json["meshes"]![0]!["primitives"]![0]!["attributes"]!;
        int count = (int)accessors[(int)attributes["POSITION"]!]!["count"]!;
        byte[] vertices = new byte[stride * count];
        vertices.AsSpan().Fill(0x5A);
        int offset = 0;
        foreach ((string name, int size) in layout)
        {
            JsonNode accessor = accessors[(int)attributes[name]!]!;
            int start = (int)(long)views[(int)accessor["bufferView"]!]!["byteOffset"]!;
            for (int i = 0; i < count; i++)
            {
                binary.GetBuffer().AsSpan(start + (size * i), size).CopyTo(vertices.AsSpan((stride * i) + offset));
            }

            accessor["bufferView"] = views.Count;
            accessor["byteOffset"] = offset;
            offset += size;
        }

        views.Add(new JsonObject { ["buffer"] = 0, ["byteOffset"] = binary.Length, ["byteLength"] = vertices.Length, ["byteStride"] = stride });
        binary.Write(vertices);
        Json["buffers"]![0]!["byteLength"] = binary.Length;
        return this;
    }

    /// <summary>Lets all rotations end as they begin, and says nothing of loops, as files of other programs do.</summary>
    public HumanoidFile Close()
    {
        JsonNode animation = Json["animations"]![0]!;
        animation.AsObject().Remove("extras");
        foreach ((int sampler, int from, int to) in new[] { (0, 0, 2), (2, 1, 7) })
        {
            JsonNode accessor = accessors[(int)animation["samplers"]![sampler]!["output"]!]!;
            int start = (int)(long)views[(int)accessor["bufferView"]!]!["byteOffset"]!;
            binary.GetBuffer().AsSpan(start + (16 * from), 16).CopyTo(binary.GetBuffer().AsSpan(start + (16 * to)));
        }

        return this;
    }

    /// <summary>The file as it is now.</summary>
    public byte[] Write()
    {
        byte[] json = JsonSerializer.SerializeToUtf8Bytes(Json);
        int padded = (json.Length + 3) & ~3;
        byte[] bytes = new byte[12 + 8 + padded + 8 + (int)binary.Length];
        BinaryPrimitives.WriteUInt32LittleEndian(bytes, 0x46546C67);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(4), 2);
        BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(8), bytes.Length);
        BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(12), padded);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(16), 0x4E4F534A);
        bytes.AsSpan(20, padded).Fill((byte)' ');
        json.CopyTo(bytes, 20);
        BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(20 + padded), (int)binary.Length);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(24 + padded), 0x004E4942);
        binary.ToArray().CopyTo(bytes, 28 + padded);
        return bytes;
    }

    private static JsonArray Numbers(params float[] numbers) => [.. Array.ConvertAll(numbers, n => (JsonNode)n)];

    private static float[] Rows(Matrix4x4 m) => [m.M11, m.M12, m.M13, 0f, m.M21, m.M22, m.M23, 0f, m.M31, m.M32, m.M33, 0f, m.M41, m.M42, m.M43, 1f];

    private static JsonArray Matrix(Matrix4x4 m) => Numbers(Rows(m));

    private static JsonObject Bone(string name, int child, Vector3 turn, Vector3 place)
    {
        Quaternion q = Quaternion.CreateFromYawPitchRoll(turn.X, turn.Y, turn.Z);
        var node = new JsonObject { ["name"] = name, ["rotation"] = Numbers(q.X, q.Y, q.Z, q.W), ["translation"] = Numbers(place.X, place.Y, place.Z) };
        if (child >= 0)
        {
            node["children"] = new JsonArray(child);
        }

        return node;
    }

    private static JsonObject Channel(int sampler, int node, string path) => new() { ["sampler"] = sampler, ["target"] = new JsonObject { ["node"] = node, ["path"] = path } };

    private static float[] Some(Random random, int count, float size)
    {
        float[] numbers = new float[count];
        for (int i = 0; i < count; i++)
        {
            numbers[i] = (random.NextSingle() - 0.5f) * size;
        }

        return numbers;
    }

    private static float[] Turns(Random random, int count)
    {
        var numbers = new List<float>();
        for (int i = 0; i < count; i++)
        {
            Quaternion q = Quaternion.CreateFromYawPitchRoll(random.NextSingle(), random.NextSingle(), random.NextSingle());
            numbers.AddRange([q.X, q.Y, q.Z, q.W]);
        }

        return [.. numbers];
    }

    private static byte[] Bytes(float[] numbers)
    {
        byte[] bytes = new byte[4 * numbers.Length];
        for (int i = 0; i < numbers.Length; i++)
        {
            BinaryPrimitives.WriteSingleLittleEndian(bytes.AsSpan(4 * i), numbers[i]);
        }

        return bytes;
    }

    private JsonObject Sampler(float[] times, string interpolation, float[] values, string type) => new()
    {
        ["input"] = Add(Bytes(times), times.Length, "SCALAR", 5126, bounds: (times[0], times[^1])),
        ["interpolation"] = interpolation,
        ["output"] = Add(Bytes(values), values.Length / (type == "VEC3" ? 3 : 4), type, 5126),
    };

    private int Add(byte[] bytes, int count, string type, int component, bool normalised = false, (float Min, float Max)? bounds = null)
    {
        views.Add(new JsonObject { ["buffer"] = 0, ["byteOffset"] = binary.Length, ["byteLength"] = bytes.Length });
        var accessor = new JsonObject { ["bufferView"] = views.Count - 1, ["componentType"] = component, ["count"] = count, ["type"] = type };
        if (normalised)
        {
            accessor["normalized"] = true;
        }

        if (bounds is var (min, max) && bounds != null)
        {
            accessor["min"] = Numbers(min);
            accessor["max"] = Numbers(max);
        }

        accessors.Add(accessor);
        binary.Write(bytes);
        while (binary.Length % 4 != 0)
        {
            binary.WriteByte(0);
        }

        return accessors.Count - 1;
    }
}
