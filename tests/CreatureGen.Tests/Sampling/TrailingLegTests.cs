using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

/// <summary>Legs of swimmers that sprawl on land are laid along the flanks.</summary>
public sealed class TrailingLegTests
{
    [Fact]
    public void From_behind_the_foot_of_a_swimmers_leg_is_no_farther_out_than_its_wrist_by_a_tenth_of_the_leg_and_lies_back_twice_as_far_as_it_hangs()
    {
        int seen = 0;
        for (ulong seed = 9951001; seed <= 9951060; seed++)
        {
            Creature swimmer = CreatureGenerator.Build(BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming }));
            foreach (LimbChain leg in swimmer.Limbs)
            {
                if (leg.Archetype == LimbArchetype.Sprawl && leg.Side == Side.Left)
                {
                    Vector3 hip = At(leg, 1);
                    Vector3 ankle = At(leg, 3);
                    Vector3 foot = At(leg, 5);
                    float length = Vector3.Distance(hip, foot);
                    Assert.True(foot.X - ankle.X < 0.1f * length, $"{seed}: out by {foot.X - ankle.X} of {length} m");
                    Assert.True(hip.Z - foot.Z > 2f * (hip.Y - foot.Y), $"{seed}: {foot - hip}");
                    seen++;
                }
            }

            Vector3 At(LimbChain leg, int joint) => swimmer.Skeleton.ModelPositions[leg.Joints[joint]];
        }

        Assert.InRange(seen, 10, 200);
    }
}
