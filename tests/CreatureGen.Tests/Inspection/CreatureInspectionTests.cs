using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Inspection;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Inspection;

/// <summary>Each invariant is broken on purpose in a sound creature: an inspection that cannot fail is worth nothing.</summary>
public sealed class CreatureInspectionTests
{
    private static readonly Creature Sound = CreatureGenerator.Build(BlueprintSampler.Sample(7, CreatureOptions.Default with { BodyPlans = BodyPlanWeight.Only(BodyPlan.Digitigrade) }));

    [Fact]
    public void A_sound_creature_has_no_violation()
    {
        Assert.Empty(CreatureInspection.Inspect(Sound));
        Assert.Equal(0, CreatureInspection.CountSelfIntersections(Sound));
    }

    [Fact]
    public void Every_violation_names_a_listed_invariant()
    {
        Assert.Equal(CreatureInspection.Invariants.Count, CreatureInspection.Invariants.Distinct(StringComparer.Ordinal).Count());
        Creature broken = WithMesh((p, _, t) => t[0] = t[3]);
        Assert.All(CreatureInspection.Inspect(broken), violation => Assert.Contains(violation.Invariant, CreatureInspection.Invariants));
    }

    [Theory]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void A_position_that_is_not_finite_is_found_and_nothing_else_is_measured(float value)
    {
        Creature broken = WithMesh((p, _, _) => p[17].X = value);
        InvariantViolation violation = Assert.Single(CreatureInspection.Inspect(broken));
        Assert.Equal("finite", violation.Invariant);
        Assert.Contains("vertex 17", violation.Detail, StringComparison.Ordinal);
    }

    [Fact]
    public void A_missing_triangle_leaves_the_surface_open()
    {
        Creature broken = WithMesh((_, _, t) => (t[0], t[1], t[2]) = (t[3], t[4], t[5]));
        Assert.Contains(CreatureInspection.Inspect(broken), violation => violation.Invariant == "closed");
    }

    [Fact]
    public void A_triangle_that_is_turned_over_is_found()
    {
        Creature broken = WithMesh((_, _, t) => (t[1], t[2]) = (t[2], t[1]));
        Assert.Contains("edges wound against each other", Found(broken, "closed"), StringComparison.Ordinal);
    }

    [Fact]
    public void A_surface_that_is_inside_out_has_no_volume_to_speak_of()
    {
        Creature broken = WithMesh((_, _, t) =>
        {
            for (int i = 0; i < t.Length; i += 3)
            {
                (t[i], t[i + 1]) = (t[i + 1], t[i]);
            }
        });
        Found(broken, "positiveVolume");
    }

    [Fact]
    public void A_triangle_without_area_is_found()
    {
        Creature broken = WithMesh((p, _, t) => MoveTogether(p, t[1], p[t[0]]));
        Found(broken, "degenerate");
    }

    [Fact]
    public void A_vertex_without_its_mirror_image_is_found()
    {
        Creature broken = WithMesh((p, _, t) => MoveTogether(p, t[0], p[t[0]] + new Vector3(0f, 1e-5f, 0f)));
        Found(broken, "mirrored");
    }

    [Fact]
    public void A_creature_that_floats_or_sinks_is_not_grounded()
    {
        foreach (float height in new[] { 3e-4f, -3e-4f })
        {
            Creature broken = WithMesh((p, _, _) =>
            {
                for (int v = 0; v < p.Length; v++)
                {
                    p[v].Y += height;
                }
            });
            Found(broken, "grounded");
        }
    }

    [Fact]
    public void A_centre_of_mass_beyond_the_feet_is_not_balanced()
    {
        Creature broken = Sound with { Mass = Sound.Mass with { Centre = Sound.Mass.Centre + new Vector3(0f, 0f, 5f) } };
        Assert.Equal("balanced", Assert.Single(CreatureInspection.Inspect(broken)).Invariant);
    }

