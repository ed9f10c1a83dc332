using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Tests.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Gaze;

public sealed class GazeTests
{
    private static readonly JointLimit wide = new(2f, 2f, 2f);

    [Fact]
    public void Left_is_positive_yaw_up_is_positive_pitch_and_a_turn_points_there()
    {
        LookAngles left = LookAngles.Of(Vector3.UnitX, 0f);
        Assert.Equal(PortableMath.Pi / 2, left.Yaw, 6);
        LookAngles up = LookAngles.Of(new Vector3(0f, 1f, 1f), 0f);
        Assert.Equal(PortableMath.Pi / 4, up.Pitch, 6);
        for (float yaw = -3f; yaw <= 3f; yaw += 0.5f)
        {
            for (float pitch = -1.4f; pitch <= 1.4f; pitch += 0.35f)
            {
                var angles = new LookAngles(yaw, pitch);
                Vector3 direction = Rotation.Rotate(angles.Turn(), Vector3.UnitZ);
                LookAngles again = LookAngles.Of(direction * 3f, 0f);
                Assert.Equal(yaw, again.Yaw, 1e-5f);
                Assert.Equal(pitch, again.Pitch, 1e-5f);
                Assert.True(Math.Abs(Rotation.Rotate(angles.Turn(), Vector3.UnitX).Y) < 1e-6f, "no roll");
            }
        }

        Assert.Equal(0.3f, LookAngles.Of(new Vector3(0.01f, 5f, 0f), 0.3f).Yaw);
    }

    [Fact]
    public void The_head_comes_to_point_at_a_target_within_its_range()
    {
        (Skeleton skeleton, GazeRig rig) = Giraffe(wide);
        foreach (Vector3 target in new[] { new Vector3(3f, 2f, 5f), new Vector3(-3f, 0f, 4f), new Vector3(0.5f, 4f, 6f) })
        {
            GazeState state = default;
            float error = float.MaxValue;
            MovingPose pose = new(skeleton);
            for (int i = 0; i < 120; i++)
            {
                pose = new MovingPose(skeleton);
                error = GazeSolver.Update(rig, ref state, GazeSettings.Default, GazeTarget.At(target), 1f / 60f, pose.Local, pose.Model);
            }

            Assert.True(error < 0.002f, $"{target}: {error}");
            Vector3 eyes = pose.ModelPositions[rig.Head];
            Vector3 ahead = Rotation.Rotate(Rotation.Multiply(pose.ModelRotations[rig.Head], Rotation.Inverse(skeleton.ModelRotations[rig.Head])), Vector3.UnitZ);
            Assert.True(Vec.Dot(ahead, Vec.Normalize(target - eyes)) > 0.9999f);
        }
    }

    [Fact]
    public void Every_joint_of_the_chain_takes_its_part_and_the_head_does_not_roll()
    {
        (Skeleton skeleton, GazeRig rig) = Giraffe(wide);
        GazeState state = default;
        MovingPose pose = Settle(rig, ref state, GazeTarget.Towards(new LookAngles(1f, 0f)), 2f, 1f / 60f);
        double last = 0;
        for (int i = 0; i < rig.Joints.Length; i++)
        {
            double turned = MovingPose.Between(skeleton.ModelRotations[rig.Joints[i]], pose.ModelRotations[rig.Joints[i]]);
            Assert.True(turned > last + 0.1);
            last = turned;
        }

        Assert.Equal(1.0, last, 2);
        Quaternion turn = Rotation.Multiply(pose.ModelRotations[rig.Head], Rotation.Inverse(skeleton.ModelRotations[rig.Head]));
        Assert.True(Math.Abs(Rotation.Rotate(turn, Vector3.UnitX).Y) < 1e-4f);
    }

