using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Grounds;

public sealed class MeshGroundTests
{
    private const int Triangles = 600;

    [Fact]
    public void A_ray_hits_the_nearest_of_all_triangles_as_trying_each_alone_does()
    {
        (Vector3[] positions, int[] triangles) = Soup();
        var whole = new MeshGround(positions, triangles);
        var each = new List<MeshGround>();
        for (int i = 0; i < triangles.Length; i += 3)
        {
            each.Add(new MeshGround(positions, triangles.AsSpan(i, 3)));
        }

        var random = new RandomStream(8);
        int hits = 0;
        for (int i = 0; i < 2000; i++)
        {
            Vector3 origin = Point(random, 12);
            Vector3 direction = i % 4 == 0 ? Axis(i / 4) : Vector3.Normalize(Point(random, 1));
            bool found = whole.Cast(origin, direction, 30f, out GroundHit hit);
            GroundHit? expected = Nearest(each, origin, direction);
            Assert.Equal(expected.HasValue, found);
            if (found)
            {
                Assert.Equal(expected!.Value, hit);
                hits++;
            }
        }

        Assert.InRange(hits, 400, 1900);
    }

    [Fact]
    public void Of_triangles_in_one_place_the_first_is_hit()
    {
        var positions = new[] { Vector3.Zero, Vector3.UnitZ, Vector3.UnitX };
        int[] triangles = new int[3 * 50];
        int[] surfaces = new int[50];
        for (int i = 0; i < surfaces.Length; i++)
        {
            (triangles[3 * i], triangles[(3 * i) + 1], triangles[(3 * i) + 2]) = (0, 1, 2);
            surfaces[i] = i + 7;
        }

        var ground = new MeshGround(positions, triangles, surfaces);
        Assert.True(ground.Cast(new Vector3(0.2f, 1f, 0.2f), -Vector3.UnitY, 1f, out GroundHit hit));
        Assert.Equal(7, hit.Surface);
    }

    [Fact]
    public void A_ray_that_ends_just_below_a_floor_hits_it()
    {
        var ground = new MeshGround([new(-5f, 0.7f, -5f), new(-5f, 0.7f, 5f), new(5f, 0.7f, 5f), new(5f, 0.7f, -5f)], [0, 1, 2, 0, 2, 3]);
        for (int i = 1; i <= 100; i++)
        {
            float height = 0.7f + (0.37f * i);
            Assert.True(ground.Cast(new Vector3(0.1f, height, 0.3f), -Vector3.UnitY, height - 0.7f + 1e-5f, out _), $"{height}");
        }
    }

    private static GroundHit? Nearest(List<MeshGround> each, Vector3 origin, Vector3 direction)
    {
        GroundHit? nearest = null;
        float least = float.MaxValue;
        foreach (MeshGround one in each)
        {
            if (one.Cast(origin, direction, 30f, out GroundHit hit) && Vector3.Distance(hit.Point, origin) is float distance && distance < least)
            {
                least = distance;
                nearest = hit;
            }
        }

        return nearest;
    }

    private static (Vector3[] Positions, int[] Triangles) Soup()
    {
        var random = new RandomStream(7);
        var positions = new Vector3[3 * Triangles];
        int[] triangles = new int[3 * Triangles];
        for (int i = 0; i < Triangles; i++)
        {
            Vector3 at = Point(random, 10);
            for (int k = 0; k < 3; k++)
            {
                positions[(3 * i) + k] = at + Point(random, 2.5);
                triangles[(3 * i) + k] = (3 * i) + k;
            }
        }

        return (positions, triangles);
    }

    private static Vector3 Point(RandomStream random, double reach) =>
        new((float)random.Uniform(-reach, reach), (float)random.Uniform(-reach, reach), (float)random.Uniform(-reach, reach));

    private static Vector3 Axis(int number) => (number % 3 == 0 ? Vector3.UnitX : number % 3 == 1 ? Vector3.UnitY : Vector3.UnitZ) * (number % 2 == 0 ? 1f : -1f);
}
