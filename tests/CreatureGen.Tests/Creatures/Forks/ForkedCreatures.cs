using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;

namespace CreatureGen.Tests.Creatures.Forks;

/// <summary>Creatures that are given a second head where their necks have room for one.</summary>
internal static class ForkedCreatures
{
    private const double Size = 0.85;

    /// <summary>The same creature with one head and with two.</summary>
    public static IEnumerable<(CreatureBlueprint One, CreatureBlueprint Two)> Of(LocomotionKind kind, int count)
    {
        int found = 0;
        for (ulong seed = 8_300_000; found < count; seed++)
        {
            CreatureBlueprint one = BlueprintSampler.Sample(seed, kind) with { Fork = null };
            if (ForkFit.Find(one, BodyShaper.Shape(one.Plan, one.Body, one.Head, one.Tail), Size) is ForkBlueprint fork)
            {
                found++;
                yield return (one, one with { Fork = fork });
            }
        }
    }
}
