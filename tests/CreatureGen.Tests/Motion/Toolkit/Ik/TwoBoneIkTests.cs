using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using CreatureGen.Tests.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ik;

public sealed class TwoBoneIkTests
{
    private static readonly Vector3 root = new(1f, 2f, 3f);

    [Fact]
    public void A_target_at_root_two_from_two_unit_bones_bends_the_knee_by_a_right_angle()
    {
        IkResult result = Limb(new Vector3(0f, (float)-Math.Sqrt(2), 0f), Vector3.UnitZ, Reach.Default, out Vector3 knee, out Vector3 end);
        Assert.True(result.Reached);
        Assert.True(Vec.Distance(knee, new Vector3(0f, -0.70710678f, 0.70710678f)) < 1e-5f);
        Assert.True(Vec.Distance(end, new Vector3(0f, (float)-Math.Sqrt(2), 0f)) < 1e-5f);
    }

    [Fact]
    public void Any_target_within_reach_is_met_with_the_knee_towards_the_pole_and_bones_of_their_length()
    {
        RandomStream random = new Seed(1).Stream();
        for (int i = 0; i < 5000; i++)
        {
            Vector3 target = MovingPose.Direction(random) * (float)random.Uniform(0.6, 1.9);
            Vector3 pole = MovingPose.Direction(random);
            IkResult result = Limb(target, pole, Reach.Default, out Vector3 knee, out Vector3 end);
            Assert.True(result.Reached);
            Assert.True(Vec.Distance(target, end) < 1e-5f);
            Assert.Equal(1f, Vec.Length(knee), 1e-5f);
            Assert.Equal(1f, Vec.Distance(knee, end), 1e-5f);
            Vector3 along = Vec.Normalize(target);
            Vector3 bend = Vec.Reject(knee, along);
            Vector3 wanted = Vec.Reject(pole, along);
            if (Vec.Length(wanted) > 0.01f)
            {
                Assert.True(Vec.Distance(Vec.Normalize(bend), Vec.Normalize(wanted)) < 2e-3f / Vec.Length(wanted));
            }
        }
    }

    [Fact]
    public void The_lower_bone_turns_about_the_hinge_and_about_nothing_else()
    {
        RandomStream random = new Seed(2).Stream();
        for (int i = 0; i < 1000; i++)
        {
            var hinge = Vec.Normalize(new Vector3(1f, 0.05f, -0.03f));
            Vector3 target = MovingPose.Direction(random) * (float)random.Uniform(0.6, 1.9);
            TwoBoneIk.Solve(root, root - Vector3.UnitY, root + new Vector3(0f, -2f, 0.01f), hinge, root + target, MovingPose.Direction(random), Reach.Default, out Quaternion upper, out Quaternion lower);
            Quaternion relative = Rotation.Multiply(Rotation.Inverse(upper), lower);
            var axis = new Vector3(relative.X, relative.Y, relative.Z);
            Assert.True(Vec.Length(Vec.Cross(axis, hinge)) < 1e-6f);
        }
    }

    [Fact]
    public void Towards_its_end_the_reach_eases_without_overshoot_and_without_a_kink()
    {
        double max = Math.Sqrt(2 + (2 * PortableMath.Cos(0.2094)));
        double last = 0;
        double slope = 1;
        for (double d = 1.5; d < 2.4; d += 0.001)
        {
            double taken = Reach.Default.Limit(d, 1, 1, out IkStatus status);
            Assert.True(taken <= max && taken <= d + 1e-12 && taken > last);
            if (last > 0)
            {
                double now = (taken - last) / 0.001;
                Assert.InRange(now - slope, -0.016, 1e-9);
                slope = now;
            }

            last = taken;
            Assert.Equal(d > max ? IkStatus.TooFar : d > (1 - (1f - 0.968f)) * max ? IkStatus.Softened : IkStatus.Reached, status);
        }
    }

