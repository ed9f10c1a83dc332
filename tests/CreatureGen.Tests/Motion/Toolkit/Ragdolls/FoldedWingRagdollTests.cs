using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ragdolls;

/// <summary>Fliers that go limp on their feet: the joints of their folded wings are not where the skeleton has them at rest.</summary>
public sealed class FoldedWingRagdollTests
{
    private const float Frame = 1f / 60f;

    [Fact]
    public void A_flier_goes_limp_in_the_pose_that_it_stands_in()
    {
        int fliers = 0;
        int drawn = 0;
        foreach (StandingFlier flier in StandingFlier.Of(9500, Thoroughness.Of(20)).Where(flier => flier.IsStitched))
        {
            (RagdollRig rig, RagdollState state, MovingPose shown) = Limp(flier);
            fliers++;
            drawn += Shortest(flier.Creature.Skeleton, shown.Local) < 0.9f ? 1 : 0;
            Ragdoll.Show(rig, state, RootPlace.Identity, shown.Local, shown.Model);
            for (int j = 0; j < flier.Creature.Skeleton.Count; j++)
            {
                float off = Vec.Distance(flier.Animator.ModelPose.Positions[j], shown.ModelPositions[j]);
                Assert.True(off < 1e-3f * flier.Length, $"{flier.Name} {flier.Creature.Skeleton.Joints[j].Name}: {off} m");
            }
        }

        // Wings that hang down beside a body may keep their length; those of nearly all are drawn together.
        Assert.True(drawn > 0.8 * fliers, $"the wings of only {drawn} of {fliers} are drawn together");
    }

    [Fact]
    public void Folded_wings_do_not_burst_and_have_their_length_again_where_the_flier_lies()
    {
        foreach (StandingFlier flier in StandingFlier.Of(9500, Thoroughness.Of(20)).Where(flier => flier.IsStitched))
        {
            (RagdollRig rig, RagdollState state, MovingPose shown) = Limp(flier);
            Skeleton skeleton = flier.Creature.Skeleton;
            double fastest = 0;
            var before = new Vector3[skeleton.Count];
            flier.Animator.ModelPose.Positions.CopyTo(before);
            for (int frame = 0; frame < 12; frame++)
            {
                Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, Frame);
                Ragdoll.Show(rig, state, RootPlace.Identity, shown.Local, shown.Model);
                for (int j = 0; j < before.Length; j++)
                {
                    fastest = Math.Max(fastest, Vec.Distance(before[j], shown.ModelPositions[j]) / Frame);
                    before[j] = shown.ModelPositions[j];
                }
            }

            // Nothing falls faster than freely for 0.2 s, but for what whips round a joint.
            double max = 3 * ((9.81 * 12 * Frame) + (2 * flier.Length));
            Assert.True(fastest < max, $"{flier.Name}: {fastest} m/s, expected below {max}");
            for (int frame = 0; frame < 600 && !state.IsAsleep; frame++)
            {
                Ragdoll.Advance(rig, state, RagdollSettings.Default, FlatGround.Level, Frame);
            }

            Ragdoll.Show(rig, state, RootPlace.Identity, shown.Local, shown.Model);
            float shortest = Shortest(skeleton, shown.Local);
            Assert.True(shortest > 0.9f, $"{flier.Name}: a wing's bone has {shortest} of its length");
        }
    }

    private static (RagdollRig Rig, RagdollState State, MovingPose Shown) Limp(StandingFlier flier)
    {
        flier.Stand(FlatGround.Level);
        RagdollRig rig = new RagdollRig(flier.Creature.Skeleton, flier.Creature.Bones);
        var state = new RagdollState(rig);
        Pose model = flier.Animator.ModelPose;
        Ragdoll.Start(rig, state, RootPlace.Identity, model, RootPlace.Identity, model, 0f, FlatGround.Level);
        var shown = new MovingPose(flier.Creature.Skeleton);
        flier.Animator.LocalPose.Positions.CopyTo(shown.Local.Positions);
        flier.Animator.LocalPose.Rotations.CopyTo(shown.Local.Rotations);
        return (rig, state, shown);
    }

    /// <summary>The least share of its length that the bone before a joint of the wings has, the shoulder apart.</summary>
    private static float Shortest(Skeleton skeleton, in Pose local)
    {
        float min = float.MaxValue;
        for (int j = 0; j < skeleton.Count; j++)
        {
            int parent = skeleton.Parents[j];
            if (skeleton.Joints[j].Role == JointRole.Wing && skeleton.Joints[parent].Role == JointRole.Wing)
            {
                min = Math.Min(min, Vec.Length(local.Positions[j]) / Vec.Length(skeleton.LocalPositions[j]));
            }
        }

        return min;
    }
}