    [Theory]
    [InlineData(1f / 30f)]
    [InlineData(1f / 60f)]
    [InlineData(1f / 144f)]
    public void The_way_to_a_target_does_not_depend_on_the_frame_rate(float step)
    {
        (Skeleton _, GazeRig rig) = Giraffe(wide);
        GazeState fine = default;
        GazeState coarse = default;
        MovingPose expected = Settle(rig, ref fine, GazeTarget.Towards(new LookAngles(1f, 0.4f)), 0.25f, 0.25f / 1000f);
        float seconds = step * MathF.Round(0.25f / step);
        MovingPose actual = Settle(rig, ref coarse, GazeTarget.Towards(new LookAngles(1f, 0.4f)), seconds, step);
        Assert.True(Math.Abs(fine.Yaw - coarse.Yaw) < 0.03f + (2f * Math.Abs(seconds - 0.25f)));

        // The frames do not end at the same moment; attention comes by 10 s⁻¹ / e at the fastest.
        Assert.True(Math.Abs(fine.Attention - coarse.Attention) < 1e-3f + (3.7f * Math.Abs(seconds - 0.25f)));
        Assert.NotSame(expected, actual);
    }

    [Theory]
    [InlineData(1f / 30f)]
    [InlineData(1f / 144f)]
    public void A_trunk_that_swings_does_not_take_the_head_along(float step)
    {
        (Skeleton skeleton, GazeRig rig) = Giraffe(wide);
        GazeState state = default;
        GazeTarget target = GazeTarget.At(new Vector3(0f, 0f, 1e5f));
        Settle(rig, ref state, target, 2f, step);
        double trunk = 0;
        double head = 0;
        for (int i = 0; i < 3f / step; i++)
        {
            MovingPose pose = new(skeleton);
            double swing = 0.5 * PortableMath.Sin(2 * PortableMath.Pi * 0.7 * i * step);
            pose.LocalRotations[0] = Rotation.Multiply(Rotation.FromAxisAngle(Vector3.UnitY, swing), pose.LocalRotations[0]);
            ForwardKinematics.LocalToModel(skeleton, pose.Local, pose.Model);
            GazeSolver.Update(rig, ref state, GazeSettings.Default, target, step, pose.Local, pose.Model);
            trunk = Math.Max(trunk, Math.Abs(swing));
            Vector3 ahead = Rotation.Rotate(Rotation.Multiply(pose.ModelRotations[rig.Head], rig.HeadToModel), Vector3.UnitZ);
            head = Math.Max(head, Math.Abs(PortableMath.Atan2(ahead.X, ahead.Z)));
        }

        Assert.True(trunk > 0.49);
        Assert.True(head < 0.005, FormattableString.Invariant($"the head swings by {head}"));
    }

    [Fact]
    public void Nothing_to_look_at_leaves_the_motion_to_the_bit_and_fading_out_comes_back_to_it()
    {
        (Skeleton skeleton, GazeRig rig) = Giraffe(new JointLimit(0.3f, 0.3f, 0.1f));
        GazeState state = default;
        MovingPose pose = new MovingPose(skeleton).Shaken(4);
        MovingPose motion = new MovingPose(skeleton).Shaken(4);
        GazeSolver.Update(rig, ref state, GazeSettings.Default, GazeTarget.None, 1f / 60f, pose.Local, pose.Model);
        Assert.Equal(motion.LocalRotations, pose.LocalRotations);
        Settle(rig, ref state, GazeTarget.Towards(new LookAngles(1f, 0f)), 1f, 1f / 60f);
        Assert.True(state.Weight > 0.99f);
        double last = double.MaxValue;
        for (int i = 0; i < 120; i++)
        {
            pose = new MovingPose(skeleton);
            GazeSolver.Update(rig, ref state, GazeSettings.Default, GazeTarget.None, 1f / 60f, pose.Local, pose.Model);
            double away = MovingPose.Between(skeleton.ModelRotations[rig.Head], pose.ModelRotations[rig.Head]);
            Assert.True(away <= last + 1e-5);
            last = away;
        }

        Assert.Equal(0f, state.Weight);
        Assert.Equal(skeleton.LocalRotations.ToArray(), pose.LocalRotations);
    }

