using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Limbs;

public sealed class WingGrowerTests
{
    /// <summary>Least way of a tip behind its shoulder, in spans; wings of .05 to .25 of sweep were caps on the shoulders from the side.</summary>
    private const float Behind = 0.03f;

    [Fact]
    public void Spread_wings_rise_to_their_tips_and_lie_back_so_that_they_are_seen_from_the_side()
    {
        int wings = 0;
        foreach (int seed in Enumerable.Range(16080000, 24))
        {
            Creature creature = CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying });
            if (creature.Blueprint.Wings.Count == 0 || creature.Blueprint.Wings.Any(wing => wing.Style == WingStyle.Folded))
            {
                continue;
            }

            foreach (LimbChain wing in creature.Limbs.Where(limb => limb.Kind == LimbKind.Wing && limb.Side == Side.Left))
            {
                Vector3[] bones = [.. wing.Joints.Select(joint => creature.Skeleton.ModelPositions[joint])];
                float span = Vector3.Distance(bones[0], bones[^1]);
                Assert.True(bones[0].Z - bones[^1].Z > Behind * span, FormattableString.Invariant($"{seed}: the tip lies {(bones[0].Z - bones[^1].Z) / span} of the span behind"));
                Assert.True(bones[^1].Y >= bones.Max(bone => bone.Y) - 1e-3f, FormattableString.Invariant($"{seed}: the tip hangs"));
                wings++;
            }
        }

        Assert.True(wings > 8);
    }
}
