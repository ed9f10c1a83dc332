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

    public static TheoryData<string> Grounds => ["flat", "field", "mesh"];

    /// <summary>A ray that is no ray comes back with no hit, and one that is very long comes back at once.</summary>
    [Theory]
    [MemberData(nameof(Grounds))]
    public void Rays_of_any_numbers_end(string kind)
    {
        IGround ground = Make(kind);
        float[] numbers = { float.NaN, float.PositiveInfinity, float.NegativeInfinity, float.MaxValue, -float.MaxValue, 1e30f, -1e30f, 1e-30f, float.Epsilon, 0f, 1f, -1f };
        var random = new RandomStream(7);
        for (int i = 0; i < 20000; i++)
        {
            float Number() => numbers[random.Integer(0, numbers.Length)];
            var origin = new Vector3(Number(), Number(), Number());
            var direction = new Vector3(Number(), Number(), Number());
            float distance = Number();
            bool there = ground.Cast(origin, direction, distance, out GroundHit hit);
            if (!Finite(origin) || !Finite(direction) || float.IsNaN(distance))
            {
                Assert.False(there, $"{origin} {direction} {distance}");
            }

            Assert.False(float.IsNaN(hit.Normal.X + hit.Normal.Y + hit.Normal.Z));
        }
    }

    [Theory]
    [MemberData(nameof(Grounds))]
    public void A_ray_from_far_away_meets_the_ground_where_a_near_one_does(string kind)
    {
        IGround ground = Make(kind);
        Vector3 direction = Vector3.Normalize(new Vector3(0.6f, -0.5f, 0.7f));
        var aim = new Vector3(2.3f, 0.1f, 2.6f);
        Assert.True(ground.Cast(aim - (direction * 3f), direction, 10f, out GroundHit near));
        Assert.True(ground.Cast(aim - (direction * 3000f), direction, float.MaxValue, out GroundHit far));
        Assert.True(Vector3.Distance(near.Point, far.Point) < 2e-3f, $"{near.Point} {far.Point}");
    }

    /// <summary>The naive reference: small steps down the ray, and halving where it goes under.</summary>
    [Fact]
    public void Slanting_rays_meet_a_height_field_where_small_steps_do()
    {
        var field = (HeightFieldGround)Make("field");
        var random = new RandomStream(11);
        int hits = 0;
        for (int n = 0; n < 3000; n++)
        {
            var origin = new Vector3((float)random.Uniform(0.1, 4.9), (float)random.Uniform(-0.9, 2.5), (float)random.Uniform(0.1, 4.9));
            Vector3 direction = Vector3.Normalize(new Vector3((float)random.Uniform(-1, 1), (float)random.Uniform(-1, 0.6), (float)random.Uniform(-1, 1)));
            float length = (float)random.Uniform(0.2, 6);
            bool there = field.Cast(origin, direction, length, out GroundHit hit);
            double? expected = Stepped(field, origin, direction, length);
            Assert.True(there == expected.HasValue, $"from {origin} along {direction}: {there}");
            if (expected is double t)
            {
                hits++;
                Vector3 at = origin + (direction * (float)t);
                bool inside = t == 0;
                Assert.True(inside || Vector3.Distance(at, hit.Point) < 5e-4f, $"{at} {hit.Point}");
                Assert.True(field.Cast(hit.Point + Vector3.UnitY, -Vector3.UnitY, 2f, out GroundHit below));
                Assert.Equal(below.Point.Y, hit.Point.Y, 2e-4f);
            }
        }

        Assert.True(hits > 800, $"{hits}");
    }

    /// <summary>A slope that rises along +X and sinks along +Z: its normal leans to −X and +Z.</summary>
    [Theory]
    [InlineData(0f, -1f, 0f)]
    [InlineData(0.3f, -1f, 0.2f)]
    public void The_normal_of_a_height_field_leans_away_from_where_it_rises(float x, float y, float z)
    {
        float[] heights = new float[9];
        for (int i = 0; i < heights.Length; i++)
        {
            heights[i] = (0.5f * (i % 3)) - (0.25f * (i / 3)) + 1f;
        }

        var field = new HeightFieldGround(heights, 3, 1f, Vector3.Zero);
        Assert.True(field.Cast(new Vector3(0.9f, 5f, 0.7f), Vector3.Normalize(new Vector3(x, y, z)), 10f, out GroundHit hit));
        Vector3 expected = Vector3.Normalize(new Vector3(-0.5f, 1f, 0.25f));
        Assert.True(Vector3.Distance(expected, hit.Normal) < 1e-6f, $"{hit.Normal}");
    }

    /// <summary>A needle of a micrometre is hit as a triangle of a metre is.</summary>
    [Theory]
    [InlineData(1f)]
    [InlineData(1e-3f)]
    [InlineData(1e-6f)]
    [InlineData(1e-9f)]
    public void Triangles_of_any_size_are_hit(float size)
    {
        var mesh = new MeshGround(new[] { Vector3.Zero, new Vector3(0f, 0f, size), new Vector3(size, 0f, 0f) }, new[] { 0, 1, 2 });
        Assert.True(mesh.Cast(new Vector3(0.25f * size, size, 0.25f * size), -Vector3.UnitY, 2f * size, out GroundHit hit));
        Assert.Equal(Vector3.UnitY, hit.Normal);
        Assert.False(mesh.Cast(new Vector3(0.25f * size, -size, 0.25f * size), Vector3.UnitY, 2f * size, out _));
    }

    private static bool Finite(Vector3 v) => float.IsFinite(v.X) && float.IsFinite(v.Y) && float.IsFinite(v.Z);

    private static double? Stepped(HeightFieldGround field, Vector3 origin, Vector3 direction, float length)
    {
        const int Steps = 4000;
        bool Under(double t)
        {
            Vector3 p = origin + (direction * (float)t);
            return field.Cast(p with { Y = 50f }, -Vector3.UnitY, 100f, out GroundHit top) && p.Y <= top.Point.Y;
        }

        for (int i = 0; i <= Steps; i++)
        {
            double t = length * i / (double)Steps;
            if (Under(t))
            {
                double above = Math.Max(0, length * (i - 1) / (double)Steps);
                for (int k = 0; k < 40 && i > 0; k++)
                {
                    double middle = 0.5 * (above + t);
                    (above, t) = Under(middle) ? (above, middle) : (middle, t);
                }

                return t;
            }
        }

        return null;
    }

    private static IGround Make(string kind)
    {
        const int Side = 11;
        var random = new RandomStream(5);
        var heights = new float[Side * Side];
        var positions = new Vector3[heights.Length];
        for (int i = 0; i < heights.Length; i++)
        {
            heights[i] = (float)random.Uniform(-0.2, 0.2);
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

        return kind switch
        {
            "flat" => FlatGround.Level,
            "field" => new HeightFieldGround(heights, Side, 0.5f, Vector3.Zero),
            _ => new MeshGround(positions, triangles.ToArray()),
        };
    }
}