    [Theory]
    [InlineData(1f / 60f)]
    [InlineData(1f / 240f)]
    public void The_head_turns_away_from_a_target_and_back_to_it_without_a_jerk(float step)
    {
        (Skeleton skeleton, GazeRig rig) = Giraffe(wide);
        GazeState state = default;
        GazeTarget aside = GazeTarget.Towards(new LookAngles(1.1f, 0.2f));
        MovingPose pose = Settle(rig, ref state, aside, 2f, step);
        Quaternion head = pose.ModelRotations[rig.Head];
        double speed = 0;
        double fastest = 0;
        for (int i = 0; i < 3f / step; i++)
        {
            // Away for a second and a half, then back; at the most half way through a fade the target comes and goes.
            GazeTarget target = i * step is < 1.5f or (> 1.9f and < 2f) ? GazeTarget.None : aside;
            pose = new MovingPose(skeleton);
            GazeSolver.Update(rig, ref state, GazeSettings.Default, target, step, pose.Local, pose.Model);
            double now = MovingPose.Between(head, pose.ModelRotations[rig.Head]) / step;
            head = pose.ModelRotations[rig.Head];

            // A spring of 10 s⁻¹ that is 1.12 rad away pulls by 112 rad/s²; the target's own spring may pull as hard.
            Assert.True(Math.Abs(now - speed) < (225 * step) + 0.02, FormattableString.Invariant($"after {i * step} s from {speed} to {now} rad/s"));
            fastest = Math.Max(fastest, now);
            speed = now;
        }

        Assert.True(fastest > 2, FormattableString.Invariant($"{fastest} rad/s"));
    }

    [Fact]
    public void A_target_behind_is_seen_over_the_nearer_shoulder_and_crossing_behind_does_not_whip_the_head_round()
    {
        GazeSettings settings = GazeSettings.Default;
        Assert.Equal(1.22f, GazeSolver.Bounded(new LookAngles(2.4f, 0f), 0f, settings).Yaw, 1e-5f);
        Assert.Equal(-1.22f, GazeSolver.Bounded(new LookAngles(-2.4f, 0f), 0f, settings).Yaw, 1e-5f);
        Assert.Equal(1.22f, GazeSolver.Bounded(new LookAngles(-3.0f, 0f), 1f, settings).Yaw, 1e-5f);
        Assert.Equal(-1.22f, GazeSolver.Bounded(new LookAngles(-2.5f, 0f), 1f, settings).Yaw, 1e-5f);

        (Skeleton _, GazeRig rig) = Giraffe(wide);
        GazeState state = default;
        Settle(rig, ref state, GazeTarget.Towards(new LookAngles(2.9f, 0f)), 1f, 1f / 60f);
        int turns = 0;
        float before = state.Yaw;
        for (int i = 0; i < 200; i++)
        {
            float yaw = 3.14159f - (0.3f * (i % 2 == 0 ? 1f : -1f));
            yaw = yaw > 3.14159f ? yaw - 6.28319f : yaw;
            Settle(rig, ref state, GazeTarget.Towards(new LookAngles(yaw, 0f)), 1f / 60f, 1f / 60f);
            turns += Math.Abs(state.Yaw - before) > 0.01f ? 1 : 0;
            before = state.Yaw;
        }

        Assert.Equal(0, turns);
        var losing = new GazeSettings(10f, loseBeyond: 2f);
        MovingPose pose = new(rig.Skeleton);
        for (int i = 0; i < 120; i++)
        {
            pose = new MovingPose(rig.Skeleton);
            GazeSolver.Update(rig, ref state, losing, GazeTarget.Towards(new LookAngles(2.9f, 0f)), 1f / 60f, pose.Local, pose.Model);
        }

        Assert.Equal(0f, state.Weight);
    }

