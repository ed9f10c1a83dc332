using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ik;

public sealed class CcdIkTests(ITestOutputHelper output)
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

    /// <summary>No joint has a limit here, and the target is well within reach: all that is missing are rounds.</summary>
    [Fact]
    public void Rounds_that_are_too_few_are_told_apart_from_limits_and_from_targets_out_of_reach()
    {
        Skeleton skeleton = MovingPose.Chain(6, 0.5f, JointLimit.Free);
        IkStatus After(int rounds, Vector3 target)
        {
            MovingPose pose = new(skeleton);
            return CcdIk.Apply(skeleton, chain, target, new CcdSettings(rounds), pose.Local, pose.Model).Status;
        }

        var beside = new Vector3(1.5f, -1f, 0.5f);
        Assert.Equal(IkStatus.NotConverged, After(1, beside));
        Assert.Equal(IkStatus.Reached, After(60, beside));
        Assert.Equal(IkStatus.TooFar, After(60, 10f * beside));
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

    /// <summary>Towards its own root a straight chain has nothing to turn by: it bends first.</summary>
    [Fact]
    public void A_straight_chain_reaches_what_lies_on_it()
    {
        Skeleton skeleton = MovingPose.Chain(6, 0.5f, JointLimit.Free);
        foreach (float along in new[] { 0.4f, 1f, 1.9f, 2.6f })
        {
            MovingPose pose = new(skeleton);
            Assert.True(CcdIk.Apply(skeleton, chain, new Vector3(0f, along, 0f), new CcdSettings(60), pose.Local, pose.Model).Reached, $"{along} m");
        }
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

    [Theory]
    [InlineData("ccd", "free", 0.99)]
    [InlineData("ccd", "limits of 30 degrees", 0.99)]
    [InlineData("ccd", "hinges of 60 degrees about two axes", 0.99)]
    [InlineData("fabrik", "free", 0.65)]
    [InlineData("fabrik", "limits of 30 degrees", 0.4)]
    [InlineData("fabrik", "hinges of 60 degrees about two axes", 0.1)]
    public void Chains_of_eight_joints_reach_what_they_can_in_sixteen_rounds(string solver, string kind, double least)
    {
        float narrow = (float)Scalar.Radians(30);
        JointLimit Limit(int k) => kind[0] == 'f' ? JointLimit.Free : kind[0] == 'l' ? new JointLimit(narrow, narrow, narrow) : new JointLimit((float)Scalar.Radians(60), 0f, 0f);
        var placements = new List<JointPlacement>();
        for (int k = 0; k <= 8; k++)
        {
            // Every other hinge is turned by a quarter about its bone, so that chains of hinges leave the plane.
            Quaternion roll = kind[0] == 'h' && k > 0 ? Rotation.FromAxisAngle(Vector3.UnitY, k % 2 == 0 ? -PortableMath.Pi / 2 : PortableMath.Pi / 2) : Quaternion.Identity;
            placements.Add(new JointPlacement(FormattableString.Invariant($"J{k}"), k - 1, roll, new Vector3(0f, k == 0 ? 0f : 0.2f, 0f)) { Limit = Limit(k) });
        }

        Skeleton skeleton = Skeleton.Build(placements);
        int[] chain = Enumerable.Range(0, 9).ToArray();
        RandomStream random = new Seed(11).Stream();
        int reached = 0;
        const int Trials = 300;
        for (int trial = 0; trial < Trials; trial++)
        {
            MovingPose goal = new(skeleton);
            for (int k = 0; k < 8; k++)
            {
                Quaternion any = Rotation.Multiply(skeleton.LocalRotations[k], Rotation.FromAxisAngle(kind[0] == 'h' ? Vector3.UnitX : MovingPose.Direction(random), random.Uniform(-1.0, 1.0)));
                goal.LocalRotations[k] = SwingTwistLimit.ClampLocal(Rotation.Normalize(any), skeleton.Joints[k]);
            }

            ForwardKinematics.LocalToModel(skeleton, goal.Local, goal.Model);
            MovingPose pose = new(skeleton);
            IkResult result = solver == "ccd"
                ? CcdIk.Apply(skeleton, chain, goal.ModelPositions[8], CcdSettings.Default, pose.Local, pose.Model)
                : FabrikIk.Apply(skeleton, chain, goal.ModelPositions[8], FabrikIk.UsualRounds, 1e-3f, pose.Local, pose.Model);
            for (int k = 0; k < 8; k++)
            {
                Assert.True(Rotation.Angle(Rotation.Multiply(Rotation.Inverse(pose.LocalRotations[k]), SwingTwistLimit.ClampLocal(pose.LocalRotations[k], skeleton.Joints[k]))) < 1e-3);
            }

            Assert.True(Math.Abs(Vec.Distance(pose.ModelPositions[8], goal.ModelPositions[8]) - result.Residual) < 1e-5f);
            reached += result.Reached ? 1 : 0;
            Assert.False(kind[0] == 'f' && result.Status == IkStatus.Limited);
        }

        Assert.True(reached >= least * Trials, FormattableString.Invariant($"{reached} of {Trials} {kind}"));
        output.WriteLine(FormattableString.Invariant($"{solver} {kind}: {reached} of {Trials}"));
    }

    [Fact]
    public void Bones_along_any_axis_give_the_same_answer_as_bones_along_Y()
    {
        Quaternion other = Rotation.FromAxisAngle(Vector3.Normalize(new Vector3(1f, 2f, -1f)), 2.0);
        var limit = new JointLimit((float)Scalar.Radians(50), 0f, 0f);
        var upright = new List<JointPlacement>();
        var slanted = new List<JointPlacement>();
        for (int k = 0; k <= 4; k++)
        {
            // The same bones in the model, but every joint's own axes turned so that its bone lies elsewhere in them.
            upright.Add(new JointPlacement(FormattableString.Invariant($"J{k}"), k - 1, Quaternion.Identity, new Vector3(0f, k == 0 ? 0f : 0.3f, 0f)) { Limit = limit });
            Vector3 step = new(0f, k == 0 ? 0f : 0.3f, 0f);
            slanted.Add(new JointPlacement(FormattableString.Invariant($"J{k}"), k - 1, k == 0 ? other : Quaternion.Identity, k == 0 ? step : Rotation.Rotate(Rotation.Inverse(other), step)) { Limit = limit });
        }

        Skeleton a = Skeleton.Build(upright);
        Skeleton b = Skeleton.Build(slanted);
        Vector3 hinge = Rotation.Rotate(b.ModelRotations[1], HingeAxis.Of(b.Joints[1]));
        Vector3 along = Vec.Cross(hinge, Vector3.UnitY);
        MovingPose one = new(a);
        MovingPose two = new(b);
        Vector3 inA = new(0f, 0.7f, 0.6f);
        Vector3 inB = (Vector3.UnitY * 0.7f) + (along * 0.6f * (Vec.Dot(Vec.Cross(Vector3.UnitX, Vector3.UnitY), Vector3.UnitZ) > 0f ? 1f : -1f));
        IkResult first = CcdIk.Apply(a, [0, 1, 2, 3, 4], inA, CcdSettings.Default, one.Local, one.Model);
        IkResult second = CcdIk.Apply(b, [0, 1, 2, 3, 4], inB, CcdSettings.Default, two.Local, two.Model);
        Assert.True(first.Reached && second.Reached, FormattableString.Invariant($"{first} {second}"));
        for (int k = 0; k < 5; k++)
        {
            Assert.Equal(Vec.Length(one.ModelPositions[k]), Vec.Length(two.ModelPositions[k]), 4);
        }
    }
}
