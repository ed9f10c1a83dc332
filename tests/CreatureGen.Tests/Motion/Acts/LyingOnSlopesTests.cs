using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public sealed class LyingOnSlopesTests
{
    private const float Rate = 60f;

    /// <summary>They were rolled over about a level axis: on its back a lizard stuck out of a slope, tail up, by twice its angle (.6 of the way from pelvis to chest).</summary>
    [Theory]
    [InlineData(BodyPlan.Sprawling, 20f)]
    [InlineData(BodyPlan.Sprawling, -20f)]
    [InlineData(BodyPlan.Digitigrade, 20f)]
    [InlineData(BodyPlan.Digitigrade, -20f)]
    public void Who_rolls_over_on_a_slope_lies_along_it(BodyPlan plan, float degrees)
    {
        for (ulong seed = 1; seed <= 3; seed++)
        {
            var profile = new MotionProfile(Walkers.Of(plan, seed));
            ActAbility die = profile.Acts.Find("Die");
            float rise = MathF.Tan(degrees * MathF.PI / 180f);
            var ground = new FlatGround(Vector3.Zero, Vector3.Normalize(new Vector3(0f, 1f, -rise)));
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, ground);
            Walkers.Run(animator, 1f, Rate, default, ground);
            Assert.Equal(ActStatus.Started, animator.Perform(die).Status);
            Walkers.Run(animator, die.SecondsToLast, Rate, default, ground);
            int pelvis = profile.Subject.Skeleton.FirstOf(JointRole.Pelvis);
            int chest = profile.Subject.Skeleton.FirstOf(JointRole.Chest);
            Vector3 back = Vec.Normalize(Rotation.Rotate(animator.Root.Rotation, animator.ModelPose.Positions[chest] - animator.ModelPose.Positions[pelvis]), Vector3.UnitZ);
            Assert.InRange(Vec.Dot(back, ground.Normal), -0.36f, 0.36f);
        }
    }
}