    [Fact]
    public void Beyond_reach_the_end_points_at_the_target_and_the_residual_is_the_gap()
    {
        IkResult far = Limb(new Vector3(0f, -5f, 0f), Vector3.UnitZ, Reach.Hard, out _, out Vector3 end);
        Assert.Equal(IkStatus.TooFar, far.Status);
        Assert.Equal(3f, far.Residual, 1e-5f);
        Assert.True(Vec.Distance(end, new Vector3(0f, -2f, 0f)) < 1e-5f);
        IkResult near = Limb(new Vector3(0f, -0.1f, 0f), Vector3.UnitZ, Reach.Default, out _, out end);
        Assert.Equal(IkStatus.TooNear, near.Status);
        Assert.Equal(Vec.Distance(end, new Vector3(0f, -0.1f, 0f)), near.Residual, 1e-5f);
        Assert.True(Math.Abs(end.X) + Math.Abs(end.Z) < 1e-5f && end.Y < -0.1f);
    }

    [Fact]
    public void A_target_at_the_root_a_pole_in_line_and_a_straight_or_folded_limb_are_safe()
    {
        foreach (Reach reach in new[] { Reach.Default, Reach.Hard })
        {
            foreach (Vector3 target in new[] { Vector3.Zero, new Vector3(1e-20f, 0f, 0f), new Vector3(0f, -1.5f, 0f), new Vector3(0f, -2f, 0f), new Vector3(0f, 0f, 1e6f) })
            {
                foreach (Vector3 pole in new[] { Vector3.UnitZ, Vector3.UnitY, Vector3.Zero, target })
                {
                    foreach (Vector3 end in new[] { new Vector3(0f, -2f, 0f), Vector3.Zero, new Vector3(0f, -1f, -1f) })
                    {
                        IkResult result = TwoBoneIk.Solve(Vector3.Zero, -Vector3.UnitY, end, Vector3.UnitX, target, pole, reach, out Quaternion upper, out Quaternion lower);
                        Assert.Equal(1f, upper.Length(), 1e-5f);
                        Assert.Equal(1f, lower.Length(), 1e-5f);
                        Vector3 reached = Rotation.Rotate(upper, -Vector3.UnitY) + Rotation.Rotate(lower, end + Vector3.UnitY);
                        Assert.Equal(result.Residual, Vec.Distance(reached, target), 2e-4f + (1e-6f * result.Residual));
                    }
                }
            }
        }
    }

    [Fact]
    public void The_pole_in_line_with_the_target_leaves_the_knee_in_its_plane()
    {
        Limb(new Vector3(0f, -1.5f, 0f), Vector3.UnitY, Reach.Default, out Vector3 knee, out _);
        Assert.True(Math.Abs(knee.X) < 1e-5f);
    }

    [Fact]
    public void Small_moves_of_the_target_through_the_whole_reach_move_the_knee_a_little()
    {
        Vector3 last = default;
        for (int i = 0; i <= 4000; i++)
        {
            float d = 0.3f + (i * 0.0005f);
            Limb(new Vector3(0f, -d, 0f), Vector3.UnitZ, Reach.Default, out Vector3 knee, out _);
            Assert.True(i == 0 || Vec.Distance(knee, last) < 0.005f, $"at {d}");
            last = knee;
        }
    }

    [Fact]
    public void Turned_moved_and_grown_the_answer_turns_moves_and_grows_with_it()
    {
        RandomStream random = new Seed(3).Stream();
        for (int i = 0; i < 300; i++)
        {
            Quaternion turn = MovingPose.AnyRotation(random);
            float scale = (float)random.Uniform(0.05, 20);
            Vector3 shift = MovingPose.Direction(random) * scale * 3f;
            Vector3 target = MovingPose.Direction(random) * 1.4f;
            Vector3 middle = new(0f, -1f, 0.1f);
            Vector3 end = new(0.1f, -1.8f, 0f);
            TwoBoneIk.Solve(Vector3.Zero, middle, end, Vector3.UnitX, target, Vector3.UnitZ, Reach.Default, out Quaternion upper, out Quaternion lower);
            TwoBoneIk.Solve(Place(Vector3.Zero), Place(middle), Place(end), Rotation.Rotate(turn, Vector3.UnitX), Place(target), Rotation.Rotate(turn, Vector3.UnitZ), Reach.Default, out Quaternion upper2, out Quaternion lower2);
            Assert.True(MovingPose.Between(Rotation.Multiply(turn, upper), Rotation.Multiply(upper2, turn)) < 2e-4);
            Assert.True(MovingPose.Between(Rotation.Multiply(turn, lower), Rotation.Multiply(lower2, turn)) < 2e-4);

            Vector3 Place(Vector3 v) => (Rotation.Rotate(turn, v) * scale) + shift;
        }
    }

