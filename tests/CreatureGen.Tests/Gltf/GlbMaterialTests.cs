using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Threading.Tasks;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Sampling;
using CreatureGen.Tests.Creatures;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class GlbMaterialTests
{
    // With wings of skin: it has triangles of both materials at every level.
    private static readonly Creature Subject = Enumerable.Range(0, 40).Select(seed => CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying })).First(c => c.Mesh.Parts.Count == 2);

    public static IEnumerable<TheoryDataRow<LodChoice, Shading, int>> Choices =>
        from levels in new[] { LodChoice.Quarter, LodChoice.Finest, LodChoice.All }
        from look in new[] { (Shading.Smooth, 0), (Shading.Flat, 0), (Shading.Smooth, 256) }
        select new TheoryDataRow<LodChoice, Shading, int>(levels, look.Item1, look.Item2) { Explicit = levels != LodChoice.Quarter };

    [Theory]
    [MemberData(nameof(Choices))]
    public void One_material_has_the_same_triangles_and_colours_as_two_in_one_primitive_for_each_level(LodChoice levels, Shading shading, int textures)
    {
        var options = new GltfOptions { Lods = levels, Shading = shading, TextureSize = textures };
        GlbFile two = GlbFile.Of(Subject, options);
        GlbFile one = GlbFile.Of(Subject, options with { Materials = MaterialChoice.One });
        Assert.Equal(2, two.Json.GetProperty("materials").GetArrayLength());
        JsonElement material = one.Json.GetProperty("materials").EnumerateArray().Single();
        Assert.Equal("Creature", material.GetProperty("name").GetString());
        Assert.True(material.GetProperty("doubleSided").GetBoolean());
        Assert.Equal(textures > 0, material.TryGetProperty("normalTexture", out _));
        Assert.Equal(two.Json.GetProperty("meshes").GetArrayLength(), one.Json.GetProperty("meshes").GetArrayLength());
        for (int level = 0; level < one.Json.GetProperty("meshes").GetArrayLength(); level++)
        {
            JsonElement primitive = one.Json.GetProperty("meshes")[level].GetProperty("primitives").EnumerateArray().Single();
            Assert.Equal(0, primitive.GetProperty("material").GetInt32());
            Assert.Equal(Corners(two, level), Corners(one, level));
        }
    }

    [Fact]
    public void A_creature_without_membranes_gets_the_same_one_material()
    {
        Creature solid = Enumerable.Range(0, 40).Select(seed => LodSubjects.Of(RequestedKind.Walking, seed)).First(c => c.Mesh.Parts.Count == 1);
        JsonElement material = GlbFile.Of(solid, new GltfOptions { Materials = MaterialChoice.One }).Json.GetProperty("materials").EnumerateArray().Single();
        Assert.Equal("Creature", material.GetProperty("name").GetString());
        Assert.True(material.GetProperty("doubleSided").GetBoolean());
    }

    [Fact]
    public void A_number_of_materials_that_there_is_not_is_refused_by_name()
    {
        ArgumentException e = Assert.Throws<ArgumentException>(() => GlbFile.Write(Subject, new GltfOptions { Materials = (MaterialChoice)7 }));
        Assert.StartsWith("materials 7; expected Two or One", e.Message, StringComparison.Ordinal);
    }

    [Fact(Explicit = true)]
    public async Task The_validator_of_the_standard_finds_nothing_to_object_to_in_one_material()
    {
        string folder = Directory.CreateTempSubdirectory("creaturegen-").FullName;
        try
        {
            int count = 0;
            foreach (RequestedKind kind in new[] { RequestedKind.Walking, RequestedKind.Flying, RequestedKind.Swimming })
            {
                foreach (LodChoice levels in new[] { LodChoice.Finest, LodChoice.All })
                {
                    foreach ((Shading shading, int textures) in new[] { (Shading.Smooth, 0), (Shading.Flat, 0), (Shading.Smooth, 256) })
                    {
                        var options = new GltfOptions { Materials = MaterialChoice.One, Lods = levels, Shading = shading, TextureSize = textures };
                        File.WriteAllBytes(Path.Combine(folder, FormattableString.Invariant($"{count++}.glb")), GlbFile.Write(LodSubjects.Of(kind, Thoroughness.IsExhaustive ? 60 + count : 60), options));
                    }
                }
            }

            (int exitCode, string output, string errors) = await GltfTools.RunAsync("validate.mjs", folder, TestContext.Current.CancellationToken);
            Assert.True(exitCode == 0, output + errors);
            JsonElement totals = JsonDocument.Parse(output).RootElement;
            Assert.Equal(count, totals.GetProperty("files").GetInt32());
            Assert.Equal(0, totals.GetProperty("errors").GetInt32());
            Assert.Equal(0, totals.GetProperty("warnings").GetInt32());
            Assert.Equal(0, totals.GetProperty("hints").GetInt32());
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    /// <summary>Every triangle of a level by what its corners look like, whatever their numbers, from its least corner on and in order.</summary>
    private static List<string> Corners(GlbFile file, int level)
    {
        double[] positions = file.Numbers(file.Attribute("POSITION"));
        double[] normals = file.Numbers(file.Attribute("NORMAL"));
        double[] colours = file.Numbers(file.Attribute("COLOR_0"));
        double[] texcoords = file.Numbers(file.Attribute("TEXCOORD_0"));
        var triangles = new List<string>();
        foreach (JsonElement primitive in file.Json.GetProperty("meshes")[level].GetProperty("primitives").EnumerateArray())
        {
            foreach (double[] triangle in file.Numbers(primitive.GetProperty("indices").GetInt32()).Chunk(3))
            {
                string[] corners = Array.ConvertAll(triangle, v => string.Join(' ', Part(positions, 3, (int)v).Concat(Part(normals, 3, (int)v)).Concat(Part(texcoords, 2, (int)v)).Concat(Part(colours, 4, (int)v))));
                int first = Array.IndexOf(corners, corners.Min(StringComparer.Ordinal));
                triangles.Add(corners[first] + " | " + corners[(first + 1) % 3] + " | " + corners[(first + 2) % 3]);
            }
        }

        triangles.Sort(StringComparer.Ordinal);
        return triangles;
    }

    private static IEnumerable<double> Part(double[] numbers, int width, int vertex) => new ArraySegment<double>(numbers, width * vertex, width);
}