    [Fact]
    public void Joints_stay_within_their_limits_and_others_take_over()
    {
        var stiff = new JointLimit(0.2f, 0.2f, 0.2f);
        (Skeleton skeleton, GazeRig rig) = Giraffe(stiff);
        GazeState state = default;
        MovingPose pose = Settle(rig, ref state, GazeTarget.Towards(new LookAngles(1.1f, 0.3f)), 2f, 1f / 60f);
        foreach (int joint in rig.Joints)
        {
            Quaternion turn = Rotation.Multiply(Rotation.Inverse(skeleton.LocalRotations[joint]), pose.LocalRotations[joint]);
            Assert.True(SwingTwistLimit.Excess(turn, stiff) < 3e-5f);
        }
    }

    [Fact]
    public void The_mirror_image_has_the_mirrored_look()
    {
        (Skeleton _, GazeRig rig) = Giraffe(wide);
        GazeState left = default;
        GazeState right = default;
        MovingPose a = Settle(rig, ref left, GazeTarget.At(new Vector3(2f, 3f, 3f)), 0.3f, 1f / 60f);
        MovingPose b = Settle(rig, ref right, GazeTarget.At(new Vector3(-2f, 3f, 3f)), 0.3f, 1f / 60f);
        for (int i = 0; i < a.ModelPositions.Length; i++)
        {
            Assert.True(Vec.Distance(Vec.Mirror(a.ModelPositions[i]), b.ModelPositions[i]) < 1e-5f);
        }
    }

    [Fact]
    public void Two_hundred_creatures_look_at_things_all_round_with_parallel_eyes_within_their_limits()
    {
        int reached = 0;
        int asked = 0;
        var worst = new List<string>();
        for (ulong seed = 0; seed < (ulong)Thoroughness.Of(200); seed++)
        {
            Creature creature = CreatureGenerator.Generate(seed);
            Skeleton skeleton = creature.Skeleton;
            GazeRig rig = GazeRig.Of(skeleton);
            Vector3 eyes = skeleton.ModelPositions[rig.Head];
            float far = 10f * skeleton.ModelPositions[rig.Head].Length();
            foreach (float yaw in new[] { 0f, 0.4f, -0.8f, 2f, -3f })
            {
                GazeState state = default;
                GazeTarget target = GazeTarget.At(eyes + (Rotation.Rotate(new LookAngles(yaw, 0.1f).Turn(), Vector3.UnitZ) * far));
                MovingPose pose = new(skeleton);
                float error = 0f;
                for (int i = 0; i < 60; i++)
                {
                    pose = new MovingPose(skeleton);
                    error = GazeSolver.Update(rig, ref state, GazeSettings.Default, target, 1f / 30f, pose.Local, pose.Model);
                    Eyes.Update(rig, ref state, EyeSettings.Default, target, 1f / 30f, pose.Local, pose.Model);
                }

                foreach (int joint in rig.Joints)
                {
                    Quaternion turn = Rotation.Multiply(Rotation.Inverse(skeleton.LocalRotations[joint]), pose.LocalRotations[joint]);
                    Assert.True(SwingTwistLimit.Excess(turn, skeleton.Joints[joint].Limit) < 1e-4f);
                }

                for (int j = 0; j < skeleton.Count; j++)
                {
                    Assert.True(Finite(pose.ModelPositions[j]));
                    if (skeleton.Joints[j].Role == JointRole.Eye)
                    {
                        Quaternion turn = Rotation.Multiply(Rotation.Inverse(skeleton.LocalRotations[j]), pose.LocalRotations[j]);
                        Assert.True(SwingTwistLimit.Excess(turn, skeleton.Joints[j].Limit) < 1e-4f);
                    }
                }

                if (Math.Abs(yaw) < 0.5f)
                {
                    asked++;
                    reached += error < 0.05f ? 1 : 0;
                    if (error >= 0.05f)
                    {
                        worst.Add(FormattableString.Invariant($"seed {seed} {creature.Blueprint.Plan} yaw {yaw}: {error:F2}"));
                    }
                }
            }
        }

        Assert.True(reached >= 0.8 * asked, $"{reached} of {asked}: {string.Join("; ", worst)}");
    }

