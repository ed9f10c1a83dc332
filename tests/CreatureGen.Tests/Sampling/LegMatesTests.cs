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

/// <summary>Pairs of legs under one body are of one make.</summary>
public sealed class LegMatesTests
{
    private const int Bodies = 40;

    /// <summary>Least length of the shortest toes of a body relative to its longest (.62 where each pair was as its part of the trunk).</summary>
    private const float Least = 0.75f;

    [Fact]
    public void The_toes_of_all_feet_of_a_body_are_at_least_three_quarters_as_long_as_the_longest()
    {
        int bodies = 0;
        for (ulong seed = 16070003; bodies < Bodies; seed++)
        {
            CreatureBlueprint walker = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            if (walker.Plan is not (BodyPlan.Digitigrade or BodyPlan.Plantigrade))
            {
                continue;
            }

            float[] toes = ToesOf(CreatureGenerator.Build(walker));
            Assert.True(toes.Min() >= Least * toes.Max(), FormattableString.Invariant($"{seed}: toes of {toes.Min():0.000} and {toes.Max():0.000} m"));
            bodies++;
        }
    }

    private static float[] ToesOf(Creature creature)
    {
        Vector3[] at = creature.Skeleton.ModelPositions.ToArray();
        return creature.Limbs
            .Where(limb => limb.Kind == LimbKind.Leg && limb.Side == Side.Left)
            .Select(limb => Vector3.Distance(at[limb.Joints[^1]], at[limb.Joints[^2]]))
            .ToArray();
    }
}
