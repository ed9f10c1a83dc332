using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Trunk;

/// <summary>Where the head looks of who steps to a side.</summary>
public sealed class SideStepLookTests
{
    [Theory]
    [InlineData(1f)]
    [InlineData(-1f)]
    public void Heads_look_to_the_side_to_which_the_body_steps_and_ahead_again_as_it_stands(float side)
    {
        var profile = new MotionProfile(Walkers.Any(42));
        var animator = new CreatureAnimator(profile);
        animator.Settings = animator.Settings with { Idle = 0f };
        animator.Teleport(animator.Root, FlatGround.Level);
        float speed = 0.2f * (float)Math.Sqrt(animator.Settings.Gravity * profile.LegLength);
        Assert.InRange(side * YawAfter(1.5f, side * speed), 0.15f, 0.5f);
        Assert.InRange(YawAfter(2f, 0f), -0.05f, 0.05f);

        float YawAfter(float seconds, float sideways)
        {
            for (float time = 0f; time < seconds; time += 1f / 60f)
            {
                animator.Update(1f / 60f, new MotionInput(0f, Sideways: sideways), FlatGround.Level);
            }

            Skeleton skeleton = profile.Subject.Skeleton;
            int head = skeleton.FirstOf(JointRole.Head);
            Vector3 ahead = Rotation.Rotate(Rotation.Multiply(animator.ModelPose.Rotations[head], Rotation.Inverse(skeleton.ModelRotations[head])), Vector3.UnitZ);
            return (float)Math.Atan2(ahead.X, ahead.Z);
        }
    }
}
