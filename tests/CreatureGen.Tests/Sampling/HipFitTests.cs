using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Shapes;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class HipFitTests
{
    /// <summary>Longest leg under a mixed trunk in depths of it, and its thickest thigh: 4.0 and 1.2 before hips were measured by the trunk's depth.</summary>
    private const double Longest = 2.45;
    private const double Thickest = 0.95;

    /// <summary>The longest bird's leg likewise: 3.8 before they were measured as well.</summary>
    private const double LongestOfBirds = 2.6;

    [Fact]
    public void Mixed_bodies_stand_on_no_legs_that_are_thicker_than_their_trunks()
    {
        int legs = 0;
        for (ulong seed = 10001001; seed <= 10001080; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            double depth = DepthOf(creature);
            foreach (LegBlueprint leg in creature.Legs.Where(leg => leg.Stance == LegStance.Standing && IsUnder(leg.Archetype)))
            {
                Assert.True(leg.Length <= Longest * depth, FormattableString.Invariant($"{seed}: a leg of {leg.Length / depth:0.00} depths"));
                Assert.True(2 * leg.Thickness * leg.Stoutness <= Thickest * depth, FormattableString.Invariant($"{seed}: a thigh of {2 * leg.Thickness * leg.Stoutness / depth:0.00} depths"));
                legs++;
            }
        }

        Assert.InRange(legs, 40, 1000);
    }

    [Fact]
    public void Mixed_bodies_stand_on_no_stilts_of_birds()
    {
        double[] lengths = Enumerable.Range(10001001, 240)
            .Select(seed => BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }))
            .SelectMany(creature => creature.Legs.Where(leg => leg.Stance == LegStance.Standing && leg.Archetype == LimbArchetype.Bird).Select(leg => leg.Length / DepthOf(creature)))
            .ToArray();
        Assert.InRange(lengths.Length, 10, 1000);
        Assert.True(lengths.Max() <= LongestOfBirds, FormattableString.Invariant($"a leg of {lengths.Max():0.00} depths"));
    }

    private static double DepthOf(CreatureBlueprint creature) => TrunkOutline.Of(BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail)).Depth;

    private static bool IsUnder(LimbArchetype archetype) => archetype != LimbArchetype.Bird && LegKinds.Of(archetype).Build.Posture == LimbPosture.Under;
}
