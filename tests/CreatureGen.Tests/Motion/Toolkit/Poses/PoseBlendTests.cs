using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using CreatureGen.Tests.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Poses;

public sealed class PoseBlendTests
{
    private static readonly Skeleton skeleton = MovingPose.Chain(6, 0.3f, JointLimit.Free);

    [Fact]
    public void The_ends_of_a_mix_are_the_poses_themselves()
    {
        MovingPose a = new MovingPose(skeleton).Shaken(1);
        MovingPose b = new MovingPose(skeleton).Shaken(2);
        var result = new MovingPose(skeleton);
        PoseBlend.Mix(a.Local, b.Local, 0f, result.Local);
        Same(a, result, 1e-6);
        PoseBlend.Mix(a.Local, b.Local, 1f, result.Local);
        Same(b, result, 1e-6);
        PoseBlend.Slerp(a.Local, b.Local, 1f, result.Local);
        Same(b, result, 1e-6);
    }

    [Fact]
    public void A_quarter_of_a_slerp_from_rest_to_80_degrees_is_20_degrees()
    {
        var a = new MovingPose(skeleton);
        var b = new MovingPose(skeleton);
        b.LocalRotations[2] = Rotation.FromAxisAngle(Vector3.UnitX, Scalar.Radians(80));
        var result = new MovingPose(skeleton);
        PoseBlend.Slerp(a.Local, b.Local, 0.25f, result.Local);
        Assert.Equal(20, Scalar.Degrees(Rotation.Angle(result.LocalRotations[2])), 4);
        PoseBlend.Mix(a.Local, b.Local, 0.5f, result.Local);
        Assert.Equal(40, Scalar.Degrees(Rotation.Angle(result.LocalRotations[2])), 4);
    }

    [Fact]
    public void Joints_that_slide_do_so_in_proportion()
    {
        var a = new MovingPose(skeleton);
        var b = new MovingPose(skeleton);
        b.LocalPositions[3] += new Vector3(0.2f, -0.4f, 1f);
        var result = new MovingPose(skeleton);
        PoseBlend.Slerp(a.Local, b.Local, 0.25f, result.Local);
        Assert.Equal(0f, Vector3.Distance(a.LocalPositions[3] + new Vector3(0.05f, -0.1f, 0.25f), result.LocalPositions[3]), 1e-6f);
        PoseBlend.Mix(a.Local, b.Local, 0.25f, result.Local);
        Assert.Equal(0f, Vector3.Distance(a.LocalPositions[3] + new Vector3(0.05f, -0.1f, 0.25f), result.LocalPositions[3]), 1e-6f);
    }

    [Fact]
    public void Blends_go_the_shorter_way_whatever_the_signs_of_the_quaternions()
    {
        var a = new MovingPose(skeleton);
        var b = new MovingPose(skeleton);
        Quaternion turn = Rotation.FromAxisAngle(Vector3.UnitZ, 1);
        b.LocalRotations[1] = new Quaternion(-turn.X, -turn.Y, -turn.Z, -turn.W);
        var result = new MovingPose(skeleton);
        PoseBlend.Mix(a.Local, b.Local, 0.5f, result.Local);
        Assert.Equal(0.5, Rotation.Angle(result.LocalRotations[1]), 6);
        PoseBlend.Slerp(a.Local, b.Local, 0.5f, result.Local);
        Assert.Equal(0.5, Rotation.Angle(result.LocalRotations[1]), 6);
    }

    [Fact]
    public void Mix_stays_within_8_2_degrees_of_slerp_even_between_opposite_rotations()
    {
        var a = new MovingPose(skeleton);
        var b = new MovingPose(skeleton);
        b.LocalRotations[0] = Rotation.FromAxisAngle(Vector3.UnitY, PortableMath.Pi);
        var nlerp = new MovingPose(skeleton);
        var slerp = new MovingPose(skeleton);
        double worst = 0;
        for (int i = 0; i <= 100; i++)
        {
            PoseBlend.Mix(a.Local, b.Local, i / 100f, nlerp.Local);
            PoseBlend.Slerp(a.Local, b.Local, i / 100f, slerp.Local);
            worst = Math.Max(worst, MovingPose.Between(nlerp.LocalRotations[0], slerp.LocalRotations[0]));
            Assert.Equal(1f, nlerp.LocalRotations[0].Length(), 1e-6f);
        }

        Assert.InRange(Scalar.Degrees(worst), 8.0, 8.2);
    }

    [Fact]
    public void A_mask_blends_its_joints_and_leaves_the_others()
    {
        MovingPose a = new MovingPose(skeleton).Shaken(1);
        MovingPose b = new MovingPose(skeleton).Shaken(2);
        MovingPose whole = new MovingPose(skeleton);
        PoseBlend.Mix(a.Local, b.Local, 0.3f, whole.Local);
        var result = new MovingPose(skeleton);
        float[] mask = new float[skeleton.Count];
        Subtree.FillMask(skeleton, 3, 1f, mask);
        PoseBlend.Mix(a.Local, b.Local, 0.3f, mask, result.Local);
        for (int i = 0; i < skeleton.Count; i++)
        {
            Quaternion expected = i < 3 ? a.LocalRotations[i] : whole.LocalRotations[i];
            Assert.True(MovingPose.Between(expected, result.LocalRotations[i]) < 1e-6);
        }
    }

