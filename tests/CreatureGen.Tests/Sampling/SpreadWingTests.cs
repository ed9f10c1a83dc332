using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

/// <summary>Spread wings are seen as wings from every side.</summary>
public sealed class SpreadWingTests
{
    [Fact(Explicit = true)]
    public void From_the_front_the_wings_of_a_mixed_flier_show_a_tenth_of_their_length_as_depth()
    {
        int seen = 0;
        for (ulong seed = 9943001; seed <= 9943080; seed++)
        {
            CreatureBlueprint flier = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying });
            if (flier.Wings.Count == 1 && flier.Wings[0].Style != WingStyle.Folded)
            {
                double depth = DepthFromTheFront(CreatureGenerator.Build(flier));
                Assert.True(depth > 0.1, FormattableString.Invariant($"{seed} {flier.Wings[0].Style}: {depth:0.000}"));
                seen++;
            }
        }

        Assert.InRange(seen, 30, 80);
    }

    [Fact]
    public void Wings_of_feathers_are_raised_so_far_that_they_are_no_stubs_from_the_side()
    {
        double[] rises = Enumerable.Range(9_943_001, 60)
            .Select(seed => BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying }))
            .Where(flier => flier.Wings.Count > 0 && flier.Wings[0].Style is WingStyle.Feathered or WingStyle.Falcon or WingStyle.Owl or WingStyle.Albatross or WingStyle.Hummingbird)
            .Select(flier => flier.Wings[0].Rise)
            .ToArray();
        Assert.NotEmpty(rises);
        Assert.All(rises, rise => Assert.True(rise > 0.53, FormattableString.Invariant($"{rise}")));
    }

    [Fact]
    public void Hind_wings_of_mixed_butterflies_are_larger_or_smaller_and_those_of_animals_are_not()
    {
        Assert.Equal(0.0, Spread(0), 12);
        Assert.True(Spread(0.6) > 0.25);

        static double Spread(double strangeness)
        {
            double[] ratios = Enumerable.Range(9_943_001, 24)
                .Select(seed => BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying, Strangeness = strangeness, BaseBodies = new ValueList<BaseBodyWeight>([new BaseBodyWeight("butterfly", 1000)]) }))
                .Where(flier => flier.InsectWings.Count == 2 && flier.InsectWings[0].Style == ThinWingStyle.ButterflyFore)
                .Select(flier => flier.InsectWings[1].Length / flier.InsectWings[0].Length)
                .ToArray();
            return ratios.Max() - ratios.Min();
        }
    }

    /// <summary>Mean depth of the left wing as it is seen from the front, in its lengths from shoulder to tip.</summary>
    private static double DepthFromTheFront(Creature creature)
    {
        double area = 0;
        CreatureMesh mesh = creature.Mesh;
        for (int t = 0; t < mesh.Triangles.Length; t += 3)
        {
            Vector3 a = mesh.Positions[mesh.Triangles[t]];
            Vector3 b = mesh.Positions[mesh.Triangles[t + 1]] - a;
            Vector3 c = mesh.Positions[mesh.Triangles[t + 2]] - a;
            area += IsWing(creature, mesh.Triangles[t]) ? 0.25 * Math.Abs((b.X * c.Y) - (b.Y * c.X)) : 0;
        }

        LimbChain wing = Assert.Single(creature.Limbs, limb => limb.Kind == LimbKind.Wing && limb.Side == Side.Left);
        Vector3 reach = creature.Skeleton.ModelPositions[wing.Joints[wing.Joints.Count - 1]] - creature.Skeleton.ModelPositions[wing.Joints[0]];
        return area / ((reach.X * reach.X) + (reach.Y * reach.Y));
    }

    private static bool IsWing(Creature creature, int vertex)
    {
        Joint joint = creature.Skeleton.Joints[creature.Mesh.Weights[vertex].Joint0];
        return joint.Role == JointRole.Wing && creature.Mesh.Positions[vertex].X > 0;
    }
}
