using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

/// <summary>Fliers stand on the legs that the rules give them.</summary>
public sealed class FlierLegsTests
{
    [Fact]
    public void Fliers_stand_on_all_of_their_legs_or_let_all_of_them_hang()
    {
        int standing = 0;
        for (ulong seed = 20000; seed < 20000 + (ulong)Thoroughness.Of(400); seed++)
        {
            CreatureBlueprint flier = BlueprintSampler.Sample(seed, LocomotionKind.Flying);
            LegBlueprint[] legs = flier.Legs.Where(leg => leg.Archetype is not (LimbArchetype.Raptorial or LimbArchetype.Arm)).ToArray();
            Assert.True(legs.Select(leg => leg.Stance).Distinct().Count() <= 1, $"seed {seed}");
            standing += legs.Any(leg => leg.Stance == LegStance.Standing) ? 1 : 0;
        }

        Assert.InRange(standing, Thoroughness.Of(360), Thoroughness.Of(400) - 1);
    }

    [Fact]
    public void A_flier_that_stands_has_its_feet_on_the_ground_and_its_wings_above_them()
    {
        for (ulong seed = 21000; seed < 21000 + (ulong)Thoroughness.Of(80); seed++)
        {
            Creature creature = CreatureGenerator.Build(BlueprintSampler.Sample(seed, LocomotionKind.Flying));
            Assert.Empty(CreatureInspection.Inspect(creature));
            LimbChain[] feet = creature.Limbs.Where(limb => limb.Stands).ToArray();
            float wings = creature.Limbs.Where(limb => limb.Kind is LimbKind.Wing or LimbKind.InsectWing).Min(limb => creature.Skeleton.ModelPositions[limb.Joints[0]].Y);
            Assert.All(feet, foot => Assert.True(Math.Abs(foot.Contact.Y) < 1e-4f && wings > 0.5f * creature.Skeleton.ModelPositions[foot.Joints[1]].Y, $"seed {seed}"));
        }
    }

    [Fact]
    public void A_flying_insect_stands_on_as_many_legs_as_its_walking_sister()
    {
        int compared = 0;
        for (ulong seed = 22000; seed < 22400; seed++)
        {
            CreatureBlueprint flier = BlueprintSampler.Sample(seed, LocomotionKind.Flying);
            int legs = flier.Legs.Count(leg => leg.Stance == LegStance.Standing);
            if (flier.Body.Blend.First is "beetle" or "wasp" or "butterfly" or "dragonfly")
            {
                Assert.Equal(3, legs);
                compared++;
            }
            else if (flier.Body.Blend.First == "mantis")
            {
                Assert.Equal(2, legs);
                Assert.Contains(flier.Legs, leg => leg.Archetype == LimbArchetype.Raptorial);
                compared++;
            }
        }

        Assert.True(compared > 40);
    }

    [Fact]
    public void The_back_of_a_flier_on_several_pairs_of_legs_is_nearly_level()
    {
        int several = 0;
        for (ulong seed = 23000; seed < 23400; seed++)
        {
            CreatureBlueprint flier = BlueprintSampler.Sample(seed, LocomotionKind.Flying);
            if (flier.Legs.Count > 1 && flier.Legs.All(leg => leg.Stance == LegStance.Standing && leg.Archetype is not (LimbArchetype.Insect or LimbArchetype.Jumper or LimbArchetype.Raptorial or LimbArchetype.Arm)))
            {
                BodyShape shape = BodyShaper.Shape(flier.Plan, flier.Body, flier.Head, flier.Tail);
                double slope = Math.Atan2(Math.Abs(shape.Y[20] - shape.Y[42]), Math.Abs(shape.Z[20] - shape.Z[42])) * 180 / Math.PI;
                Assert.True(slope < 20, $"seed {seed}: {slope:0.0} degrees");
                several++;
            }
        }

        Assert.True(several > 20, $"{several}");
    }

    [Fact]
    public void A_spread_wing_is_seen_as_a_surface_from_the_front()
    {
        for (ulong seed = 24000; seed < 24030; seed++)
        {
            Creature creature = CreatureGenerator.Build(BlueprintSampler.Sample(seed, LocomotionKind.Flying));
            if (creature.Limbs.FirstOrDefault(limb => limb.Kind == LimbKind.Wing) is LimbChain wing)
            {
                double seen = 0, all = 0;
                foreach (int[] corners in creature.Mesh.Triangles.ToArray().Chunk(3).Where(corners => wing.Joints.Skip(1).Contains(creature.Mesh.Weights[corners[0]].Joint0)))
                {
                    Vector3 a = creature.Mesh.Positions[corners[0]];
                    Vector3 normal = Vector3.Cross(creature.Mesh.Positions[corners[1]] - a, creature.Mesh.Positions[corners[2]] - a);
                    seen += Math.Abs(normal.Z);
                    all += normal.Length();
                }

                Assert.True(seen > 0.4 * all, $"seed {seed}: {seen / all:0.00}");
            }
        }
    }
}