    [Fact]
    public void The_mirror_image_has_the_mirrored_answer()
    {
        RandomStream random = new Seed(4).Stream();
        for (int i = 0; i < 300; i++)
        {
            Vector3 target = MovingPose.Direction(random) * 1.4f;
            Vector3 pole = MovingPose.Direction(random);
            Vector3 middle = new(0.2f, -1f, 0.1f);
            Vector3 end = new(0.1f, -1.8f, 0f);
            TwoBoneIk.Solve(Vector3.Zero, middle, end, Vector3.UnitX, target, pole, Reach.Default, out Quaternion upper, out Quaternion lower);
            TwoBoneIk.Solve(Vector3.Zero, Vec.Mirror(middle), Vec.Mirror(end), Vector3.UnitX, Vec.Mirror(target), Vec.Mirror(pole), Reach.Default, out Quaternion upper2, out Quaternion lower2);
            Assert.True(MovingPose.Between(Rotation.Mirror(upper), upper2) < 1e-5);
            Assert.True(MovingPose.Between(Rotation.Mirror(lower), lower2) < 1e-5);
        }
    }

    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void Legs_of_real_creatures_reach_what_is_within_their_length(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        MovingPose pose = new(subject.Skeleton);
        RandomStream random = new Seed(5).Stream();
        foreach (LimbChain limb in subject.Rig.Limbs)
        {
            if (limb.Kind is not (LimbKind.Leg or LimbKind.Arm))
            {
                continue;
            }

            (int hip, int knee, int ankle) = (limb.Joints[1], limb.Joints[2], limb.Joints[3]);
            float length = limb.RestLengths[1] + limb.RestLengths[2];
            for (int i = 0; i < 20; i++)
            {
                Vector3 hipPlace = pose.ModelPositions[hip];
                Vector3 target = hipPlace + (Vec.Normalize(new Vector3((float)random.Uniform(-0.3, 0.3), -1f, (float)random.Uniform(-0.5, 0.5))) * (length * 0.85f));
                IkResult result = TwoBoneIk.Apply(subject.Skeleton, hip, knee, ankle, target, limb.Pole, Reach.Default, 1f, pose.Local, pose.Model);
                Assert.True(result.Reached, $"{plan} {subject.Skeleton.Joints[hip].Name}: {result}");
                Assert.True(Vec.Distance(pose.ModelPositions[ankle], target) < 1e-4f * length);
                MovingPose whole = new(subject.Skeleton);
                pose.LocalRotations.CopyTo(whole.LocalRotations, 0);
                whole.Chained();
                Assert.True(Vec.Distance(whole.ModelPositions[limb.Joints[^1]], pose.ModelPositions[limb.Joints[^1]]) < 1e-5f * length);
            }
        }
    }

    [Fact]
    public void Weights_lead_from_the_pose_to_the_answer()
    {
        Skeleton skeleton = MovingPose.Chain(3, 1f, new JointLimit(2.5f, 1f, 1f));
        double last = -1;
        for (int i = 0; i <= 10; i++)
        {
            MovingPose pose = new(skeleton);
            TwoBoneIk.Apply(skeleton, 0, 1, 2, new Vector3(0f, 1f, 1f), Vector3.UnitY, Reach.Default, i / 10f, pose.Local, pose.Model);
            double bend = Rotation.Angle(pose.LocalRotations[1]);
            Assert.True(bend > last);
            last = bend;
            if (i == 0)
            {
                Assert.Equal(skeleton.LocalRotations.ToArray(), pose.LocalRotations);
            }
        }

        Assert.Equal(PortableMath.Pi / 2, last, 4);
    }

