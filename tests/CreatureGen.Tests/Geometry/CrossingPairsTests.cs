using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Maths;
using CreatureGen.Sampling;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class CrossingPairsTests
{
    /// <summary>Some points of a creature's skin are thrown about, time and again, so that triangles come to cross and cease to.</summary>
    [Theory]
    [InlineData(LocomotionKind.Walking)]
    [InlineData(LocomotionKind.Flying)]
    [InlineData(LocomotionKind.Swimming)]
    public void Looking_again_where_points_moved_finds_what_a_search_of_the_whole_finds(LocomotionKind kind)
    {
        RandomStream random = new Seed(5).Stream();
        var search = new CrossingPairs();
        var whole = new List<(int First, int Second)>();
        int most = 0;
        for (ulong seed = 0; seed < 4; seed++)
        {
            Surface surface = GrownSurface.Grow(BlueprintSampler.Sample(seed, kind)).Surface;
            Vector3[] positions = surface.Positions;
            search.Find(positions, surface.Triangles, surface.Mirror);
            for (int round = 0; round < 8; round++)
            {
                bool[] moved = new bool[positions.Length];
                int first = random.Integer(0, positions.Length - 1);
                foreach (int v in Enumerable.Range(first, 30).Where(v => v < positions.Length))
                {
                    moved[v] = true;
                    positions[v] += 0.03f * new Vector3((float)random.Uniform() - 0.5f, (float)random.Uniform() - 0.5f, (float)random.Uniform() - 0.5f);
                }

                search.FindAgain(positions, surface.Triangles, surface.Mirror, moved);
                SelfIntersection.Find(positions, surface.Triangles, whole);
                Assert.Equal(whole, search.Pairs);
                most = Math.Max(most, whole.Count);
            }
        }

        Assert.True(most > 50, $"only {most} pairs crossed");
    }

    /// <summary>The same with the left and the right alike, as repairs move them: then the right is told by the left.</summary>
    [Theory]
    [InlineData(LocomotionKind.Walking)]
    [InlineData(LocomotionKind.Flying)]
    [InlineData(LocomotionKind.Swimming)]
    public void Of_two_sides_that_are_images_of_one_another_all_pairs_are_found(LocomotionKind kind)
    {
        RandomStream random = new Seed(6).Stream();
        var search = new CrossingPairs();
        var whole = new List<(int First, int Second)>();
        int most = 0;
        for (ulong seed = 0; seed < 4; seed++)
        {
            Surface surface = GrownSurface.Grow(BlueprintSampler.Sample(seed, kind)).Surface;
            for (int round = 0; round < 8; round++)
            {
                bool[] moved = new bool[surface.Positions.Length];
                int first = random.Integer(0, moved.Length - 1);
                foreach (int v in Enumerable.Range(first, 40).Where(v => v < moved.Length && surface.Positions[v].X > 0f))
                {
                    Vector3 way = 0.03f * new Vector3((float)random.Uniform() - 0.5f, (float)random.Uniform() - 0.5f, (float)random.Uniform() - 0.5f);
                    Vector3 place = surface.Positions[v] + way;
                    surface.Positions[v] = place with { X = Math.Max(place.X, 0.5f * surface.Positions[v].X) };
                    surface.Positions[surface.Mirror[v]] = Vec.Mirror(surface.Positions[v]);
                    moved[v] = moved[surface.Mirror[v]] = true;
                }

                SelfIntersection.Find(surface.Positions, surface.Triangles, whole);
                if (round % 2 == 0)
                {
                    search.Find(surface.Positions, surface.Triangles, surface.Mirror);
                }
                else
                {
                    search.FindAgain(surface.Positions, surface.Triangles, surface.Mirror, moved);
                }

                Assert.Equal(whole, search.Pairs);
                most = Math.Max(most, whole.Count);
            }
        }

        Assert.True(most > 50, $"only {most} pairs crossed");
    }
}