    [Fact]
    public void Weights_that_do_not_add_up_to_one_are_found()
    {
        Creature broken = WithMesh((_, w, _) => w[5] = new SkinWeights(w[5].Joint0, w[5].Joint1, w[5].Joint2, w[5].Joint3, w[5].Weights * 0.9f));
        Assert.Contains("vertex 5", Found(broken, "weights"), StringComparison.Ordinal);
    }

    [Fact]
    public void A_joint_that_does_not_exist_is_found()
    {
        Creature broken = WithMesh((_, w, _) => w[5] = new SkinWeights(Sound.Skeleton.Count, 0, 0, 0, Vector4.UnitX));
        Found(broken, "weights");
    }

    [Fact]
    public void Skin_of_the_left_leg_that_follows_the_right_leg_is_found()
    {
        int left = Sound.Skeleton.IndexOf("Leg_L1_Knee");
        int right = Sound.Skeleton.IndexOf("Leg_R1_Knee");
        Creature broken = WithMesh((_, w, _) =>
        {
            int vertex = Array.FindIndex(w, one => one.Joint0 == left);
            w[vertex] = new SkinWeights(left, right, 0, 0, new Vector4(0.8f, 0.2f, 0f, 0f));
        });
        Assert.Contains("Leg_R1_Knee", Found(broken, "weightReach"), StringComparison.Ordinal);
    }

    [Fact]
    public void A_limb_that_the_blueprint_asks_for_is_missed()
    {
        Creature broken = Sound with { Limbs = Sound.Limbs.Where(limb => limb.Kind != LimbKind.Leg || limb.Side != Side.Left).ToArray() };
        Assert.Contains("legs", Found(broken, "limbs"), StringComparison.Ordinal);
    }

    [Fact]
    public void A_plan_without_the_limbs_that_it_moves_with_is_found()
    {
        Creature flier = CreatureGenerator.Build(BlueprintSampler.Sample(3, LocomotionKind.Swimming));
        CreatureBlueprint bare = flier.Blueprint with { Plan = BodyPlan.Fish, Fins = new ValueList<FinBlueprint>(Array.Empty<FinBlueprint>()) };
        Assert.Contains("fins", Found(flier with { Blueprint = bare, Limbs = Array.Empty<LimbChain>() }, "limbs"), StringComparison.Ordinal);
    }

    [Fact]
    public void A_mesh_above_its_budget_is_found()
    {
        Creature broken = Sound with { Blueprint = Sound.Blueprint with { TriangleBudget = (Sound.Mesh.Triangles.Length / 3) - 1 } };
        Found(broken, "budget");
    }

    [Fact]
    public void A_leg_pushed_through_the_other_is_counted()
    {
        Creature broken = WithMesh((p, w, _) =>
        {
            int knee = Sound.Skeleton.IndexOf("Leg_L1_Knee");
            float reach = 2f * Sound.Skeleton.ModelPositions[knee].X;
            for (int v = 0; v < p.Length; v++)
            {
                p[v].X -= w[v].Joint0 == knee ? reach : 0f;
            }
        });
        Assert.True(CreatureInspection.CountSelfIntersections(broken) > 0);
    }

    private static string Found(Creature creature, string invariant) =>
        Assert.Single(CreatureInspection.Inspect(creature), violation => violation.Invariant == invariant).Detail;

    private static void MoveTogether(Vector3[] positions, int vertex, Vector3 to)
    {
        Vector3 from = positions[vertex];
        for (int v = 0; v < positions.Length; v++)
        {
            positions[v] = positions[v] == from ? to : positions[v];
        }
    }

    private static Creature WithMesh(Action<Vector3[], SkinWeights[], int[]> change)
    {
        CreatureMesh mesh = Sound.Mesh;
        Vector3[] positions = mesh.Positions.ToArray();
        SkinWeights[] weights = mesh.Weights.ToArray();
        int[] triangles = mesh.Triangles.ToArray();
        change(positions, weights, triangles);
        return Sound with { Mesh = new CreatureMesh(positions, mesh.Normals.ToArray(), mesh.Texcoords.ToArray(), mesh.Colours.ToArray(), weights, triangles, mesh.Parts) };
    }
}