    [Fact]
    public void Eyes_turn_alike_until_one_of_them_is_at_its_limit()
    {
        Skeleton skeleton = RigSubject.Of(BodyPlan.Digitigrade).Skeleton;
        GazeRig rig = GazeRig.Of(skeleton);
        GazeState state = default;
        MovingPose pose = new(skeleton);
        Vector3 head = skeleton.ModelPositions[rig.Head];
        GazeTarget target = GazeTarget.At(head + (Rotation.Rotate(new LookAngles(0.2f, 0.1f).Turn(), Vector3.UnitZ) * 50f));
        Eyes.Update(rig, ref state, EyeSettings.Default, target, 10f, pose.Local, pose.Model);
        Quaternion left = Rotation.Multiply(pose.ModelRotations[rig.LeftEye], Rotation.Inverse(skeleton.ModelRotations[rig.LeftEye]));
        Quaternion right = Rotation.Multiply(pose.ModelRotations[rig.RightEye], Rotation.Inverse(skeleton.ModelRotations[rig.RightEye]));
        Assert.True(MovingPose.Between(left, right) < 1e-5);
        Assert.True(Vec.Distance(Rotation.Rotate(left, Vector3.UnitZ), Rotation.Rotate(new LookAngles(0.2f, 0.1f).Turn(), Vector3.UnitZ)) < 0.02f);

        state = default;
        target = GazeTarget.At(head + (Rotation.Rotate(new LookAngles(1.2f, 0f).Turn(), Vector3.UnitZ) * 50f));
        Eyes.Update(rig, ref state, new EyeSettings(30f, 0.55f, 0.3f), target, 10f, pose.Local, pose.Model);
        left = Rotation.Multiply(pose.ModelRotations[rig.LeftEye], Rotation.Inverse(skeleton.ModelRotations[rig.LeftEye]));
        right = Rotation.Multiply(pose.ModelRotations[rig.RightEye], Rotation.Inverse(skeleton.ModelRotations[rig.RightEye]));
        Assert.Equal(0.3, Rotation.Angle(right), 2);
        Assert.True(Rotation.Angle(left) > 0.45);
    }

    [Fact]
    public void Aiming_one_joint_points_it_and_keeps_its_up_side_up()
    {
        var random = new CreatureGen.Seeding.Seed(3).Stream();
        for (int i = 0; i < 500; i++)
        {
            Quaternion rotation = MovingPose.AnyRotation(random);
            Vector3 direction = MovingPose.Direction(random) * 4f;
            Quaternion now = Rotation.Multiply(AimAt.Turn(rotation, Vector3.UnitY, Vector3.UnitZ, direction, Vector3.UnitY), rotation);
            Assert.True(Vec.Distance(Rotation.Rotate(now, Vector3.UnitY), Vec.Normalize(direction)) < 1e-5f);
            float slack = 5e-6f / Vec.Length(new Vector3(direction.X, 0f, direction.Z) / 4f);
            Assert.True(Math.Abs(Rotation.Rotate(now, Vector3.UnitX).Y) < slack && Rotation.Rotate(now, Vector3.UnitZ).Y > -slack);
        }

        Assert.Equal(Quaternion.Identity, AimAt.Turn(Quaternion.Identity, Vector3.UnitZ, Vector3.UnitY, Vector3.Zero, Vector3.UnitY));
        Quaternion up = AimAt.Turn(Quaternion.Identity, Vector3.UnitZ, Vector3.UnitY, Vector3.UnitY, Vector3.UnitY);
        Assert.True(Vec.Distance(Rotation.Rotate(up, Vector3.UnitZ), Vector3.UnitY) < 1e-6f);
        Assert.Throws<ArgumentException>(() => AimAt.Turn(Quaternion.Identity, Vector3.UnitZ, Vector3.UnitY, new Vector3(float.NaN), Vector3.UnitY));
    }

