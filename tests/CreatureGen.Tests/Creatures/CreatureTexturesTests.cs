using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Creatures;

public sealed class CreatureTexturesTests
{
    private const int Size = 512;

    public static IEnumerable<TheoryDataRow<LocomotionKind, ulong>> Creatures =>
    [
        new(LocomotionKind.Walking, 22),
        new(LocomotionKind.Walking, 7) { Explicit = true },
        new(LocomotionKind.Walking, 6) { Explicit = true },
        new(LocomotionKind.Flying, 2),
        new(LocomotionKind.Flying, 5) { Explicit = true },
        new(LocomotionKind.Swimming, 3),
    ];

    [Theory]
    [InlineData(0)]
    [InlineData(128)]
    [InlineData(1000)]
    [InlineData(8192)]
    [InlineData(-512)]
    public void A_size_that_is_no_power_of_two_in_range_is_refused(int size)
    {
        Creature creature = CreatureGenerator.Generate(1);
        Assert.Throws<ArgumentOutOfRangeException>(() => CreatureTextures.Bake(creature, size));
    }

    [Theory]
    [MemberData(nameof(Creatures))]
    public void The_same_creature_gives_the_same_bytes(LocomotionKind kind, ulong seed)
    {
        CreatureTextures first = Bake(kind, seed, out _);
        CreatureTextures second = Bake(kind, seed, out _);
        Assert.True(first.BaseColour.SequenceEqual(second.BaseColour));
        Assert.True(first.Normal.SequenceEqual(second.Normal));
        Assert.True(first.Roughness.SequenceEqual(second.Roughness));
    }

    /// <summary>Charts once began right below them: a row of white dots ran over the nape.</summary>
    [Theory]
    [MemberData(nameof(Creatures))]
    public void Charts_keep_two_texels_of_the_smallest_picture_clear_of_the_plain_texels(LocomotionKind kind, ulong seed)
    {
        const float Clear = 2f / 256f;
        Vector2 corner = (8 * (ChartPacking.Swatch(1) - ChartPacking.Swatch(0))) + new Vector2(0, 2 * ChartPacking.Swatch(0).Y);
        foreach (Vector2 at in CreatureGenerator.Build(BlueprintSampler.Sample(seed, kind)).Mesh.Texcoords)
        {
            Assert.True(ChartPacking.IsSwatch(at) || Math.Max(at.X - corner.X, at.Y - corner.Y) > 0.999f * Clear, $"{kind} {seed} at {at}");
        }
    }

    [Theory]
    [MemberData(nameof(Creatures))]
    public void Normals_are_of_unit_length_and_point_outwards(LocomotionKind kind, ulong seed)
    {
        ReadOnlySpan<byte> normal = Bake(kind, seed, out _).Normal;
        for (int i = 0; i < normal.Length; i += 3)
        {
            var n = new Vector3(normal[i] - 128, normal[i + 1] - 128, normal[i + 2] - 128);
            Assert.InRange(n.Length(), 124f, 131f);
            Assert.True(n.Z > 20f);
        }
    }

    [Theory]
    [MemberData(nameof(Creatures))]
    public void At_the_vertices_the_texture_is_near_the_vertex_colours(LocomotionKind kind, ulong seed)
    {
        CreatureTextures textures = Bake(kind, seed, out Creature creature);
        CreatureMesh mesh = creature.Mesh;
        double sum = 0;
        int count = 0;
        for (int v = 0; v < mesh.Positions.Length; v++)
        {
            Vector2 t = mesh.Texcoords[v];
            if (CreatureTextures.KeepsItsColour(t))
            {
                continue;
            }

            int texel = 3 * (((int)(t.Y * Size) * Size) + (int)(t.X * Size));
            for (int c = 0; c < 3; c++)
            {
                float linear = c == 0 ? mesh.Colours[v].X : c == 1 ? mesh.Colours[v].Y : mesh.Colours[v].Z;
                sum += Math.Abs(Encoded(linear) - (textures.BaseColour[texel + c] / 255.0));
                count++;
            }
        }

        // Patterns and relief are finer than the mesh; on the whole the two agree.
        Assert.True(count > 3000);
        Assert.InRange(sum / count, 0, 0.09);
    }

    [Fact]
    public void Scales_leave_a_relief_and_plain_ground_none()
    {
        ReadOnlySpan<byte> normal = Bake(LocomotionKind.Walking, 7, out _).Normal;
        int tilted = 0;
        int flat = 0;
        for (int i = 0; i < normal.Length; i += 3)
        {
            bool level = normal[i] == 128 && normal[i + 1] == 128;
            flat += level ? 1 : 0;
            tilted += Math.Abs(normal[i] - 128) > 16 || Math.Abs(normal[i + 1] - 128) > 16 ? 1 : 0;
        }

        Assert.True(tilted > Size * Size / 20);
        Assert.True(flat > 0);
    }

    [Fact]
    public void Charts_keep_apart_and_fill_most_of_the_picture()
    {
        for (ulong seed = 0; seed < 20; seed++)
        {
            Creature creature = CreatureGenerator.Generate(seed);
            var covered = new HashSet<(int, int)>();
            CreatureMesh mesh = creature.Mesh;
            double area = 0;
            for (int i = 0; i < mesh.Triangles.Length; i += 3)
            {
                Vector2 a = mesh.Texcoords[mesh.Triangles[i]], b = mesh.Texcoords[mesh.Triangles[i + 1]], c = mesh.Texcoords[mesh.Triangles[i + 2]];
                foreach (Vector2 t in new[] { a, b, c })
                {
                    Assert.InRange(t.X, 0f, 1f);
                    Assert.InRange(t.Y, 0f, 1f);
                }

                area += Math.Abs(((b.X - a.X) * (c.Y - a.Y)) - ((b.Y - a.Y) * (c.X - a.X))) / 2;
            }

            // Left and right share their texels, so the area counts about twice.
            Assert.InRange(area / 2, 0.3, 1.0);
        }
    }

    private static CreatureTextures Bake(LocomotionKind kind, ulong seed, out Creature creature)
    {
        creature = CreatureGenerator.Build(BlueprintSampler.Sample(seed, kind));
        return CreatureTextures.Bake(creature, Size);
    }

    private static double Encoded(double linear) => linear <= 0.0031308 ? 12.92 * linear : (1.055 * Math.Pow(linear, 1 / 2.4)) - 0.055;
}
