using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class GlbShadingTests
{
    private static readonly GltfOptions Flat = new() { Shading = Shading.Flat };

    [Fact]
    public void Flat_shading_gives_every_triangle_three_vertices_of_its_own()
    {
        Creature creature = SampleCreature.Build(SampleShape.Of(8));
        GlbFile file = GlbFile.Of(creature, Flat);
        int corners = creature.Mesh.Triangles.Length;
        foreach (string semantic in new[] { "POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0", "JOINTS_0", "WEIGHTS_0" })
        {
            Assert.Equal(corners, file.Accessor(file.Attribute(semantic)).GetProperty("count").GetInt32());
        }

        double[] indices = file.Json.GetProperty("meshes")[0].GetProperty("primitives").EnumerateArray().SelectMany(p => file.Numbers(p.GetProperty("indices").GetInt32())).ToArray();
        Assert.Equal(Enumerable.Range(0, corners).Select(i => (double)i), indices);
    }

    [Fact]
    public void Flat_shading_keeps_every_corner_where_it_was()
    {
        Creature creature = SampleCreature.Build(SampleShape.Of(8));
        GlbFile smooth = GlbFile.Of(creature);
        GlbFile flat = GlbFile.Of(creature, Flat);
        foreach ((string semantic, int width) in new[] { ("POSITION", 3), ("TEXCOORD_0", 2), ("COLOR_0", 4), ("JOINTS_0", 4), ("WEIGHTS_0", 4) })
        {
            double[] shared = smooth.Numbers(smooth.Attribute(semantic));
            double[] own = flat.Numbers(flat.Attribute(semantic));
            Assert.Equal(creature.Mesh.Triangles.ToArray().SelectMany(v => shared[(width * v)..(width * (v + 1))]), own);
        }
    }

    [Fact]
    public void Flat_normals_are_those_of_the_planes()
    {
        GlbFile file = GlbFile.Of(SampleCreature.Build(SampleShape.Of(8)), Flat);
        double[] p = file.Numbers(file.Attribute("POSITION"));
        double[] n = file.Numbers(file.Attribute("NORMAL"));
        Vector3 Position(int i) => new((float)p[3 * i], (float)p[(3 * i) + 1], (float)p[(3 * i) + 2]);
        Vector3 Normal(int i) => new((float)n[3 * i], (float)n[(3 * i) + 1], (float)n[(3 * i) + 2]);
        for (int i = 0; i < p.Length / 3; i += 3)
        {
            Vector3 u = Vector3.Normalize(Position(i + 1) - Position(i));
            Vector3 v = Vector3.Normalize(Position(i + 2) - Position(i));
            Assert.Equal(Normal(i), Normal(i + 1));
            Assert.Equal(Normal(i), Normal(i + 2));
            Assert.Equal(1f, Normal(i).Length(), 1e-6f);
            Assert.Equal(0f, Vector3.Dot(Normal(i), u), 1e-6f);
            Assert.Equal(0f, Vector3.Dot(Normal(i), v), 1e-6f);
            Assert.True(Vector3.Dot(Normal(i), Vector3.Cross(u, v)) > 0f);
        }
    }

    [Fact]
    public void A_triangle_without_area_has_no_flat_normal()
    {
        Creature creature = SampleCreature.Build(SampleShape.Of(8));
        Vector3[] positions = creature.Mesh.Positions.ToArray();
        int[] corners = creature.Mesh.Triangles.ToArray();
        positions[corners[4]] = positions[corners[3]];
        var error = Assert.Throws<InvalidOperationException>(() => GlbFile.Write(SampleCreature.With(creature, positions), Flat));
        Assert.Matches(@"triangle \d+: it has no area, its corners are .*; expected a plane", error.Message);
    }

    [Fact]
    public void Smooth_is_the_default()
    {
        Creature creature = SampleCreature.Build(SampleShape.Of(8));
        Assert.Equal(GlbFile.Write(creature, new GltfOptions { Shading = Shading.Smooth }), GlbFile.Write(creature));
        Assert.NotEqual(GlbFile.Write(creature, Flat), GlbFile.Write(creature));
    }
}
