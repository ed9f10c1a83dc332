using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Inspection;
using CreatureGen.Maths;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Creatures;

public sealed class CreatureLodsTests
{
    public static TheoryData<RequestedKind> Kinds => LodSubjects.Kinds;

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Every_level_is_a_sound_closed_surface_of_its_share_of_the_triangles(RequestedKind kind)
    {
        for (int seed = 0; seed < LodSubjects.Seeds; seed++)
        {
            CreatureMesh mesh = LodSubjects.Of(kind, seed).Mesh;
            int all = mesh.Triangles.Length / 3;
            int turnedAway = TurnedAway(mesh, mesh.Triangles);
            VertexWelding whole = VertexWelding.Weld(mesh.Positions);
            var pieces = new SurfacePieces(whole.Positions.ToArray(), whole.Apply(mesh.Triangles));
            int[] left = Counts(mesh.Triangles);
            for (int i = 0; i < mesh.Lods.Count; i++)
            {
                CreatureLod level = mesh.Lods[i];
                string what = FormattableString.Invariant($"{kind} {seed} level {i}");
                int triangles = level.Triangles.Length / 3;

                // A step takes two mirrored pairs of triangles; the loss of a piece and of its mirror image what was left of them.
                int[] now = Counts(level.Triangles);
                int lost = Enumerable.Range(0, now.Length).Max(piece => now[piece] == 0 ? left[piece] : 0);
                left = now;
                Assert.InRange(triangles, (all * CreatureLods.Fractions[i]) - Math.Max(4, 2 * lost), all * CreatureLods.Fractions[i]);
                CreatureMesh alone = level.ToMesh();
                VertexWelding welding = VertexWelding.Weld(alone.Positions);
                SurfaceTopology topology = SurfaceTopology.Of(welding.Positions, welding.Apply(alone.Triangles));
                Assert.True(topology.IsSound, what + ": " + topology);
                Assert.True(TurnedAway(mesh, level.Triangles) <= turnedAway, what);
                var places = new HashSet<Vector3>(welding.Positions.ToArray());
                Assert.All(places, p => Assert.Contains(new Vector3(0f - p.X, p.Y, p.Z), places));
            }

            int[] Counts(ReadOnlySpan<int> corners)
            {
                int[] counts = new int[pieces.PieceOf.Length];
                ReadOnlySpan<int> welded = whole.Apply(corners);
                for (int c = 0; c < welded.Length; c += 3)
                {
                    counts[pieces.PieceOf[welded[c]]]++;
                }

                return counts;
            }
        }
    }

