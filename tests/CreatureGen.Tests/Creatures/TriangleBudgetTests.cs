using System;
using System.Linq;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Inspection;
using CreatureGen.Sampling;
using CreatureGen.Tests.Gltf;
using Xunit;

namespace CreatureGen.Tests.Creatures;

public sealed class TriangleBudgetTests
{
    public static TheoryData<RequestedKind> Kinds => LodSubjects.Kinds;

    [Theory]
    [MemberData(nameof(Kinds))]
    public void No_creature_has_more_triangles_than_its_budget(RequestedKind kind)
    {
        int reduced = 0;
        for (int seed = 0; seed < LodSubjects.Seeds; seed++)
        {
            CreatureMesh mesh = LodSubjects.Of(kind, seed, 6000).Mesh;
            Assert.True(mesh.Triangles.Length <= 3 * 6000, FormattableString.Invariant($"{kind} {seed}: {mesh.Triangles.Length / 3}"));
            reduced += mesh.Triangles.Length > 3 * 5900 ? 1 : 0;
        }

        Assert.True(reduced > LodSubjects.Seeds / 4);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_creature_cut_to_its_budget_is_sound_and_carries_no_vertex_in_vain(RequestedKind kind)
    {
        for (int seed = 0; seed < 8; seed++)
        {
            CreatureMesh mesh = LodSubjects.Of(kind, seed, 6000).Mesh;
            VertexWelding welding = VertexWelding.Weld(mesh.Positions);
            SurfaceTopology topology = SurfaceTopology.Of(welding.Positions, welding.Apply(mesh.Triangles));
            Assert.True(topology.IsSound, topology.ToString());
            Assert.Equal(mesh.Positions.Length, mesh.Triangles.ToArray().Distinct().Count());
        }
    }

    /// <summary>Where the whole mesh crosses itself what is left of it may do so as well; nowhere else.</summary>
    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_creature_cut_to_its_budget_cuts_through_itself_nowhere_where_the_whole_one_does_not(RequestedKind kind)
    {
        int cut = 0;
        for (ulong seed = 7100000; seed < 7100000 + (ulong)Thoroughness.Of(24); seed++)
        {
            CreatureOptions options = CreatureOptions.Default with { Kind = kind };
            CreatureMesh whole = CreatureGenerator.Generate(seed, options).Mesh;
            CreatureMesh mesh = CreatureGenerator.Generate(seed, options with { TriangleBudget = 6000 }).Mesh;
            if (mesh.Triangles.Length < whole.Triangles.Length && new CrossingCounter(whole, whole.Triangles).Count().All == 0)
            {
                Assert.Equal((seed, default(SurfaceCrossings)), (seed, new CrossingCounter(mesh, mesh.Triangles).Count()));
                Assert.InRange(mesh.Triangles.Length, 3, 3 * 6000);
                cut++;
            }
        }

        Assert.InRange(cut, Thoroughness.Of(6), Thoroughness.Of(24));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void No_creature_exceeds_the_default_budget(RequestedKind kind)
    {
        for (int seed = 0; seed < LodSubjects.Seeds; seed++)
        {
            // A mesh that was cut would differ from that of the largest budget.
            Assert.True(LodSubjects.Of(kind, seed, 100000).Mesh.Triangles.Length <= 3 * CreatureOptions.Default.TriangleBudget);
        }
    }

    [Fact]
    public void A_budget_that_is_met_changes_nothing_of_the_mesh()
    {
        CreatureMesh default20000 = LodSubjects.Of(RequestedKind.Walking, 4).Mesh;
        CreatureMesh large = LodSubjects.Of(RequestedKind.Walking, 4, 100000).Mesh;
        Assert.Equal(large.Triangles.ToArray(), default20000.Triangles.ToArray());
        Assert.Equal(large.Positions.ToArray(), default20000.Positions.ToArray());
    }

    [Fact]
    public void A_budget_changes_neither_the_skeleton_nor_the_colliders_nor_the_mass()
    {
        Creature full = LodSubjects.Of(RequestedKind.Flying, 2);
        Creature cut = LodSubjects.Of(RequestedKind.Flying, 2, 6000);
        Assert.True(cut.Mesh.Triangles.Length < full.Mesh.Triangles.Length);
        Assert.Equal(full.Skeleton.Joints, cut.Skeleton.Joints);
        Assert.Equal(full.Bones, cut.Bones);
        Assert.Equal(full.Body, cut.Body);
        Assert.Equal(full.Mass, cut.Mass);
    }

    [Fact]
    public void A_creature_cut_to_its_budget_has_levels_of_its_own()
    {
        CreatureMesh mesh = LodSubjects.Of(RequestedKind.Walking, 0, 6000).Mesh;
        Assert.InRange(mesh.Lods[1].Triangles.Length / 3, 2880, 3000);
        Assert.InRange(mesh.Lods[3].Triangles.Length / 3, 480, 600);
    }

    [Fact]
    public void A_hand_made_mesh_of_open_fins_keeps_its_outline_and_loses_no_more_than_it_can()
    {
        CreatureMesh mesh = SampleCreature.Build(SampleShape.Of(5)).Mesh;
        CreatureMesh cut = CreatureLods.Within(1, mesh);
        Assert.InRange(cut.Triangles.Length, 3, mesh.Triangles.Length);
        Assert.Same(mesh, CreatureLods.Within(mesh.Triangles.Length / 3, mesh));
    }
}