    [Fact]
    public void Two_poses_in_a_mixer_are_their_mix_and_the_order_of_three_does_not_matter()
    {
        MovingPose a = new MovingPose(skeleton).Shaken(1);
        MovingPose b = new MovingPose(skeleton).Shaken(2);
        MovingPose c = new MovingPose(skeleton).Shaken(3);
        var expected = new MovingPose(skeleton);
        PoseBlend.Mix(a.Local, b.Local, 0.25f, expected.Local);
        var result = new MovingPose(skeleton);
        float[] totals = new float[skeleton.Count];
        var mixer = new PoseMixer(result.Local, totals);
        mixer.Add(a.Local, 3f);
        mixer.Add(b.Local, 1f);
        mixer.Finish(c.Local);
        Same(expected, result, 1e-6);

        mixer = new PoseMixer(expected.Local, totals);
        mixer.Add(a.Local, 1f);
        mixer.Add(b.Local, 2f);
        mixer.Add(c.Local, 3f);
        mixer.Finish(a.Local);
        mixer = new PoseMixer(result.Local, totals);
        mixer.Add(c.Local, 0.3f);
        mixer.Add(a.Local, 0.1f);
        mixer.Add(b.Local, 0.2f);
        mixer.Finish(a.Local);
        Same(expected, result, 1e-6);
    }

    [Fact]
    public void Joints_that_no_pose_claims_take_the_fallback_and_fade_into_it()
    {
        MovingPose a = new MovingPose(skeleton).Shaken(1);
        MovingPose rest = new(skeleton);
        var result = new MovingPose(skeleton);
        float[] mask = new float[skeleton.Count];
        mask[2] = 1f;
        mask[4] = 0.05f;
        var mixer = new PoseMixer(result.Local, new float[skeleton.Count]);
        mixer.Add(a.Local, 1f, mask);
        mixer.Finish(rest.Local);
        Assert.True(MovingPose.Between(rest.LocalRotations[1], result.LocalRotations[1]) < 1e-6);
        Assert.True(MovingPose.Between(a.LocalRotations[2], result.LocalRotations[2]) < 1e-6);
        Assert.True(MovingPose.Between(Rotation.Nlerp(rest.LocalRotations[4], a.LocalRotations[4], 0.5), result.LocalRotations[4]) < 1e-6);
    }

    [Fact]
    public void A_difference_laid_on_its_reference_gives_the_pose_back()
    {
        MovingPose a = new MovingPose(skeleton).Shaken(5);
        a.LocalPositions[0] += Vector3.One;
        MovingPose rest = new(skeleton);
        var difference = new MovingPose(skeleton);
        AdditivePose.Subtract(a.Local, rest.Local, difference.Local);
        MovingPose result = new(skeleton);
        AdditivePose.Add(difference.Local, 1f, result.Local);
        Same(a, result, 1e-6);
        AdditivePose.Add(difference.Local, -1f, result.Local);
        Same(rest, result, 2e-6);
        AdditivePose.Add(difference.Local, 0.5f, result.Local);
        AdditivePose.Add(difference.Local, 0.5f, result.Local);
        Same(a, result, 2e-6);
    }

    [Fact]
    public void The_mirror_image_of_a_mix_is_the_mix_of_the_mirror_images()
    {
        MovingPose a = new MovingPose(skeleton).Shaken(1);
        MovingPose b = new MovingPose(skeleton).Shaken(2);
        var result = new MovingPose(skeleton);
        PoseBlend.Mix(a.Local, b.Local, 0.4f, result.Local);
        var mirrored = new MovingPose(skeleton);
        Mirror(a);
        Mirror(b);
        PoseBlend.Mix(a.Local, b.Local, 0.4f, mirrored.Local);
        Mirror(result);
        Assert.Equal(result.LocalRotations, mirrored.LocalRotations);
        Assert.Equal(result.LocalPositions, mirrored.LocalPositions);
    }