    [Fact]
    public void Looking_allocates_nothing_and_refuses_what_is_no_number()
    {
        Skeleton skeleton = RigSubject.Of(BodyPlan.Digitigrade).Skeleton;
        GazeRig rig = GazeRig.Of(skeleton);
        GazeState state = default;
        MovingPose pose = new(skeleton);
        GazeTarget target = GazeTarget.At(new Vector3(1f, 1f, 3f));
        Assert.Equal(0, MovingPose.Allocated(() =>
        {
            GazeSolver.Update(rig, ref state, GazeSettings.Default, target, 0.01f, pose.Local, pose.Model);
            Eyes.Update(rig, ref state, EyeSettings.Default, target, 0.01f, pose.Local, pose.Model);
        }));
        Assert.Throws<ArgumentException>(() => GazeTarget.At(new Vector3(float.NaN, 0f, 0f)));
        Assert.Throws<ArgumentOutOfRangeException>(() => GazeSolver.Update(rig, ref state, GazeSettings.Default, target, float.NaN, pose.Local, pose.Model));
        Assert.Throws<ArgumentOutOfRangeException>(() => new GazeSettings(-1f));
        Assert.Throws<ArgumentException>(() => new GazeRig(skeleton, new[] { 0 }, new[] { 1f }));
    }

    private static bool Finite(Vector3 v) => v - v == Vector3.Zero;

    private static MovingPose Settle(GazeRig rig, ref GazeState state, GazeTarget target, float seconds, float step)
    {
        MovingPose pose = new(rig.Skeleton);
        int steps = (int)Math.Round(seconds / step);
        for (int i = 0; i < steps; i++)
        {
            pose = new MovingPose(rig.Skeleton);
            GazeSolver.Update(rig, ref state, GazeSettings.Default, target, step, pose.Local, pose.Model);
        }

        return pose;
    }

    /// <summary>A trunk, four bones of neck going up and forward, and a head that lies level.</summary>
    private static (Skeleton Skeleton, GazeRig Rig) Giraffe(JointLimit limit)
    {
        var joints = new List<Joint>();
        Quaternion trunk = Rotation.FromAxisAngle(Vector3.UnitX, PortableMath.Pi / 2);
        Quaternion slope = Rotation.FromAxisAngle(Vector3.UnitX, PortableMath.Pi / 4);
        Add("Chest", JointRole.Chest, new Vector3(0f, 1f, 0f), trunk, 0.5f);
        Vector3 along = Rotation.Rotate(slope, Vector3.UnitY);
        for (int i = 0; i < 4; i++)
        {
            Add(FormattableString.Invariant($"Neck_0{i + 1}"), JointRole.Neck, new Vector3(0f, 1f, 0.5f) + (along * (0.3f * i)), slope, 0.3f);
        }

        Add("Head", JointRole.Head, new Vector3(0f, 1f, 0.5f) + (along * 1.2f), trunk, 0.4f);
        var skeleton = new Skeleton(joints);
        return (skeleton, GazeRig.Of(skeleton));

        void Add(string name, JointRole role, Vector3 position, Quaternion rotation, float length)
        {
            int parent = joints.Count - 1;
            Quaternion inverse = parent < 0 ? Quaternion.Identity : Rotation.Inverse(joints[parent].ModelRotation);
            Vector3 from = parent < 0 ? Vector3.Zero : joints[parent].ModelPosition;
            joints.Add(new Joint(name, role, Side.Median, parent, Rotation.Rotate(inverse, position - from), Rotation.Multiply(inverse, rotation), position, rotation, length, limit));
        }
    }
}
