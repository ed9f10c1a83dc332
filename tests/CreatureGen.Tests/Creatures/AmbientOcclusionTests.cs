using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Creatures;

public sealed class AmbientOcclusionTests
{
    private const int Size = 512;

    [Fact]
    public void No_creature_is_refused() => Assert.Throws<ArgumentNullException>(() => CreatureTextures.AmbientOcclusionOf(null!));

    /// <summary>A sphere of radius r, whose middle lies d straight ahead, hides r²/d² of the sky; the share fades to nought at four radii.</summary>
    [Theory]
    [InlineData(1f, 1f, 0.25f)]
    [InlineData(2f, 1f, 0.85f)]
    [InlineData(2f, 0f, 1f)]
    [InlineData(2f, -1f, 1f)]
    [InlineData(4f, 1f, 1f)]
    [InlineData(100f, 1f, 1f)]
    public void One_ball_hides_what_the_formula_says(float distance, float facing, float open)
    {
        Creature creature = CreatureGenerator.Generate(1);
        Creature ball = creature with { Bones = [new CapsuleCollider(0, Vector3.Zero, Vector3.Zero, 1f)] };
        Vector3 place = creature.Skeleton.ModelPositions[0] - new Vector3(0f, 0f, distance);
        var normal = new Vector3((float)Math.Sqrt(1 - (facing * facing)), 0f, facing);
        Assert.Equal(open, AmbientOcclusion.Of(ball).At(place, normal), 0.001f);
    }

    [Theory]
    [InlineData(LocomotionKind.Walking)]
    [InlineData(LocomotionKind.Flying)]
    [InlineData(LocomotionKind.Swimming)]
    public void Light_is_a_share_and_the_same_on_both_sides(LocomotionKind kind)
    {
        for (ulong seed = 0; seed < 20; seed++)
        {
            Creature creature = CreatureGenerator.Build(BlueprintSampler.Sample(seed, kind));
            AmbientOcclusion occlusion = AmbientOcclusion.Of(creature);
            CreatureMesh mesh = creature.Mesh;
            float[] open = CreatureTextures.AmbientOcclusionOf(creature);
            for (int v = 0; v < open.Length; v++)
            {
                Assert.InRange(open[v], 0.2f, 1f);
                Assert.Equal(open[v], occlusion.At(Mirrored(mesh.Positions[v]), Mirrored(mesh.Normals[v])), 1e-3f);
            }

            Assert.InRange(open.Average(), 0.75f, 0.999f);
        }
    }

    [Fact]
    public void Skin_that_looks_at_the_other_legs_is_darker_than_skin_that_looks_away()
    {
        int seen = 0;
        for (ulong seed = 0; seed < 40; seed++)
        {
            Creature creature = CreatureGenerator.Build(BlueprintSampler.Sample(seed, LocomotionKind.Walking));
            if (creature.Limbs.Count(limb => limb.Stands) != 4)
            {
                continue;
            }

            seen++;
            CreatureMesh mesh = creature.Mesh;
            float[] open = CreatureTextures.AmbientOcclusionOf(creature);
            int[] legs = creature.Limbs.Where(limb => limb.Stands).SelectMany(limb => limb.Joints).ToArray();
            double inside = Mean(v => mesh.Normals[v].X * mesh.Positions[v].X < 0f);
            double outside = Mean(v => mesh.Normals[v].X * mesh.Positions[v].X > 0f);
            Assert.True(inside < outside - 0.01, $"seed {seed}: {inside} of the light inside, {outside} outside");

            double Mean(Func<int, bool> chosen) => Enumerable.Range(0, open.Length)
                .Where(v => legs.Contains(mesh.Weights[v].Joint0) && Math.Abs(mesh.Normals[v].X) > 0.7f && chosen(v))
                .Average(v => (double)open[v]);
        }

        Assert.True(seen > 10);
    }

    [Theory]
    [InlineData(LocomotionKind.Walking, 22)]
    [InlineData(LocomotionKind.Swimming, 3)]
    public void The_atlas_has_it_in_red(LocomotionKind kind, ulong seed)
    {
        Creature creature = CreatureGenerator.Build(BlueprintSampler.Sample(seed, kind));
        CreatureTextures textures = CreatureTextures.Bake(creature, Size);
        CreatureMesh mesh = creature.Mesh;
        float[] open = CreatureTextures.AmbientOcclusionOf(creature);
        double sum = 0;
        int count = 0;
        for (int v = 0; v < open.Length; v++)
        {
            Vector2 t = mesh.Texcoords[v];
            int red = textures.Roughness[3 * (((int)(t.Y * Size) * Size) + (int)(t.X * Size))];
            if (CreatureTextures.KeepsItsColour(t))
            {
                Assert.Equal(255, red);
                continue;
            }

            sum += Math.Abs((red / 255.0) - open[v]);
            count++;
        }

        Assert.InRange(sum / count, 0, 0.02);
    }

    private static Vector3 Mirrored(Vector3 v) => new(-v.X, v.Y, v.Z);
}
