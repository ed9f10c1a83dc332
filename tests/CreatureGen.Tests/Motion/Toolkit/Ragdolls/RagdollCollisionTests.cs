using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Ragdolls;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ragdolls;

/// <summary>Parts of a limp body keep out of one another.</summary>
public sealed class RagdollCollisionTests
{
    [Fact]
    public void Parts_of_creatures_that_lie_limp_are_hardly_in_one_another()
    {
        float apart = 0f;
        float through = 0f;
        for (ulong seed = 1; seed <= (ulong)Thoroughness.Of(10); seed++)
        {
            Creature creature = Walkers.Any(seed);
            apart += DeepestAtRest(creature, true);
            through += DeepestAtRest(creature, false);
        }

        Assert.True(apart < 0.4f * through, $"the deepest pairs of ten bodies are {apart / 10f} of what they keep apart in one another, {through / 10f} where nothing keeps them so");
    }

    [Fact]
    public void No_body_has_more_pairs_than_are_looked_at_quickly_and_none_is_of_neighbours()
    {
        for (ulong seed = 1; seed <= (ulong)Thoroughness.Of(10); seed++)
        {
            Creature creature = Walkers.Any(seed);
            var rig = new RagdollRig(creature.Skeleton, creature.Bones);
            Assert.InRange(rig.Pairs.Length, 1, 192);
            foreach (RagdollPair pair in rig.Pairs)
            {
                Assert.NotEqual(pair.First, rig.Parts[pair.Second].Parent);
                Assert.NotEqual(rig.Parts[pair.First].Parent, rig.Parts[pair.Second].Parent);
            }
        }
    }

    /// <summary>How deep the deepest pair is in one another, part of what it keeps apart, when the body that fell from its feet, tilted, has come to rest.</summary>
    private static float DeepestAtRest(Creature creature, bool collides)
    {
        var rig = new RagdollRig(creature.Skeleton, creature.Bones);
        var state = new RagdollState(rig);
        MovingPose pose = new(creature.Skeleton);
        var root = new RootPlace(new Vector3(0f, 0.2f * rig.Size, 0f), Quaternion.CreateFromYawPitchRoll(0f, 0.5f, 0.4f));
        Ragdoll.Start(rig, state, root, pose.Model, root, pose.Model, 0f, FlatGround.Level);
        float[] aparts = state.Aparts.AsSpan().ToArray();
        if (!collides)
        {
            state.Aparts.AsSpan().Clear();
        }

        for (int i = 0; i < 600 && !state.IsAsleep; i++)
        {
            Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, 1f / 60f);
        }

        float deepest = 0f;
        for (int p = 0; p < aparts.Length; p++)
        {
            RagdollPair pair = rig.Pairs[p];
            float distance = (float)Math.Sqrt(SegmentDistance.Squared(At(pair.First, true), At(pair.First, false), At(pair.Second, true), At(pair.Second, false)));
            deepest = Math.Max(deepest, (aparts[p] - distance) / Math.Max(pair.Apart, 1e-6f));
        }

        return deepest;

        Vector3 At(int part, bool start) => state.Positions[part] + Vector3.Transform(start ? rig.Bones[part].Start : rig.Bones[part].End, state.Rotations[part]);
    }
}
