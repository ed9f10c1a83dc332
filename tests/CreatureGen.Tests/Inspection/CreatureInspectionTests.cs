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

    [Theory]
    [InlineData(7300006)]
    [InlineData(7300040)]
    [InlineData(7300128)]
    [InlineData(7300203)]
    public void Flat_facets_of_the_least_budget_may_cut_a_few_hundredths_off_a_flier(ulong seed) =>
        Assert.Empty(CreatureInspection.Inspect(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying, TriangleBudget = 6000 })));

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
    public void A_foot_whose_contact_is_above_the_ground_is_not_grounded()
    {
        LimbChain[] limbs = Sound.Limbs.Select(l => l.Stands && l.Side == Side.Left && l.Pair == 1 ? l with { Contact = l.Contact + new Vector3(0f, 0.02f, 0f) } : l).ToArray();
        Assert.Contains("contact is at", Found(Sound with { Limbs = limbs }, "grounded"), StringComparison.Ordinal);
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
    public void Weights_that_do_not_descend_are_found()
    {
        Creature broken = WithMesh((_, w, _) =>
        {
            int vertex = Array.FindIndex(w, one => one.Weights.X > 0.6f && one.Weights.Y > 0.05f);
            SkinWeights sound = w[vertex];
            w[vertex] = new SkinWeights(sound.Joint1, sound.Joint0, sound.Joint2, sound.Joint3, sound.Weights with { X = sound.Weights.Y, Y = sound.Weights.X });
        });
        Assert.Contains("descending", Found(broken, "weights"), StringComparison.Ordinal);
    }

    [Fact]
    public void More_joints_than_a_byte_can_number_are_found()
    {
        Joint[] tips = Enumerable.Range(0, 256 - Sound.Skeleton.Count)
            .Select(k => Sound.Skeleton.Joints[0] with { Name = "Tip_" + k, Role = JointRole.Other, Parent = 0, LocalPosition = Vector3.Zero, LocalRotation = Quaternion.Identity, Length = 0f }).ToArray();
        Creature many = Sound with { Skeleton = new Skeleton([.. Sound.Skeleton.Joints, .. tips]) };
        Assert.Contains("256 joints", Found(many, "joints"), StringComparison.Ordinal);
        Assert.DoesNotContain(CreatureInspection.Inspect(Sound with { Skeleton = new Skeleton([.. Sound.Skeleton.Joints, .. tips.Skip(1)]) }), v => v.Invariant == "joints");
    }

    /// <summary>The two sides of a sheet: closed, wound as it should be, without any space within.</summary>
    [Fact]
    public void Two_triangles_with_the_same_corners_are_found()
    {
        CreatureMesh mesh = Sound.Mesh;
        int first = mesh.Positions.Length;
        float top = mesh.Positions.ToArray().Max(p => p.Y);
        Vector3[] positions = [.. mesh.Positions, new(-0.1f, top + 1f, 0f), new(0.1f, top + 1f, 0f), new(0f, top + 1f, 0.1f)];
        int[] triangles = [.. mesh.Triangles, first, first + 1, first + 2, first + 1, first, first + 2];
        MeshPart last = mesh.Parts[^1];
        Creature broken = Sound with
        {
            Mesh = new CreatureMesh(
                positions,
                [.. mesh.Normals, Vector3.UnitY, Vector3.UnitY, Vector3.UnitY],
                [.. mesh.Texcoords, default, default, default],
                [.. mesh.Colours, Vector3.One, Vector3.One, Vector3.One],
                [.. mesh.Weights, .. Enumerable.Repeat(new SkinWeights(0, 0, 0, 0, Vector4.UnitX), 3)],
                triangles,
                [.. mesh.Parts.SkipLast(1), last with { IndexCount = last.IndexCount + 6 }]),
        };
        Assert.Contains("0 open edges, 0 edges of three or more triangles", Found(broken, "closed"), StringComparison.Ordinal);
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
    public void Skin_goes_over_from_the_half_of_a_disc_into_the_fin_that_grows_on_it() =>
        Assert.Empty(CreatureInspection.Inspect(CreatureGenerator.Generate(10140051, CreatureOptions.Default with { Kind = RequestedKind.Swimming })));

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