    [Fact]
    public void What_is_not_finite_or_no_limb_is_refused()
    {
        Skeleton skeleton = MovingPose.Chain(3, 1f, JointLimit.Free);
        MovingPose pose = new(skeleton);
        Assert.Contains("target", Assert.Throws<ArgumentException>(() => TwoBoneIk.Apply(skeleton, 0, 1, 2, new Vector3(float.NaN), Vector3.UnitZ, Reach.Default, 1f, pose.Local, pose.Model)).Message);
        Assert.Contains("joint 1", Assert.Throws<ArgumentException>(() => TwoBoneIk.Apply(skeleton, 2, 1, 3, Vector3.One, Vector3.UnitZ, Reach.Default, 1f, pose.Local, pose.Model)).Message);
        Assert.Throws<ArgumentException>(() => TwoBoneIk.Solve(root, root, root, Vector3.UnitX, root, Vector3.UnitZ, Reach.Default, out _, out _));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Reach(float.NaN));
    }

    [Fact]
    public void Solving_allocates_nothing()
    {
        Skeleton skeleton = MovingPose.Chain(5, 1f, new JointLimit(2.5f, 1f, 1f));
        MovingPose pose = new(skeleton);
        int[] chain = { 0, 1, 2, 3, 4, 5 };
        PantographLeg leg = new(Vector3.UnitZ - Vector3.UnitY, -Vector3.UnitZ - Vector3.UnitY, -Vector3.UnitY, Vector3.UnitX);
        Assert.Equal(0, MovingPose.Allocated(() =>
        {
            TwoBoneIk.Apply(skeleton, 0, 1, 2, new Vector3(0f, 1f, 1f), Vector3.UnitY, Reach.Default, 0.5f, pose.Local, pose.Model);
            CcdIk.Apply(skeleton, chain, new Vector3(2f, 2f, 1f), CcdSettings.Default, pose.Local, pose.Model);
            PantographIk.Solve(leg, new Vector3(0f, -2f, 0f), Vector3.UnitX, 0.3f, Reach.Default, out _, out _, out _);
            SwingTwistLimit.ClampPose(skeleton, pose.Local);
        }));
    }

    private static IkResult Limb(Vector3 target, Vector3 pole, in Reach reach, out Vector3 knee, out Vector3 end)
    {
        // Bones of 1 m hang straight down; the knee folds about +X.
        IkResult result = TwoBoneIk.Solve(root, root - Vector3.UnitY, root - (2f * Vector3.UnitY), Vector3.UnitX, root + target, pole, reach, out Quaternion upper, out Quaternion lower);
        knee = Rotation.Rotate(upper, -Vector3.UnitY);
        end = knee + Rotation.Rotate(lower, -Vector3.UnitY);
        return result;
    }

    [Theory]
    [InlineData(0.0)]
    [InlineData(0.3)]
    public void A_leg_from_elsewhere_without_limits_folds_about_its_own_bend_or_towards_the_pole(double bent)
    {
        // Bones along −X of joints that are turned any way, as other programs make them.
        Quaternion thigh = Rotation.FromAxisAngle(Vector3.UnitZ, PortableMath.Pi / 2);
        Skeleton leg = Skeleton.Build(
        [
            new("Hips", -1, Quaternion.Identity, new Vector3(0f, 1f, 0f)),
            new("Thigh", 0, Rotation.Multiply(Rotation.FromAxisAngle(Vector3.UnitX, -bent), thigh), new Vector3(0.1f, 0f, 0f)),
            new("Shin", 1, Rotation.FromAxisAngle(Vector3.UnitY, -2 * bent), new Vector3(-0.45f, 0f, 0f)),
            new("Foot", 2, Quaternion.Identity, new Vector3(-0.45f, 0f, 0f)),
        ]);
        MovingPose pose = new(leg);
        Vector3 target = new(0.15f, 0.3f, 0.2f);
        IkResult result = TwoBoneIk.Apply(leg, 1, 2, 3, target, Vector3.UnitZ, Reach.Default, 1f, pose.Local, pose.Model);
        Assert.True(result.Reached);
        Assert.True(Vec.Distance(target, pose.ModelPositions[3]) < 1e-4f);
        Vector3 middle = (pose.ModelPositions[1] + target) * 0.5f;
        Vector3 knee = pose.ModelPositions[2] - middle;
        Assert.True(Vec.Dot(Vec.Normalize(knee), Vec.Normalize(Vec.Reject(Vector3.UnitZ, Vec.Normalize(target - pose.ModelPositions[1])))) > 0.999f);
    }
}
