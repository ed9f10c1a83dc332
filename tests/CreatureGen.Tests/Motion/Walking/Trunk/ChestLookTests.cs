using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Trunk;

public sealed class ChestLookTests
{
    private const float Frame = 1f / 60f;

    [Theory]
    [InlineData(BodyPlan.Upright, 2, 0.2f)]
    [InlineData(BodyPlan.Theropod, 4, 0.2f)]
    [InlineData(BodyPlan.Digitigrade, 5, 0.08f)]
    [InlineData(BodyPlan.Unguligrade, 3, 0.08f)]
    [InlineData(BodyPlan.Sprawling, 6, 0.04f)]
    public void The_chest_of_who_stands_joins_in_a_look_aside_and_its_feet_stay_where_they_are(BodyPlan plan, ulong seed, float least)
    {
        Creature creature = Walkers.Of(plan, seed);
        var animator = new CreatureAnimator(creature);
        MotionSettings settings = animator.Settings;
        settings.Idle = 0f;
        animator.Settings = settings;
        animator.Teleport(animator.Root, FlatGround.Level);
        float length = animator.Profile.LegLength;
        int chest = creature.Skeleton.FirstOf(JointRole.Chest);
        int[] balls = animator.Profile.Legs!.Legs.Select(leg => leg.Ball).ToArray();
        Vector3[] stood = Array.ConvertAll(balls, ball => animator.ModelPose.Positions[ball]);
        float straight = Yaw();
        animator.LookAt = new Vector3(20f * length, length, 4f * length);
        Walkers.Run(animator, 3f, 60f, default, FlatGround.Level);
        float left = Yaw() - straight;
        Assert.True(left > least, $"{left} rad to the left");
        for (int i = 0; i < balls.Length; i++)
        {
            Assert.True(Vec.Distance(stood[i], animator.ModelPose.Positions[balls[i]]) < 0.015f * length, $"foot {i} is {Vec.Distance(stood[i], animator.ModelPose.Positions[balls[i]]) / length} legs from where it stood");
        }

        Quaternion[] pose = animator.LocalPose.Rotations.ToArray();
        animator.Update(0f, default, FlatGround.Level);
        for (int i = 0; i < pose.Length; i++)
        {
            Assert.True(MovingPose.Between(pose[i], animator.LocalPose.Rotations[i]) < 1e-4, $"no time has passed, and {creature.Skeleton.Joints[i].Name} has turned");
        }

        animator.LookAt = new Vector3(-20f * length, length, 4f * length);
        Walkers.Run(animator, 4f, 60f, default, FlatGround.Level);
        Assert.InRange(Yaw() - straight, -left - 0.02f, -left + 0.02f);
        animator.LookAt = null;
        Walkers.Run(animator, 6f, 60f, default, FlatGround.Level);
        Assert.InRange(Yaw() - straight, -0.002f, 0.002f);

        float Yaw()
        {
            Vector3 ahead = Vector3.Transform(Vector3.UnitZ, animator.ModelPose.Rotations[chest] * Quaternion.Inverse(creature.Skeleton.ModelRotations[chest]));
            return MathF.Atan2(ahead.X, ahead.Z);
        }
    }

    [Fact]
    public void A_point_straight_above_is_looked_at_without_turning_the_chest()
    {
        Creature creature = Walkers.Of(BodyPlan.Digitigrade, 5);
        var animator = new CreatureAnimator(creature) { LookAt = new Vector3(0f, 50f, 0f) };
        int chest = creature.Skeleton.FirstOf(JointRole.Chest);
        animator.Teleport(animator.Root, FlatGround.Level);
        Quaternion before = animator.LocalPose.Rotations[chest];
        animator.Update(Frame, default, FlatGround.Level);
        Assert.True(Math.Abs(Quaternion.Dot(before, animator.LocalPose.Rotations[chest])) > 0.9999f);
    }
}
