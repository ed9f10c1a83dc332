using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using System.Text;
using System;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Gltf;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class GlbLayoutTests
{
    public static TheoryData<int> Numbers => new(Enumerable.Range(0, 12));

    [Theory]
    [MemberData(nameof(Numbers))]
    public void The_container_is_a_header_a_json_chunk_and_a_binary_chunk_of_whole_words(int number)
    {
        GlbFile file = GlbFile.Of(SampleCreature.Build(SampleShape.Of(number)));
        Assert.Equal("glTF", Encoding.ASCII.GetString(file.Bytes, 0, 4));
        Assert.Equal(2u, file.U32(4));
        Assert.Equal((uint)file.Bytes.Length, file.U32(8));
        Assert.Equal("JSON", Encoding.ASCII.GetString(file.Bytes, 16, 4));
        Assert.Equal(0, file.JsonLength % 4);
        Assert.Equal("BIN\0", Encoding.ASCII.GetString(file.Bytes, file.BinaryStart - 4, 4));
        Assert.Equal(0, file.BinaryLength % 4);
        Assert.Equal(file.Bytes.Length, file.BinaryStart + file.BinaryLength);
        Assert.Equal(file.BinaryLength, file.Json.GetProperty("buffers")[0].GetProperty("byteLength").GetInt32());
    }

    [Fact]
    public void The_json_is_padded_with_spaces_to_every_remainder()
    {
        var seen = new HashSet<int>();
        for (int length = 0; length < 8; length++)
        {
            GlbFile file = GlbFile.Of(SampleCreature.Build(SampleShape.Of(1)), new GltfOptions { Provenance = new string('x', length) });
            ReadOnlySpan<byte> json = file.Bytes.AsSpan(20, file.JsonLength);
            int end = json.LastIndexOf((byte)'}') + 1;
            Assert.InRange(json.Length - end, 0, 3);
            Assert.True(json[end..].IndexOfAnyExcept((byte)' ') < 0);
            seen.Add(json.Length - end);
        }

        Assert.Equal([0, 1, 2, 3], seen.Order());
    }

    [Theory]
    [MemberData(nameof(Numbers))]
    public void Every_accessor_has_a_view_of_its_own_that_follows_the_one_before_at_the_next_word(int number)
    {
        GlbFile file = GlbFile.Of(SampleCreature.Build(SampleShape.Of(number)));
        int end = 0;
        for (int i = 0; i < file.Json.GetProperty("accessors").GetArrayLength(); i++)
        {
            Assert.Equal(i, file.Accessor(i).GetProperty("bufferView").GetInt32());
            int offset = file.View(i).GetProperty("byteOffset").GetInt32();
            Assert.Equal((end + 3) / 4 * 4, offset);
            Assert.All(file.Bytes.AsSpan(file.BinaryStart + end, offset - end).ToArray(), b => Assert.Equal(0, b));
            end = offset + file.View(i).GetProperty("byteLength").GetInt32();
        }

        Assert.Equal((end + 3) / 4 * 4, file.BinaryLength);
        Assert.All(file.Bytes.AsSpan(file.BinaryStart + end).ToArray(), b => Assert.Equal(0, b));
    }

    [Fact]
    public void Only_views_of_vertices_and_indices_say_what_they_are_for()
    {
        GlbFile file = GlbFile.Of(SampleCreature.Build(SampleShape.Of(5)));
        foreach (JsonProperty attribute in file.Primitive.GetProperty("attributes").EnumerateObject())
        {
            Assert.Equal(34962, file.View(attribute.Value.GetInt32()).GetProperty("target").GetInt32());
        }

        foreach (JsonElement primitive in file.Json.GetProperty("meshes")[0].GetProperty("primitives").EnumerateArray())
        {
            Assert.Equal(34963, file.View(primitive.GetProperty("indices").GetInt32()).GetProperty("target").GetInt32());
        }

        Assert.False(file.View(file.Json.GetProperty("skins")[0].GetProperty("inverseBindMatrices").GetInt32()).TryGetProperty("target", out _));
    }

    [Theory]
    [MemberData(nameof(Numbers))]
    public void Attributes_hold_the_numbers_of_the_mesh(int number)
    {
        Creature creature = SampleCreature.Build(SampleShape.Of(number));
        CreatureMesh mesh = creature.Mesh;
        GlbFile file = GlbFile.Of(creature);
        Assert.Equal(mesh.Positions.ToArray().SelectMany(Three), file.Numbers(file.Attribute("POSITION")));
        Assert.Equal(mesh.Normals.ToArray().SelectMany(Three), file.Numbers(file.Attribute("NORMAL")));
        Assert.Equal(mesh.Texcoords.ToArray().SelectMany(t => new double[] { t.X, t.Y }), file.Numbers(file.Attribute("TEXCOORD_0")));
        Assert.Equal(mesh.Colours.ToArray().SelectMany(c => Three(c).Select(x => Math.Floor((x * 65535.0) + 0.5)).Append(65535.0)), file.Numbers(file.Attribute("COLOR_0")));
        Assert.Equal(mesh.Weights.ToArray().SelectMany(w => new double[] { w.Joint0, w.Joint1, w.Joint2, w.Joint3 }), file.Numbers(file.Attribute("JOINTS_0")));
        JsonElement colour = file.Accessor(file.Attribute("COLOR_0"));
        Assert.True(colour.GetProperty("normalized").GetBoolean());
        Assert.Equal("VEC4", colour.GetProperty("type").GetString());
    }

    [Theory]
    [MemberData(nameof(Numbers))]
    public void Bounds_are_those_of_the_stored_floats(int number)
    {
        GlbFile file = GlbFile.Of(SampleCreature.Build(SampleShape.Of(number)));
        int positions = file.Attribute("POSITION");
        double[] numbers = file.Numbers(positions);
        for (int axis = 0; axis < 3; axis++)
        {
            double[] along = numbers.Where((_, i) => i % 3 == axis).ToArray();
            Assert.Equal(along.Min(), file.Accessor(positions).GetProperty("min")[axis].GetSingle());
            Assert.Equal(along.Max(), file.Accessor(positions).GetProperty("max")[axis].GetSingle());
        }
    }

    [Fact]
    public void Negative_zero_is_written_as_zero()
    {
        Creature creature = SampleCreature.Build(SampleShape.Of(2));
        Vector3[] positions = creature.Mesh.Positions.ToArray();
        Vector3[] negative = positions.Select(p => new Vector3(p.X == 0f ? -0f : p.X, p.Y, p.Z == 0f ? -0f : p.Z)).ToArray();
        Assert.Contains(negative, p => p.X == 0f && float.IsNegative(p.X));
        Assert.Equal(GlbFile.Write(SampleCreature.With(creature, positions.Select(p => p + Vector3.Zero).ToArray())), GlbFile.Write(SampleCreature.With(creature, negative)));
    }

    [Theory]
    [MemberData(nameof(Numbers))]
    public void Parts_come_in_order_and_share_their_vertices(int number)
    {
        Creature creature = SampleCreature.Build(SampleShape.Of(number));
        GlbFile file = GlbFile.Of(creature);
        JsonElement[] primitives = file.Json.GetProperty("meshes")[0].GetProperty("primitives").EnumerateArray().ToArray();
        Assert.Equal(creature.Mesh.Parts.Count, primitives.Length);
        for (int i = 0; i < primitives.Length; i++)
        {
            MeshPart part = creature.Mesh.Parts[i];
            Assert.Equal(primitives[0].GetProperty("attributes").GetRawText(), primitives[i].GetProperty("attributes").GetRawText());
            Assert.Equal(
                creature.Mesh.Triangles.Slice(part.FirstIndex, part.IndexCount).ToArray().Select(x => (double)x).Chunk(3).Select(t => (t[0], t[1], t[2])).Order(),
                file.Numbers(primitives[i].GetProperty("indices").GetInt32()).Chunk(3).Select(t => (t[0], t[1], t[2])).Order());
            JsonElement material = file.Json.GetProperty("materials")[primitives[i].GetProperty("material").GetInt32()];
            Assert.Equal(part.Material.ToString(), material.GetProperty("name").GetString());
            Assert.Equal(part.Material == MaterialKind.Membrane, material.TryGetProperty("doubleSided", out JsonElement both) && both.GetBoolean());
        }

        Assert.Equal(creature.Mesh.Parts.Select(p => p.Material).Distinct().Count(), file.Json.GetProperty("materials").GetArrayLength());
    }

    [Fact]
    public void Indices_are_short_up_to_vertex_65534_and_long_beyond()
    {
        Assert.Equal((5123, 65535), IndexFormatOf(vertices: 65535));
        Assert.Equal((5125, 65536), IndexFormatOf(vertices: 65536));
    }

    [Fact]
    public void A_creature_without_membranes_has_one_material()
    {
        GlbFile file = GlbFile.Of(SampleCreature.Build(new SampleShape(1, Fins: 0)));
        JsonElement material = Assert.Single(file.Json.GetProperty("materials").EnumerateArray());
        Assert.Equal("Skin", material.GetProperty("name").GetString());
        JsonElement surface = material.GetProperty("pbrMetallicRoughness");
        Assert.Equal(0.0, surface.GetProperty("metallicFactor").GetDouble());
        Assert.Equal([1.0, 1.0, 1.0, 1.0], GlbFile.Array(surface, "baseColorFactor")!);
    }

    /// <summary>The component type of the indices, and the number of vertices, of a creature padded with vertices that no triangle uses.</summary>
    private static (int Type, int Vertices) IndexFormatOf(int vertices)
    {
        Creature creature = SampleCreature.Build(SampleShape.Of(3));
        CreatureMesh mesh = creature.Mesh;
        T[] Grow<T>(ReadOnlySpan<T> items)
        {
            T[] grown = new T[vertices];
            Array.Fill(grown, items[0]);
            items.CopyTo(grown);
            return grown;
        }

        int[] triangles = mesh.Triangles.ToArray();
        triangles[0] = vertices - 1;
        GlbFile file = GlbFile.Of(SampleCreature.With(creature, Grow(mesh.Positions), Grow(mesh.Normals), Grow(mesh.Texcoords), Grow(mesh.Colours), Grow(mesh.Weights), triangles));
        int indices = file.Primitive.GetProperty("indices").GetInt32();
        Assert.Contains(vertices - 1, file.Numbers(indices));
        return (file.Accessor(indices).GetProperty("componentType").GetInt32(), file.Accessor(file.Attribute("POSITION")).GetProperty("count").GetInt32());
    }

    private static double[] Three(Vector3 v) => [v.X, v.Y, v.Z];
}
