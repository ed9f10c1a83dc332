using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Geometry;

public sealed class CrossingGuardTests
{
    /// <summary>Triangles of one piece anywhere: what the guard says is what a search of all pairs finds.</summary>
    [Fact]
    public void It_finds_what_a_search_of_all_pairs_finds()
    {
        RandomStream random = new Seed(3).Stream();
        var crossing = new List<(int First, int Second)>();
        int found = 0;
        for (int trial = 0; trial < 20; trial++)
        {
            const int Count = 40;
            Vector3 Anywhere() => new((float)random.Uniform(), (float)random.Uniform(), (float)random.Uniform());
            var positions = new Vector3[3 * Count];
            for (int t = 0; t < Count; t++)
            {
                Vector3 centre = Anywhere();
                float size = t % 10 == 0 ? 1f : 0.4f;
                for (int k = 0; k < 3; k++)
                {
                    positions[(3 * t) + k] = centre + (size * Anywhere());
                }
            }

            int[] points = Enumerable.Range(0, 3 * Count).ToArray();
            var surface = new CollapsingMesh(positions, new Vector3[3 * Count], points, (int[])points.Clone());
            var guard = new CrossingGuard(surface, positions, points, new int[3 * Count], new bool[Count]);
            SelfIntersection.Find(positions, points, crossing);
            for (int t = 0; t < Count; t++)
            {
                bool expected = crossing.Any(pair => pair.First == t || pair.Second == t);
                Assert.Equal(expected, guard.Cross([t], points[3 * t], points[3 * t]));
                found += expected ? 1 : 0;
            }
        }

        Assert.InRange(found, 50, 790);
    }

    [Fact]
    public void Triangles_of_other_pieces_and_those_with_a_common_point_do_not_count()
    {
        Vector3[] positions = [new(0, 0, 0), new(2, 0, 0), new(0, 2, 0), new(0.5f, 0.5f, -1), new(0.5f, 0.5f, 1), new(3, 3, 0)];
        int[] apart = [0, 1, 2, 3, 4, 5];
        Assert.True(Guard(positions, apart, new int[6]).Cross([0], 0, 0));
        Assert.False(Guard(positions, apart, [0, 0, 0, 1, 1, 1]).Cross([0], 0, 0));
        Assert.False(Guard(positions, [0, 1, 2, 3, 4, 1], new int[6]).Cross([0], 0, 0));
    }

    /// <summary>Corners that a step has moved count where they are now, however far they have gone.</summary>
    [Fact]
    public void What_has_moved_counts_where_it_is()
    {
        Vector3[] near = [new(0.5f, 0.5f, -1), new(0.5f, 0.5f, 1), new(3, 3, 0)];
        Vector3[] positions = [new(0, 0, 0), new(2, 0, 0), new(0, 2, 0), .. near, .. near.Select(p => p + (10f * Vector3.UnitX))];
        int[] points = [0, 1, 2, 3, 4, 5];
        CrossingGuard guard = Guard(positions, points, new int[9]);
        for (int i = 0; i < 200; i++)
        {
            for (int c = 3; c < 6; c++)
            {
                points[c] = i % 2 == 0 ? c + 3 : c;
            }

            guard.Note([1], []);
            Assert.Equal(i % 2 == 1, guard.Cross([0], 0, 0));
        }
    }

    /// <summary>A ball with a needle through it loses point after point, so that the tree is built anew several times: what the guard says is what a search of all that is left finds.</summary>
    [Fact]
    public void What_is_left_counts_and_what_has_gone_does_not()
    {
        const int Rings = 16;
        const int Sectors = 24;
        List<Vector3> ball = [Vector3.Zero, new(0.01f, 0, 0), new(0.4f, 0.3f, 3)];
        List<int> corners = [0, 1, 2];
        for (int ring = 0; ring < Rings; ring++)
        {
            for (int sector = 0; sector < Sectors; sector++)
            {
                double turn = Math.Tau * sector / Sectors;
                double height = Math.PI * (ring + 1) / (Rings + 1);
                ball.Add(new Vector3((float)(Math.Cos(turn) * Math.Sin(height)), (float)Math.Cos(height), (float)(Math.Sin(turn) * Math.Sin(height))));
                int here = 3 + (Sectors * ring) + sector;
                int beside = 3 + (Sectors * ring) + ((sector + 1) % Sectors);
                corners.AddRange(ring + 1 < Rings ? [here, beside, beside + Sectors, here, beside + Sectors, here + Sectors] : []);
            }
        }

        Vector3[] positions = ball.ToArray();
        int[] points = corners.ToArray();
        var surface = new CollapsingMesh(positions, new Vector3[positions.Length], points, corners.ToArray());
        var guard = new CrossingGuard(surface, positions, points, new int[positions.Length], new bool[points.Length / 3]);
        var crossing = new List<(int First, int Second)>();
        var moved = new List<int>();
        var lost = new List<int>();
        int all = surface.Triangles;
        for (int from = 3; from + 1 < positions.Length; from++)
        {
            if (surface.IsUsed(from + 1) && surface.Allows(from, from + 1))
            {
                surface.Collapse(from, from + 1, [(from, from + 1)]);
                surface.Taken(moved, lost);
                guard.Note(moved, lost);
                int[] left = Enumerable.Range(0, points.Length).Where(c => !surface.IsGone(c / 3)).Select(c => points[c]).ToArray();
                SelfIntersection.Find(positions, left, crossing);
                Assert.Equal(crossing.Any(pair => pair.First == 0), guard.Cross([0], 0, 0));
            }
        }

        Assert.InRange(surface.Triangles, 3, all / 2);
    }

    private static CrossingGuard Guard(Vector3[] positions, int[] points, int[] pieces) =>
        new(new CollapsingMesh(positions, new Vector3[positions.Length], points, (int[])points.Clone()), positions, points, pieces, new bool[points.Length / 3]);
}
