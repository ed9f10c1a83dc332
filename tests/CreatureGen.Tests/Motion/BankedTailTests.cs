using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion;

/// <summary>A turn that the bank balances pushes nothing to the side: tails stay in line with the body.</summary>
public sealed class BankedTailTests
{
    [Fact]
    public void Tails_of_fliers_do_not_swing_out_of_a_turn_that_their_bank_balances()
    {
        int tails = 0;
        for (ulong seed = 0; seed < 12; seed++)
        {
            Creature creature = Walkers.Of(BodyPlan.Flapping, seed);
            int tip = Array.FindLastIndex(creature.Skeleton.Joints.ToArray(), j => j.Role == JointRole.Tail);
            var profile = new MotionProfile(creature);
            if (tip < 0 || !profile.Swinging.Any(chain => chain.Rig.Joints.Contains(tip)))
            {
                continue;
            }

            tails++;
            float left = Aside(profile, tip, 0.5f);
            float right = Aside(profile, tip, -0.5f);
            float length = Vec.Length(creature.Skeleton.ModelPositions[tip]);
            Assert.True(Math.Abs(left - right) < 0.12f * length, FormattableString.Invariant($"seed {seed}: the tip goes from {left} to {right} m"));
        }

        Assert.True(tails > 3, FormattableString.Invariant($"{tails} tails"));
    }

    /// <summary>How far to the left of the trunk's own middle plane the tip of the tail is, on average over a second of a steady turn, metres.</summary>
    private static float Aside(MotionProfile profile, int tip, float yawRate)
    {
        Creature creature = profile.Subject.Creature!;
        var animator = new CreatureAnimator(profile);
        animator.Teleport(new RootPlace(new Vector3(0f, 50f, 0f), Quaternion.Identity), FlatGround.Level);
        var input = new MotionInput(creature.DefaultSpeed, yawRate, Medium: MotionMedium.Air);
        Walkers.Run(animator, 6f, 60f, input, FlatGround.Level);
        int body = Array.FindIndex(creature.Skeleton.Joints.ToArray(), j => j.Role == JointRole.Pelvis);
        double sum = 0;
        for (int i = 0; i < 60; i++)
        {
            animator.Update(1f / 60f, input, FlatGround.Level);
            Quaternion inverse = Rotation.Multiply(creature.Skeleton.ModelRotations[body], Rotation.Inverse(animator.ModelPose.Rotations[body]));
            sum += Rotation.Rotate(inverse, animator.ModelPose.Positions[tip] - animator.ModelPose.Positions[body]).X;
        }

        return (float)(sum / 60);
    }
}