    /// <summary>Where the finest level crosses itself a coarser one may do so as well; nowhere else.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void No_level_cuts_through_itself_where_the_finest_does_not(RequestedKind kind)
    {
        int without = 0;
        for (ulong seed = 7100000; seed < 7100000 + (ulong)Thoroughness.Of(12); seed++)
        {
            CreatureMesh mesh = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }).Mesh;
            SurfaceCrossings finest = new CrossingCounter(mesh, mesh.Triangles).Count();
            without += finest.All == 0 ? 1 : 0;
            for (int i = 1; i < mesh.Lods.Count && finest.All == 0; i++)
            {
                Assert.Equal((seed, i, default(SurfaceCrossings)), (seed, i, new CrossingCounter(mesh, mesh.Lods[i].Triangles).Count()));
            }
        }

        Assert.InRange(without, Thoroughness.Of(9), Thoroughness.Of(12));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Each_level_keeps_some_of_the_vertices_of_the_one_before(RequestedKind kind)
    {
        CreatureMesh mesh = LodSubjects.Of(kind, 11).Mesh;
        Assert.Equal(mesh.Triangles.ToArray(), mesh.Lods[0].Triangles.ToArray());
        Assert.Equal(Enumerable.Range(0, mesh.Positions.Length), mesh.Lods[0].Remap.ToArray());
        for (int i = 1; i < mesh.Lods.Count; i++)
        {
            var finer = new HashSet<int>(mesh.Lods[i - 1].Triangles.ToArray());
            Assert.Subset(finer, new HashSet<int>(mesh.Lods[i].Triangles.ToArray()));
        }
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Remapping_all_triangles_and_leaving_out_those_that_vanish_gives_the_level(RequestedKind kind)
    {
        for (int seed = 20; seed < 20 + Thoroughness.Of(6); seed++)
        {
            CreatureMesh mesh = LodSubjects.Of(kind, seed).Mesh;
            for (int i = 0; i < mesh.Lods.Count; i++)
            {
                CreatureLod level = mesh.Lods[i];
                int[] remap = level.Remap.ToArray();
                Assert.All(level.Triangles.ToArray(), v => Assert.Equal(v, remap[v]));
                var kept = new List<int>();
                foreach (int[] corners in mesh.Triangles.ToArray().Chunk(3))
                {
                    int[] moved = Array.ConvertAll(corners, v => remap[v]);
                    Vector3[] places = moved.Where(v => v >= 0).Select(v => mesh.Positions[v]).Distinct().ToArray();
                    if (places.Length == 3)
                    {
                        kept.AddRange(moved);
                    }
                }

                Assert.Equal(Triples(level.Triangles.ToArray()), Triples(kept));
            }
        }
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void No_place_of_the_finest_level_is_far_from_a_vertex_that_stands_for_it(RequestedKind kind)
    {
        for (int seed = 0; seed < Thoroughness.Of(12); seed++)
        {
            CreatureMesh mesh = LodSubjects.Of(kind, seed).Mesh;
            double diagonal = PointBounds.Of(mesh.Positions).Diagonal;
            double[] limits = { 0, 0.08, 0.15, 0.25 };
            for (int i = 0; i < mesh.Lods.Count; i++)
            {
                ReadOnlySpan<int> remap = mesh.Lods[i].Remap;
                for (int v = 0; v < remap.Length; v++)
                {
                    if (remap[v] >= 0)
                    {
                        Assert.True(Vec.Distance(mesh.Positions[v], mesh.Positions[remap[v]]) <= limits[i] * diagonal, FormattableString.Invariant($"{kind} {seed} level {i} vertex {v}"));
                    }
                }
            }
        }
    }

    [Fact]
    public void A_level_groups_its_triangles_by_the_materials_of_the_mesh()
    {
        CreatureMesh mesh = Enumerable.Range(0, 40).Select(s => LodSubjects.Of(RequestedKind.Flying, s).Mesh).First(m => m.Parts.Count == 2);
        var membrane = new HashSet<int>(mesh.Triangles.Slice(mesh.Parts[1].FirstIndex, mesh.Parts[1].IndexCount).ToArray());
        for (int i = 0; i < mesh.Lods.Count; i++)
        {
            CreatureLod level = mesh.Lods[i];
            Assert.Equal([MaterialKind.Skin, MaterialKind.Membrane], level.Parts.Select(p => p.Material));
            Assert.Equal(level.Triangles.Length, level.Parts.Sum(p => p.IndexCount));
            Assert.All(level.Triangles.Slice(level.Parts[1].FirstIndex, level.Parts[1].IndexCount).ToArray(), v => Assert.Contains(v, membrane));
        }
    }

    [Fact]
    public void The_same_mesh_gives_the_same_levels_and_gives_them_once()
    {
        CreatureMesh mesh = LodSubjects.Of(RequestedKind.Walking, 5).Mesh;
        CreatureMesh same = LodSubjects.Of(RequestedKind.Walking, 5).Mesh;
        Assert.Same(mesh.Lods, mesh.Lods);
        for (int i = 0; i < mesh.Lods.Count; i++)
        {
            Assert.Equal(mesh.Lods[i].Triangles.ToArray(), same.Lods[i].Triangles.ToArray());
        }
    }

    [Fact]
    public void A_mesh_of_a_level_has_only_the_vertices_that_it_uses()
    {
        CreatureMesh mesh = LodSubjects.Of(RequestedKind.Swimming, 3).Mesh;
        CreatureLod level = mesh.Lods[2];
        CreatureMesh alone = level.ToMesh();
        int[] used = level.Triangles.ToArray().Distinct().Order().ToArray();
        Assert.Equal(used.Length, alone.Positions.Length);
        for (int i = 0; i < used.Length; i++)
        {
            Assert.Equal(mesh.Positions[used[i]], alone.Positions[i]);
            Assert.Equal(mesh.Normals[used[i]], alone.Normals[i]);
            Assert.Equal(mesh.Texcoords[used[i]], alone.Texcoords[i]);
            Assert.Equal(mesh.Colours[used[i]], alone.Colours[i]);
            Assert.Equal(mesh.Weights[used[i]], alone.Weights[i]);
        }

        Assert.Equal(level.Triangles.ToArray(), alone.Triangles.ToArray().Select(v => used[v]));
    }

    [Fact]
    public void Eyes_outlast_what_is_larger_than_they_are()
    {
        for (int seed = 0; seed < Thoroughness.Of(12); seed++)
        {
            Creature creature = LodSubjects.Of(RequestedKind.Walking, seed);
            int[] eyes = Enumerable.Range(0, creature.Mesh.Weights.Length).Where(v => creature.Skeleton.Joints[creature.Mesh.Weights[v].Joint0].Name == "Eye_L").ToArray();
            ReadOnlySpan<int> remap = creature.Mesh.Lods[3].Remap;
            int kept = 0;
            foreach (int v in eyes)
            {
                kept += remap[v] == v ? 1 : 0;
            }

            Assert.True(kept >= 4, FormattableString.Invariant($"{seed}: {kept} of {eyes.Length}"));
        }
    }

    [Fact]
    public void An_empty_mesh_has_empty_levels()
    {
        var mesh = new CreatureMesh([], [], [], [], [], [], []);
        Assert.Equal(4, mesh.Lods.Count);
        Assert.Equal(0, mesh.Lods[3].Triangles.Length);
    }

    [Fact]
    public void A_level_that_there_is_not_is_refused_by_name()
    {
        CreatureLods levels = LodSubjects.Of(RequestedKind.Swimming, 1).Mesh.Lods;
        Assert.StartsWith("level 4; expected 0..3", Assert.Throws<ArgumentOutOfRangeException>(() => levels[4]).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => levels[-1]);
    }

    /// <summary>Triangles that look away from the mean of the normals of their corners.</summary>
    private static int TurnedAway(CreatureMesh mesh, ReadOnlySpan<int> triangles)
    {
        int count = 0;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            Vector3 a = mesh.Positions[triangles[t]];
            Vector3 normal = Vec.Cross(mesh.Positions[triangles[t + 1]] - a, mesh.Positions[triangles[t + 2]] - a);
            count += Vec.Dot(normal, mesh.Normals[triangles[t]] + mesh.Normals[triangles[t + 1]] + mesh.Normals[triangles[t + 2]]) <= 0f ? 1 : 0;
        }

        return count;
    }

    private static (int, int, int)[] Triples(IEnumerable<int> indices) => indices.Chunk(3).Select(t => (t[0], t[1], t[2])).Order().ToArray();
}
