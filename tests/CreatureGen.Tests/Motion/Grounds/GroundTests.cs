using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Grounds;

public class GroundTests
{
    [Fact]
    public void A_plane_is_hit_from_above_and_not_from_below_its_reach()
    {
        var plane = new FlatGround(new Vector3(0f, 1f, 0f), Vector3.UnitY, 4);
        Assert.True(plane.Cast(new Vector3(3f, 2f, 1f), -Vector3.UnitY, 5f, out GroundHit hit));
        Assert.Equal(new Vector3(3f, 1f, 1f), hit.Point);
        Assert.Equal(4, hit.Surface);
        Assert.False(plane.Cast(new Vector3(3f, 2f, 1f), -Vector3.UnitY, 0.5f, out _));
        Assert.False(plane.Cast(new Vector3(3f, 2f, 1f), Vector3.UnitY, 5f, out _));
    }

    [Fact]
    public void A_height_field_and_the_mesh_of_its_triangles_are_hit_alike()
    {
        var random = new CreatureGen.Seeding.RandomStream(3);
        const int Side = 12;
        var heights = new float[Side * Side];
        var positions = new Vector3[heights.Length];
        for (int i = 0; i < heights.Length; i++)
        {
            heights[i] = (float)random.Uniform(-1, 1);
            positions[i] = new Vector3(i % Side * 0.5f, heights[i], i / Side * 0.5f);
        }

        var triangles = new List<int>();
        for (int k = 0; k < Side - 1; k++)
        {
            for (int i = 0; i < Side - 1; i++)
            {
                int a = (k * Side) + i;
                triangles.AddRange(new[] { a, a + Side, a + 1, a + 1, a + Side, a + Side + 1 });
            }
        }

        var field = new HeightFieldGround(heights, Side, 0.5f, Vector3.Zero);
        var mesh = new MeshGround(positions, triangles.ToArray());
        int hits = 0;
        for (int i = 0; i < 500; i++)
        {
            // Slanting rays stay within the terrain: beyond its edge a field is solid below and a mesh is a sheet.
            bool upright = i % 2 == 0;
            double edge = upright ? -0.5 : 2;
            var origin = new Vector3((float)random.Uniform(edge, 5.5 - edge), 2f, (float)random.Uniform(edge, 5.5 - edge));
            Vector3 direction = upright ? -Vector3.UnitY : Vector3.Normalize(new Vector3((float)random.Uniform(-0.5, 0.5), -1f, (float)random.Uniform(-0.5, 0.5)));
            bool there = field.Cast(origin, direction, 6f, out GroundHit a);
            Assert.Equal(mesh.Cast(origin, direction, 6f, out GroundHit b), there);
            hits += there ? 1 : 0;
            Assert.True(Vector3.Distance(a.Point, b.Point) < 2e-3f, $"{a.Point} {b.Point}");
        }

        Assert.True(hits > 300 && hits < 500);
    }

    [Fact]
    public void Bad_grounds_are_refused()
    {
        Assert.ThrowsAny<ArgumentException>(() => new FlatGround(Vector3.Zero, Vector3.Zero));
        Assert.ThrowsAny<ArgumentException>(() => new HeightFieldGround(new float[] { 1f, 2f, 3f }, 2, 1f, Vector3.Zero));
        Assert.ThrowsAny<ArgumentException>(() => new HeightFieldGround(new float[] { 1f, 2f, 3f, float.NaN }, 2, 1f, Vector3.Zero));
        Assert.ThrowsAny<ArgumentException>(() => new MeshGround(new[] { Vector3.Zero }, new[] { 0, 0, 1 }));
    }

    [Fact]
    public void An_empty_mesh_is_never_hit()
    {
        Assert.False(new MeshGround(Array.Empty<Vector3>(), Array.Empty<int>()).Cast(Vector3.UnitY, -Vector3.UnitY, 10f, out _));
    }
}