    [Fact]
    public void Numbers_that_are_not_finite_and_poses_of_other_skeletons_are_refused_by_name()
    {
        MovingPose a = new(skeleton);
        MovingPose b = new(skeleton);
        MovingPose other = new(MovingPose.Chain(2, 1f, JointLimit.Free));
        Assert.Contains("weight", Assert.Throws<ArgumentException>(() => PoseBlend.Mix(a.Local, b.Local, float.NaN, a.Local)).Message);
        Assert.Contains("7 and 3 joints", Assert.Throws<ArgumentException>(() => PoseBlend.Mix(a.Local, other.Local, 0f, a.Local)).Message);
        b.LocalRotations[4].X = float.NaN;
        Assert.Contains("joint 4", Assert.Throws<ArgumentException>(() => PoseBlend.Mix(a.Local, b.Local, 0.5f, new MovingPose(skeleton).Local)).Message);
        Assert.Contains("joint 4", Assert.Throws<ArgumentException>(() => PoseBlend.Slerp(a.Local, b.Local, 0.5f, new MovingPose(skeleton).Local)).Message);
        float[] mask = new float[7];
        mask[3] = float.PositiveInfinity;
        Assert.Throws<ArgumentOutOfRangeException>(() => new PoseMixer(new MovingPose(skeleton).Local, new float[7]).Add(a.Local, 1f, mask));
        Assert.Throws<ArgumentOutOfRangeException>(() => new PoseMixer(new MovingPose(skeleton).Local, new float[7]).Add(a.Local, -1f));
    }

    [Fact]
    public void A_cross_fade_rises_from_0_to_1_with_flat_ends_whatever_the_steps()
    {
        var fine = new CrossFade(0.4f);
        var coarse = new CrossFade(0.4f);
        float last = 0f;
        for (int i = 0; i < 30; i++)
        {
            fine.Advance(0.01f);
            Assert.True(fine.Weight >= last && fine.Weight - last < 0.05f);
            last = fine.Weight;
        }

        coarse.Advance(0.3f);
        Assert.Equal(coarse.Weight, fine.Weight, 1e-5f);
        Assert.Equal(0.896f, coarse.Weight, 1e-3f);
        coarse.Advance(0f);
        coarse.Advance(5f);
        Assert.Equal(1f, coarse.Weight);
        Assert.True(coarse.IsFinished && default(CrossFade).IsFinished && new CrossFade(0f).Weight == 1f);
        Assert.Throws<ArgumentOutOfRangeException>(() => new CrossFade(float.NaN));
    }

    [Fact]
    public void The_places_of_a_subtree_are_those_of_the_whole_chain_and_no_other_place_is_touched()
    {
        foreach (BodyPlan plan in new[] { BodyPlan.Centaur, BodyPlan.Flapping, BodyPlan.Hexapod })
        {
            Skeleton real = RigSubject.Of(plan).Skeleton;
            for (int joint = 0; joint < real.Count; joint += 3)
            {
                MovingPose pose = new MovingPose(real).Shaken(4);
                pose.LocalRotations[joint] = Rotation.FromAxisAngle(Vector3.UnitX, 0.9);
                pose.LocalPositions[joint] += Vector3.UnitY;
                Subtree.LocalToModel(real, joint, pose.Local, pose.Model);
                var whole = new MovingPose(real);
                pose.LocalRotations.CopyTo(whole.LocalRotations, 0);
                pose.LocalPositions.CopyTo(whole.LocalPositions, 0);
                whole.Chained();
                for (int i = 0; i < real.Count; i++)
                {
                    Assert.True(Vec.Distance(whole.ModelPositions[i], pose.ModelPositions[i]) < 1e-6f);
                    Assert.True(MovingPose.Between(whole.ModelRotations[i], pose.ModelRotations[i]) < 1e-6);
                }
            }
        }
    }

    [Fact]
    public void Blending_allocates_nothing()
    {
        MovingPose a = new MovingPose(skeleton).Shaken(1);
        MovingPose b = new MovingPose(skeleton).Shaken(2);
        MovingPose result = new(skeleton);
        float[] totals = new float[skeleton.Count];
        var offsets = new InertialOffset[skeleton.Count];
        Assert.Equal(0, MovingPose.Allocated(() =>
        {
            PoseBlend.Mix(a.Local, b.Local, 0.5f, totals, result.Local);
            PoseBlend.Slerp(a.Local, b.Local, 0.5f, result.Local);
            var mixer = new PoseMixer(result.Local, totals);
            mixer.Add(a.Local, 1f);
            mixer.Finish(b.Local);
            AdditivePose.Add(b.Local, 0.5f, result.Local);
            Inertialisation.Start(a.Local, b.Local, result.Local, result.Local, 0.01f, 0.2f, offsets);
            Inertialisation.Apply(offsets, 0.1f, result.Local);
            Subtree.LocalToModel(skeleton, 2, a.Local, a.Model);
        }));
    }

    private static void Mirror(MovingPose pose)
    {
        for (int i = 0; i < pose.LocalRotations.Length; i++)
        {
            pose.LocalRotations[i] = Rotation.Mirror(pose.LocalRotations[i]);
            pose.LocalPositions[i] = Vec.Mirror(pose.LocalPositions[i]);
        }
    }

    private static void Same(MovingPose expected, MovingPose actual, double tolerance)
    {
        for (int i = 0; i < expected.LocalRotations.Length; i++)
        {
            Assert.True(MovingPose.Between(expected.LocalRotations[i], actual.LocalRotations[i]) < tolerance);
            Assert.True(Vec.Distance(expected.LocalPositions[i], actual.LocalPositions[i]) < tolerance);
        }
    }
}
