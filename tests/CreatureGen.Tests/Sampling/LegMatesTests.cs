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

    /// <summary>Lengths of the three slices between the girdles together: 3.62, 3.64 and 4.16 where each further pair lengthened them by .24, and the pairs stood on one another.</summary>
    [Theory]
    [InlineData(24660015, 3, 3.8)]
    [InlineData(24660020, 3, 3.75)]
    [InlineData(24660034, 4, 4.4)]
    public void Trunks_on_six_and_eight_legs_have_room_for_them_between_the_girdles(int seed, int pairs, double least)
    {
        CreatureBlueprint walker = BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        Assert.Equal(pairs, walker.Legs.Count);
        Assert.InRange(walker.Body.Slices.Skip(4).Take(3).Sum(slice => slice.Length), least, 2 * least);
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
