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

public sealed class GlbLodTests
{
    private static readonly Creature Subject = LodSubjects.Of(RequestedKind.Flying, 6);

    public static TheoryData<RequestedKind> Kinds => LodSubjects.Kinds;

    [Theory]
    [InlineData(LodChoice.Half, 1)]
    [InlineData(LodChoice.Quarter, 2)]
    [InlineData(LodChoice.Tenth, 3)]
    public void A_file_of_one_level_holds_its_triangles_and_its_vertices_alone(LodChoice choice, int level)
    {
        GlbFile file = GlbFile.Of(Subject, new GltfOptions { Lods = choice });
        CreatureMesh alone = Subject.Mesh.Lods[level].ToMesh();
        Assert.Equal(alone.Positions.Length, file.Accessor(file.Attribute("POSITION")).GetProperty("count").GetInt32());
        Assert.Equal(Triples(alone.Triangles.ToArray()), Triples(IndicesOf(file, 0)));
        Assert.Equal(1, file.Json.GetProperty("meshes").GetArrayLength());
        Assert.False(file.Json.TryGetProperty("extensionsUsed", out _));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_file_of_all_levels_ties_them_together_over_one_set_of_vertices_and_one_skin(RequestedKind kind)
    {
        Creature creature = LodSubjects.Of(kind, 6);
        GlbFile file = GlbFile.Of(creature, new GltfOptions { Lods = LodChoice.All });
        Assert.Equal(["MSFT_lod"], file.Json.GetProperty("extensionsUsed").EnumerateArray().Select(e => e.GetString()));
        Assert.False(file.Json.TryGetProperty("extensionsRequired", out _));
        JsonElement nodes = file.Json.GetProperty("nodes");
        JsonElement finest = nodes[0];
        int[] ids = finest.GetProperty("extensions").GetProperty("MSFT_lod").GetProperty("ids").EnumerateArray().Select(e => e.GetInt32()).ToArray();
        double[] coverage = GlbFile.Array(finest.GetProperty("extras"), "MSFT_screencoverage")!;
        Assert.Equal(ids.Length + 1, coverage.Length);
        Assert.Equal(coverage.OrderDescending(), coverage);
        Assert.Equal(4, file.Json.GetProperty("meshes").GetArrayLength());
        string attributes = file.Primitive.GetProperty("attributes").GetRawText();
        for (int level = 0; level < 4; level++)
        {
            JsonElement node = level == 0 ? finest : nodes[ids[level - 1]];
            Assert.Equal(level == 0 ? "Creature" : "Creature_LOD" + level, node.GetProperty("name").GetString());
            Assert.Equal(0, node.GetProperty("skin").GetInt32());
            Assert.Equal(level, node.GetProperty("mesh").GetInt32());
            Assert.Equal(Triples(creature.Mesh.Lods[level].Triangles.ToArray()), Triples(IndicesOf(file, level)));
            Assert.All(file.Json.GetProperty("meshes")[level].GetProperty("primitives").EnumerateArray(), p => Assert.Equal(attributes, p.GetProperty("attributes").GetRawText()));
        }

        Assert.Equal([0, 1], file.Json.GetProperty("scenes")[0].GetProperty("nodes").EnumerateArray().Select(n => n.GetInt32()));
    }

    [Fact]
    public void Flat_levels_have_facets_of_their_own()
    {
        GlbFile file = GlbFile.Of(Subject, new GltfOptions { Lods = LodChoice.All, Shading = Shading.Flat });
        int corners = Enumerable.Range(0, 4).Sum(i => Subject.Mesh.Lods[i].Triangles.Length);
        Assert.Equal(corners, file.Accessor(file.Attribute("POSITION")).GetProperty("count").GetInt32());
        for (int level = 0; level < 4; level++)
        {
            Assert.Equal(Subject.Mesh.Lods[level].Triangles.Length, IndicesOf(file, level).Length);
        }
    }

    [Fact]
    public void A_choice_that_there_is_not_is_refused_by_name()
    {
        ArgumentException e = Assert.Throws<ArgumentException>(() => GlbFile.Write(Subject, new GltfOptions { Lods = (LodChoice)9 }));
        Assert.StartsWith("levels 9; expected Finest, Half, Quarter, Tenth or All", e.Message, StringComparison.Ordinal);
    }

    /// <summary>Coarse levels have more vertices for a triangle, at the seams of charts, and veins of insects' wings have vertices of their own: no order spares those, but none is transformed much more often than once.</summary>
    [Theory]
    [InlineData(RequestedKind.Walking, 0.77)]
    [InlineData(RequestedKind.Flying, 0.80)]
    [InlineData(RequestedKind.Swimming, 0.77)]
    public void Triangles_of_all_levels_are_in_an_order_that_a_vertex_cache_gains_from(RequestedKind kind, double most)
    {
        for (int seed = 0; seed < (Thoroughness.IsExhaustive ? 40 : 4); seed++)
        {
            Creature creature = LodSubjects.Of(kind, seed);
            GlbFile file = GlbFile.Of(creature, new GltfOptions { Lods = LodChoice.All });
            Assert.InRange(MissesPerTriangle(IndicesOf(file, 0), 16), 0.5, most);
            for (int level = 0; level < 4; level++)
            {
                int[] indices = IndicesOf(file, level);
                Assert.Equal(creature.Mesh.Lods[level].Triangles.ToArray(), indices);
                Assert.InRange(MissesPerTriangle(indices, 16) * indices.Length / 3 / indices.Distinct().Count(), 1, 1.45);
            }
        }
    }

    [Fact(Explicit = true)]
    public async Task The_validator_of_the_standard_finds_nothing_to_object_to_in_levels()
    {
        string folder = Directory.CreateTempSubdirectory("creaturegen-").FullName;
        try
        {
            int count = 0;
            foreach (RequestedKind kind in new[] { RequestedKind.Walking, RequestedKind.Flying, RequestedKind.Swimming })
            {
                foreach (LodChoice choice in Enum.GetValues<LodChoice>())
                {
                    foreach (Shading shading in Enum.GetValues<Shading>())
                    {
                        File.WriteAllBytes(Path.Combine(folder, FormattableString.Invariant($"{count++}.glb")), GlbFile.Write(LodSubjects.Of(kind, Thoroughness.IsExhaustive ? 30 + count : 30), new GltfOptions { Lods = choice, Shading = shading }));
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

            // The validator does not know the extension, and so neither who uses the nodes of the coarser levels.
            string[] codes = totals.GetProperty("issues").EnumerateArray().Select(i => i.GetProperty("code").GetString()!).Distinct().Order().ToArray();
            Assert.Equal(["UNSUPPORTED_EXTENSION", "UNUSED_OBJECT"], codes);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    private static int[] IndicesOf(GlbFile file, int mesh) =>
        file.Json.GetProperty("meshes")[mesh].GetProperty("primitives").EnumerateArray().SelectMany(p => file.Numbers(p.GetProperty("indices").GetInt32())).Select(x => (int)x).ToArray();

    private static IEnumerable<(int, int, int)> Triples(int[] indices) => indices.Chunk(3).Select(t => (t[0], t[1], t[2])).Order();

    private static double MissesPerTriangle(int[] indices, int size)
    {
        var cache = new Queue<int>();
        int misses = 0;
        foreach (int v in indices)
        {
            if (!cache.Contains(v))
            {
                misses++;
                cache.Enqueue(v);
                if (cache.Count > size)
                {
                    cache.Dequeue();
                }
            }
        }

        return misses / (indices.Length / 3.0);
    }
}
