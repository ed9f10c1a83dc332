using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ik;

public sealed class CcdIkTests
{
    private static readonly int[] chain = { 0, 1, 2, 3, 4, 5, 6 };

    [Fact]
    public void Free_chains_come_to_any_target_well_within_their_length_and_nearly_always_right_to_it()
    {
        int reached = 0;
        Skeleton skeleton = MovingPose.Chain(6, 0.5f, JointLimit.Free);
        RandomStream random = new Seed(1).Stream();
        for (int i = 0; i < 300; i++)
        {
            MovingPose pose = new MovingPose(skeleton).Shaken((ulong)i, 0.3);
            Vector3 target = MovingPose.Direction(random) * (float)random.Uniform(0.8, 2.4);
            IkResult result = CcdIk.Apply(skeleton, chain, target, new CcdSettings(60), pose.Local, pose.Model);
            Assert.True(result.Residual < 0.03f, $"{i}: {result}");
            reached += result.Reached ? 1 : 0;
            Assert.Equal(result.Residual, Vec.Distance(pose.ModelPositions[6], target), 1e-6f);
            for (int k = 1; k < 7; k++)
            {
                Assert.Equal(0.5f, Vec.Distance(pose.ModelPositions[k], pose.ModelPositions[k - 1]), 1e-5f);
            }
        }

        Assert.True(reached >= 295, $"{reached} of 300");
    }

    [Fact]
    public void One_joint_turns_by_the_whole_angle_and_not_by_twice_it()
    {
        Skeleton skeleton = MovingPose.Chain(1, 1f, JointLimit.Free);
        MovingPose pose = new(skeleton);
        IkResult result = CcdIk.Apply(skeleton, chain.AsSpan(0, 2), new Vector3(1f, 0f, 0f), new CcdSettings(1, 1e-4f, 3.1f), pose.Local, pose.Model);
        Assert.True(result.Reached);
        Assert.Equal(PortableMath.Pi / 2, Rotation.Angle(pose.LocalRotations[0]), 5);
    }

    [Fact]
    public void A_target_straight_behind_is_reached_too()
    {
        Skeleton skeleton = MovingPose.Chain(1, 1f, JointLimit.Free);
        MovingPose pose = new(skeleton);
        Assert.True(CcdIk.Apply(skeleton, chain.AsSpan(0, 2), new Vector3(0f, -1f, 0f), CcdSettings.Default, pose.Local, pose.Model).Reached);
    }

    [Fact]
    public void No_joint_ever_leaves_its_limits_however_often_it_is_solved()
    {
        var limit = new JointLimit(new AngleRange(-0.1f, 0.5f), new AngleRange(-0.3f, 0.3f), new AngleRange(-0.1f, 0.1f));
        Skeleton skeleton = MovingPose.Chain(6, 0.5f, limit);
        MovingPose pose = new(skeleton);
        RandomStream random = new Seed(2).Stream();
        int limited = 0;
        for (int i = 0; i < 400; i++)
        {
            IkResult result = CcdIk.Apply(skeleton, chain, MovingPose.Direction(random) * 2.5f, CcdSettings.Default, pose.Local, pose.Model);
            limited += result.Status == IkStatus.Limited ? 1 : 0;
            for (int k = 0; k < 6; k++)
            {
                Assert.True(SwingTwistLimit.Excess(pose.LocalRotations[k], limit) < 3e-5f);
                Assert.Equal(1f, pose.LocalRotations[k].Length(), 1e-5f);
            }
        }

        Assert.True(limited > 100);
    }

    [Fact]
    public void Hinges_turn_in_their_plane_and_reach_targets_in_it()
    {
        var hinge = new JointLimit(AngleRange.Both(1.5f), default, default);
        Skeleton skeleton = MovingPose.Chain(6, 0.5f, hinge);
        RandomStream random = new Seed(3).Stream();
        for (int i = 0; i < 200; i++)
        {
            MovingPose pose = new(skeleton);
            double angle = random.Uniform(-1.2, 1.2);
            Vector3 target = new Vector3(0f, (float)PortableMath.Cos(angle), (float)PortableMath.Sin(angle)) * (float)random.Uniform(1.5, 2.7);
            IkResult result = CcdIk.Apply(skeleton, chain, target + (Vector3.UnitX * (i % 2)), new CcdSettings(80), pose.Local, pose.Model);
            Assert.Equal(i % 2 == 0, result.Reached);
            Assert.True(Math.Abs(pose.ModelPositions[6].X) < 1e-4f);
            Assert.True(Vec.Distance(pose.ModelPositions[6], target) < 0.03f, $"{i}: {Vec.Distance(pose.ModelPositions[6], target)}");
        }
    }

    [Fact]
    public void Beyond_its_length_the_chain_stretches_towards_the_target_and_says_so()
    {
        Skeleton skeleton = MovingPose.Chain(6, 0.5f, JointLimit.Free);
        MovingPose pose = new MovingPose(skeleton).Shaken(5, 0.5);
        IkResult result = CcdIk.Apply(skeleton, chain, new Vector3(0f, 6f, 8f), new CcdSettings(100), pose.Local, pose.Model);
        Assert.Equal(IkStatus.TooFar, result.Status);
        Assert.Equal(7f, result.Residual, 0.05f);
    }

    [Fact]
    public void The_mirror_image_has_the_mirrored_answer()
    {
        var limit = new JointLimit(new AngleRange(-0.4f, 0.9f), new AngleRange(-0.3f, 0.6f), new AngleRange(-0.1f, 0.2f));
        Skeleton left = MovingPose.Chain(6, 0.5f, limit);
        Skeleton right = MovingPose.Chain(6, 0.5f, limit.Mirrored());
        MovingPose a = new(left);
        MovingPose b = new(right);
        Vector3 target = new(1.2f, 1.5f, 0.8f);
        CcdIk.Apply(left, chain, target, CcdSettings.Default, a.Local, a.Model);
        CcdIk.Apply(right, chain, Vec.Mirror(target), CcdSettings.Default, b.Local, b.Model);
        for (int k = 0; k < 7; k++)
        {
            Assert.True(Vec.Distance(Vec.Mirror(a.ModelPositions[k]), b.ModelPositions[k]) < 1e-4f);
        }
    }

    [Fact]
    public void A_target_at_a_joint_a_gap_in_the_chain_and_numbers_that_are_none_are_handled()
    {
        Skeleton skeleton = MovingPose.Chain(6, 0.5f, JointLimit.Free);
        MovingPose pose = new(skeleton);
        CcdIk.Apply(skeleton, chain, pose.ModelPositions[3], CcdSettings.Default, pose.Local, pose.Model);
        Assert.All(pose.ModelPositions, p => Assert.True(p - p == Vector3.Zero));
        Assert.Throws<ArgumentException>(() => CcdIk.Apply(skeleton, new[] { 0, 2 }, Vector3.One, CcdSettings.Default, pose.Local, pose.Model));
        Assert.Throws<ArgumentException>(() => CcdIk.Apply(skeleton, new[] { 0 }, Vector3.One, CcdSettings.Default, pose.Local, pose.Model));
        Assert.Throws<ArgumentException>(() => CcdIk.Apply(skeleton, chain, new Vector3(0f, float.NaN, 0f), CcdSettings.Default, pose.Local, pose.Model));
        Assert.Throws<ArgumentException>(() => CcdIk.Apply(skeleton, chain, Vector3.One, default, pose.Local, pose.Model));
    }
}
