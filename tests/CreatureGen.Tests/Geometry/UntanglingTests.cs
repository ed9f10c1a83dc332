using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class UntanglingTests
{
    [Fact]
    public void Crossings_of_both_sides_are_counted_though_the_left_is_looked_at_first()
    {
        Assert.Equal(2, PairsBefore([new(1, 0, 0), new(3, 0, 0), new(2, 2, 0), new(2, 1, -1), new(2, 1, 1), new(2.2f, -1, 0)]));
    }

    [Fact]
    public void A_triangle_that_reaches_across_the_plane_is_found_to_cross_its_image()
    {
        Assert.Equal(1, PairsBefore([new(-0.5f, 0, 0), new(1, 0, 0.2f), new(1, 1, -0.2f)]));
    }

    [Fact]
    public void Sides_that_only_meet_in_the_plane_do_not_cross()
    {
        Assert.Equal(0, PairsBefore([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)]));
    }

    [Theory]
    [InlineData(LocomotionKind.Walking)]
    [InlineData(LocomotionKind.Flying, Explicit = true)]
    [InlineData(LocomotionKind.Swimming, Explicit = true)]
    public void Every_triangle_of_a_grown_surface_has_its_image_and_none_reaches_across_the_plane(LocomotionKind kind)
    {
        for (ulong seed = 0; seed < 40; seed++)
        {
            Surface surface = GrownSurface.Grow(BlueprintSampler.Sample(seed, kind)).Surface;
            int[] mirror = surface.Mirror;
            var triangles = surface.Triangles.ToArray().Chunk(3).Select(t => FromMin(t[0], t[1], t[2])).ToHashSet();
            foreach (int[] t in surface.Triangles.ToArray().Chunk(3))
            {
                Assert.Contains(FromMin(mirror[t[0]], mirror[t[2]], mirror[t[1]]), triangles);
                float[] x = Array.ConvertAll(t, v => surface.Positions[v].X);
                Assert.True(x.Min() >= 0f != x.Max() <= 0f, FormattableString.Invariant($"{kind} {seed}: a triangle from x = {x.Min()} to {x.Max()}"));
            }
        }
    }

    [Theory]
    [InlineData(LocomotionKind.Walking)]
    [InlineData(LocomotionKind.Flying, Explicit = true)]
    [InlineData(LocomotionKind.Swimming, Explicit = true)]
    public void As_many_crossings_are_found_as_in_a_search_of_the_whole(LocomotionKind kind)
    {
        int crossed = 0;
        for (ulong seed = 0; seed < 6; seed++)
        {
            Surface surface = GrownSurface.Grow(BlueprintSampler.Sample(seed, kind)).Surface;
            foreach (float squeeze in new[] { 0f, 0.6f, 1.6f })
            {
                // Bends the sides in on themselves, and in the end across the plane.
                Vector3[] bent = Array.ConvertAll(surface.Positions, p => new Vector3(p.X - (squeeze * p.X * Math.Abs(p.X) * 4f), p.Y, p.Z));
                int whole = SelfIntersection.Find(bent, surface.Triangles, new List<(int, int)>());
                UntanglingReport report = Untangling.Repair(bent, surface.Triangles, surface.Mirror, default, default, new CrossingPairs());
                Assert.Equal(whole, report.PairsBefore);
                crossed += whole > 0 ? 1 : 0;
            }
        }

        Assert.True(crossed > 3);
    }

    /// <summary>Crossing pairs of triangles, three corners each, and their images.</summary>
    private static int PairsBefore(Vector3[] left)
    {
        Vector3[] positions = [.. left, .. left.Select(p => new Vector3(-p.X, p.Y, p.Z))];
        int[] triangles = [.. Enumerable.Range(0, left.Length), .. Enumerable.Range(0, left.Length).Select(i => left.Length + (i / 3 * 3) + (2 - (i % 3)))];
        int[] mirror = [.. Enumerable.Range(left.Length, left.Length), .. Enumerable.Range(0, left.Length)];
        Assert.Equal(SelfIntersection.Find(positions, triangles, new List<(int, int)>()), Untangling.Repair(positions.ToArray(), triangles, mirror, default, default, new CrossingPairs()).PairsBefore);
        return SelfIntersection.Find(positions, triangles, new List<(int, int)>());
    }

    private static (int, int, int) FromMin(int a, int b, int c) => a < b && a < c ? (a, b, c) : b < c ? (b, c, a) : (c, a, b);
}
