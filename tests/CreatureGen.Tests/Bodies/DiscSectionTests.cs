using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Bodies;

/// <summary>The bodies of rays are no tents.</summary>
public sealed class DiscSectionTests
{
    private const int Edge = BodyGrid.Segments / 4;
    private const int Belly = BodyGrid.Segments / 2;

    // Thinnest middle of a disc in its span, and least that its tips are bent up or down by, in the same. The tent that it was is .13 thick and may be level.
    private const double Thinnest = 0.14;
    private const double Bent = 0.07;

    [Fact]
    public void The_middle_of_a_ray_is_a_dome_and_no_ridge()
    {
        foreach ((string name, BodySkin skin, int ring) in Rays())
        {
            float span = 2 * skin[ring, Edge].X;
            float thick = skin[ring, 0].Y - skin[ring, Belly].Y;
            Assert.True(thick > Thinnest * span, FormattableString.Invariant($"{name}: {thick / span:0.000} spans thick"));

            // Of the tent that it was .82 of the height is left here.
            float beside = HeightAt(skin, ring, 0.12f * span / 2) / HeightAt(skin, ring, 0);
            Assert.True(beside > 0.88f, FormattableString.Invariant($"{name}: {beside:0.00} of its height beside the ridge"));
        }
    }

    [Fact]
    public void The_tips_of_a_ray_are_bent_up_or_down()
    {
        foreach ((string name, BodySkin skin, int ring) in Rays())
        {
            float middle = (skin[ring, 0].Y + skin[ring, Belly].Y) / 2;
            float bent = Math.Abs(skin[ring, Edge].Y - middle) / (2 * skin[ring, Edge].X);
            Assert.True(bent > Bent, FormattableString.Invariant($"{name}: tips {bent:0.000} spans off the middle"));
        }
    }

    private static float HeightAt(BodySkin skin, int ring, float x)
    {
        float spine = (float)skin.Shape.Centre(ring).Y;
        int j = 0;
        while (skin[ring, j + 1].X < x)
        {
            j++;
        }

        (Vector3 a, Vector3 b) = (skin[ring, j], skin[ring, j + 1]);
        return a.Y + ((b.Y - a.Y) * (x - a.X) / (b.X - a.X)) - spine;
    }

    private static (string Name, BodySkin Skin, int Widest)[] Rays()
    {
        CreatureOptions options = CreatureOptions.Default with { Kind = RequestedKind.Swimming, BaseBodies = new ValueList<BaseBodyWeight>([new BaseBodyWeight("ray", 1000)]) };
        (string, BodySkin, int)[] rays = Enumerable.Range(22101000, 40)
            .Select(seed => BlueprintSampler.Sample((ulong)seed, options))
            .Where(creature => creature.Body.Disc.Sweep != 0)
            .Select(creature =>
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                int widest = Enumerable.Range(0, StationRing.TailFirst).MaxBy(ring => shape.Width[ring]);
                return (FormattableString.Invariant($"{creature.Seed}"), BodySkin.Span(shape, creature), widest);
            })
            .ToArray();
        Assert.True(rays.Length > 10);
        return rays;
    }
}
