using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Springs;

public sealed class SpringBonesTests
{
    private const int Bones = 6;
    private static readonly Skeleton skeleton = MovingPose.Chain(Bones + 1, 0.2f, JointLimit.Free);
    private static readonly SpringRig rig = new(skeleton, new[] { 1 });
    private static readonly SpringSettings soft = new(new ChainCurve(3f, 1.5f), new ChainCurve(0.5f));

    [Fact]
    public void At_rest_the_pose_is_the_animated_pose()
    {
        var state = new SpringState(rig);
        MovingPose pose = new(skeleton);
        for (int i = 0; i < 100; i++)
        {
            pose = Step(state, soft, RootPlace.Identity, 1f / 60f);
        }

        for (int i = 0; i < skeleton.Count; i++)
        {
            Assert.True(Vec.Distance(skeleton.ModelPositions[i], pose.ModelPositions[i]) < 1e-5f);
        }
    }

    [Fact]
    public void Pushed_sideways_the_tip_lags_swings_through_and_comes_to_rest_with_bones_of_their_length()
    {
        var state = new SpringState(rig);
        MovingPose pose = Step(state, soft, RootPlace.Identity, 1f / 60f);
        float min = 0f;
        float max = 0f;
        for (int i = 0; i < 400; i++)
        {
            float x = Math.Min(i / 30f, 1f);
            pose = Step(state, soft, new RootPlace(new Vector3(x, 0f, 0f), Quaternion.Identity), 1f / 60f);
            min = Math.Min(min, pose.ModelPositions[^1].X);
            max = Math.Max(max, pose.ModelPositions[^1].X);
            for (int k = 1; k < skeleton.Count; k++)
            {
                Assert.Equal(0.2f, Vec.Distance(pose.ModelPositions[k], pose.ModelPositions[k - 1]), 1e-6f);
            }
        }

        Assert.True(min < -0.02f && max > 0.01f, $"{min} {max}");
        Assert.True(Math.Abs(pose.ModelPositions[^1].X) < 1e-3f);
    }

    /// <summary>Who is put elsewhere, or turned about at once, was not thrown there.</summary>
    [Fact]
    public void A_jump_of_the_root_swings_nothing_and_a_shorter_one_does()
    {
        var there = new RootPlace(new Vector3(6f, 0f, 0f), Quaternion.Identity);
        Assert.True(SwingAfter(there, new SpringSettings(new ChainCurve(3f, 1.5f), new ChainCurve(0.5f))) < 1e-3f);
        Assert.True(SwingAfter(there, new SpringSettings(new ChainCurve(3f, 1.5f), new ChainCurve(0.5f), teleportDistance: 20f)) > 0.05f);
        var about = new RootPlace(Vector3.Zero, Rotation.FromAxisAngle(Vector3.UnitX, 1.2f));
        Assert.True(SwingAfter(about, new SpringSettings(new ChainCurve(3f, 1.5f), new ChainCurve(0.5f), teleportAngle: 1f)) < 1e-3f);
        Assert.True(SwingAfter(about, new SpringSettings(new ChainCurve(3f, 1.5f), new ChainCurve(0.5f), teleportAngle: 1.4f)) > 0.05f);
    }

    /// <summary>How far the tip is from where the animation has it, most of a second after the root was moved in one frame.</summary>
    private static float SwingAfter(RootPlace place, SpringSettings settings)
    {
        var state = new SpringState(rig);
        Step(state, settings, RootPlace.Identity, 1f / 60f);
        float most = 0f;
        for (int i = 0; i < 60; i++)
        {
            MovingPose pose = Step(state, settings, place, 1f / 60f);
            most = Math.Max(most, Vec.Distance(skeleton.ModelPositions[^1], pose.ModelPositions[^1]));
        }

        return most;
    }

    [Fact]
    public void At_a_steady_speed_the_chain_is_straight_again()
    {
        var state = new SpringState(rig);
        MovingPose pose = new(skeleton);
        for (int i = 0; i < 400; i++)
        {
            pose = Step(state, soft, new RootPlace(new Vector3(0f, 0f, i * 0.05f), Quaternion.Identity), 1f / 60f);
        }

        Assert.True(Math.Abs(pose.ModelPositions[^1].Z) < 2e-3f);
    }

    [Fact]
    public void Damped_and_hung_from_one_side_a_single_bone_sinks_by_gravity_over_its_frequency_squared()
    {
        Skeleton one = MovingPose.Chain(2, 1f, JointLimit.Free);
        var single = new SpringRig(one, new[] { 1 });
        var state = new SpringState(single);
        var settings = new SpringSettings(new ChainCurve(2f), new ChainCurve(1f), gravity: new Vector3(5f, 0f, 0f));
        MovingPose pose = new(one);
        for (int i = 0; i < 300; i++)
        {
            pose = new MovingPose(one);
            SpringBones.Update(single, state, settings, RootPlace.Identity, ReadOnlySpan<SpringCollider>.Empty, 1f / 60f, pose.Local, pose.Model);
        }

        // On the circle: ω² · distance from the goal balances gravity across the bone: ω² · 2 sin(a/2) cos(a/2) = g cos a.
        double w = 2 * PortableMath.Tau;
        double tangent = 5 / (w * w);
        Assert.Equal(tangent, pose.ModelPositions[2].X / (pose.ModelPositions[2].Y - 1f), 2e-3);
    }

    [Theory]
    [InlineData(1f / 30f)]
    [InlineData(1f / 60f)]
    [InlineData(1f / 144f)]
    [InlineData(1f / 37f)]
    public void At_any_frame_rate_the_tip_keeps_within_2_percent_of_the_chain_of_the_finest(float step)
    {
        double sum = 0;
        int count = 0;
        SpringState fine = new(rig);
        SpringState coarse = new(rig);
        float time = 0f;
        double fineTime = 0;
        Vector3 expected = default;
        Step(fine, soft, Running(0f), 0f);
        Step(coarse, soft, Running(0f), 0f);
        while (time < 3f)
        {
            time += step;
            while (fineTime < time - 1e-6)
            {
                double next = Math.Min(fineTime + (1 / 960.0), time);
                expected = Step(fine, soft, Running((float)next), (float)(next - fineTime)).ModelPositions[^1];
                fineTime = next;
            }

            Vector3 actual = Step(coarse, soft, Running(time), step).ModelPositions[^1];
            sum += Vec.LengthSquared(actual - expected);
            count++;
        }

        Assert.True(Math.Sqrt(sum / count) < 0.02 * rig.Length, $"{Math.Sqrt(sum / count) / rig.Length}");
    }

    [Theory]
    [InlineData(0.05f)]
    [InlineData(20f)]
    public void A_creature_of_another_size_has_the_same_angles_when_all_accelerations_grow_with_it(float scale)
    {
        SpringState own = new(rig);
        SpringState grown = new(rig);
        var far = new SpringSettings(new ChainCurve(3f, 1.5f), new ChainCurve(0.5f), teleportDistance: 1e6f);
        for (int i = 0; i < 120; i++)
        {
            RootPlace at = Running(i / 60f);
            MovingPose a = Step(own, far, at, 1f / 60f);
            MovingPose b = Step(grown, far, new RootPlace(at.Position * scale, at.Rotation, scale), 1f / 60f);
            for (int k = 0; k < skeleton.Count; k++)
            {
                Assert.True(Vec.Distance(a.ModelPositions[k], b.ModelPositions[k]) < 1e-4f);
            }
        }
    }

    [Theory]
    [InlineData(0f)]
    [InlineData(1e-6f)]
    [InlineData(0.001f)]
    [InlineData(0.1f)]
    [InlineData(0.25f)]
    [InlineData(10f)]
    public void However_long_the_step_and_stiff_the_spring_all_stays_finite_and_within_the_cone(float step)
    {
        foreach (float stiffer in new[] { 0f, 1f, 10f, 100f })
        {
            var settings = new SpringSettings(new ChainCurve(3f * stiffer), new ChainCurve(0.1f), gravity: new Vector3(0f, -9.81f, 0f));
            SpringState state = new(rig);
            for (int i = 0; i < 60; i++)
            {
                MovingPose pose = Step(state, settings, Running(i * step), step);
                for (int k = 1; k < skeleton.Count; k++)
                {
                    Assert.Equal(0.2f, Vec.Distance(pose.ModelPositions[k], pose.ModelPositions[k - 1]), 1e-5f);
                    Assert.True(Rotation.Angle(pose.LocalRotations[k]) < 3.2);
                }
            }
        }
    }

    [Fact]
    public void A_teleport_a_rebase_and_a_pause_leave_the_shape_as_it_is()
    {
        SpringState state = new(rig);
        MovingPose before = new(skeleton);
        for (int i = 0; i < 40; i++)
        {
            before = Step(state, soft, Running(i / 60f), 1f / 60f);
        }

        RootPlace here = Running(39f / 60f);
        MovingPose same = Step(state, soft, here, 0f);
        AssertClose(before, same, 1e-5f);

        var there = new RootPlace(here.Position + new Vector3(100f, 5f, -30f), here.Rotation);
        MovingPose after = Step(state, soft, there, 0f);
        AssertClose(before, after, 1e-5f);

        state.Rebase(new Vector3(-5000f, 0f, 0f));
        there = new RootPlace(there.Position + new Vector3(-5000f, 0f, 0f), there.Rotation);
        after = Step(state, soft, there, 0f);
        AssertClose(before, after, 1e-5f);

        var turned = new RootPlace(there.Position, Rotation.Multiply(Rotation.FromAxisAngle(Vector3.UnitY, 3), there.Rotation));
        state.Teleport(turned);
        after = Step(state, soft, turned, 0f);
        AssertClose(before, after, 1e-4f);

        after = Step(state, soft, new RootPlace(new Vector3(7f), Quaternion.Identity), 5f);
        AssertClose(before, after, 1e-4f);

        state.Reset();
        AssertClose(new MovingPose(skeleton), Step(state, soft, RootPlace.Identity, 1f / 60f), 1e-5f);
    }

    [Fact]
    public void Without_inertia_the_creature_may_move_as_it_likes()
    {
        var calm = new SpringSettings(new ChainCurve(2f), new ChainCurve(0.5f), inertia: 0f);
        SpringState state = new(rig);
        for (int i = 0; i < 200; i++)
        {
            AssertClose(new MovingPose(skeleton), Step(state, calm, Running(i / 60f), 1f / 60f), 1e-4f);
        }
    }

    [Fact]
    public void Tips_stay_out_of_spheres_capsules_and_the_ground()
    {
        var settings = new SpringSettings(new ChainCurve(0f), new ChainCurve(2f), new ChainCurve(0.05f), new Vector3(0f, -9.81f, 0f), 3.14f, 1f);
        SpringCollider[] colliders =
        {
            SpringCollider.Plane(new Vector3(0f, -0.1f, 0f), Vector3.UnitY),
            SpringCollider.Capsule(-1, new Vector3(0.3f, 0.3f, -1f), new Vector3(0.3f, 0.3f, 1f), 0.15f),
            SpringCollider.Capsule(0, new Vector3(0f, 0.05f, 0f), new Vector3(0f, 0.05f, 0f), 0.05f),
        };
        SpringState state = new(rig);
        MovingPose pose = new(skeleton);
        for (int i = 0; i < 600; i++)
        {
            pose = new MovingPose(skeleton);
            pose.LocalRotations[0] = Rotation.FromAxisAngle(Vec.Normalize(new Vector3(0.1f, 0f, -1f)), Math.Min(i / 100.0, 1.5));
            pose.Chained();
            SpringBones.Update(rig, state, settings, RootPlace.Identity, colliders, 1f / 60f, pose.Local, pose.Model);
            for (int k = 2; k < skeleton.Count; k++)
            {
                Assert.True(pose.ModelPositions[k].Y > -0.1f + 0.05f - 1e-4f, $"{i} {k} {pose.ModelPositions[k]}");
            }
        }

        for (int k = 3; k < skeleton.Count; k++)
        {
            Vector3 p = pose.ModelPositions[k];
            float fromAxis = Vec.Length(new Vector3(p.X - 0.3f, p.Y - 0.3f, 0f));
            Assert.True(fromAxis > 0.15f + 0.05f - 0.02f, $"{k} {p}");
        }
    }

    [Fact]
    public void The_mirror_image_swings_the_other_way()
    {
        SpringState left = new(rig);
        SpringState right = new(rig);
        for (int i = 0; i < 120; i++)
        {
            RootPlace at = Running(i / 60f);
            MovingPose a = Step(left, soft, at, 1f / 60f);
            MovingPose b = Step(right, soft, new RootPlace(Vec.Mirror(at.Position), Rotation.Mirror(at.Rotation)), 1f / 60f);
            for (int k = 0; k < skeleton.Count; k++)
            {
                Assert.True(Vec.Distance(Vec.Mirror(a.ModelPositions[k]), b.ModelPositions[k]) < 1e-5f);
            }
        }
    }

    [Fact]
    public void Settings_may_change_from_frame_to_frame_without_a_jump()
    {
        Assert.InRange(MaxStep(true), 0.5f * MaxStep(false), 1.5f * MaxStep(false));

        static float MaxStep(bool changes)
        {
            SpringState state = new(rig);
            MovingPose last = Step(state, soft, Running(0f), 0f);
            float max = 0f;
            for (int i = 1; i < 240; i++)
            {
                SpringSettings settings = changes && (i / 20) % 2 == 1 ? new SpringSettings(new ChainCurve(4f, 2f), new ChainCurve(0.9f)) : soft;
                MovingPose now = Step(state, settings, Running(i / 60f), 1f / 60f);
                max = Math.Max(max, Vec.Distance(now.ModelPositions[^1], last.ModelPositions[^1]));
                last = now;
            }

            return max;
        }
    }

    [Fact]
    public void Tails_and_ears_of_fifty_creatures_swing_and_calm_down()
    {
        int chains = 0;
        for (ulong seed = 0; seed < 50; seed++)
        {
            Creature creature = CreatureGenerator.Generate(seed);
            foreach (JointRole role in new[] { JointRole.Tail, JointRole.Ear, JointRole.Antenna })
            {
                SpringRig own = SpringRig.Of(creature.Skeleton, role);
                if (own.Joints.Length == 0)
                {
                    continue;
                }

                chains++;
                SpringState state = new(own);
                SpringSettings settings = role switch { JointRole.Tail => SpringSettings.Tail(own.Length), JointRole.Ear => SpringSettings.Ear(own.Length), _ => SpringSettings.Antenna(own.Length) };
                float swing = 0f;
                MovingPose pose = new(creature.Skeleton);
                for (int i = 0; i < 400; i++)
                {
                    pose = new MovingPose(creature.Skeleton);
                    float turn = (float)PortableMath.Sin(Math.Min(i, 100) * 0.1);
                    var at = new RootPlace(new Vector3(turn * own.Length, 0f, 0f), Rotation.FromAxisAngle(Vector3.UnitY, turn));
                    SpringBones.Update(own, state, settings, at, ReadOnlySpan<SpringCollider>.Empty, 1f / 60f, pose.Local, pose.Model);
                    foreach (int joint in own.Joints)
                    {
                        swing = Math.Max(swing, (float)MovingPose.Between(creature.Skeleton.LocalRotations[joint], pose.LocalRotations[joint]));
                    }
                }

                Assert.True(swing > 0.02f, $"seed {seed} {role}: {swing}");
                foreach (int joint in own.Joints)
                {
                    Assert.True(MovingPose.Between(creature.Skeleton.LocalRotations[joint], pose.LocalRotations[joint]) < 0.03, $"seed {seed} {role}");
                }
            }
        }

        Assert.True(chains > 40);
    }

    [Fact]
    public void A_damped_chain_sends_a_turn_down_as_a_wave_and_straightens_again()
    {
        int[] joints = { 1, 2, 3, 4, 5, 6 };
        var remembered = new Quaternion[joints.Length + 1];
        MovingPose pose = new(skeleton);
        DampedChain.Reset(joints, RootPlace.Identity, pose.Model, remembered);
        var turned = new RootPlace(Vector3.Zero, Rotation.FromAxisAngle(Vector3.UnitX, 0.8));
        int[] arrived = new int[joints.Length];
        for (int i = 1; i < 300; i++)
        {
            pose = new MovingPose(skeleton);
            DampedChain.Update(skeleton, joints, new ChainCurve(12f), 3f, turned, 1f / 60f, remembered, pose.Local, pose.Model);
            for (int k = 0; k < joints.Length; k++)
            {
                if (arrived[k] == 0 && MovingPose.Between(remembered[k], turned.Rotation) < 0.4)
                {
                    arrived[k] = i;
                }
            }
        }

        for (int k = 1; k < joints.Length; k++)
        {
            Assert.True(arrived[k] > arrived[k - 1]);
        }

        AssertClose(new MovingPose(skeleton), pose, 1e-4f);
        pose = new MovingPose(skeleton);
        DampedChain.Update(skeleton, joints, new ChainCurve(12f), 0.1f, RootPlace.Identity, 0f, remembered, pose.Local, pose.Model);
        Assert.All(pose.LocalRotations, q => Assert.True(Rotation.Angle(q) < 0.1001));
    }

    [Fact]
    public void A_damped_chain_moves_the_same_at_all_frame_rates()
    {
        float slow = Tip(30);
        float usual = Tip(60);
        float quick = Tip(144);
        float exact = Tip(2000);
        Assert.True(Math.Abs(exact) > 0.1f);
        Assert.True(Math.Abs(slow - exact) < 0.004f && Math.Abs(usual - exact) < 0.002f && Math.Abs(quick - exact) < 0.001f, FormattableString.Invariant($"{slow} {usual} {quick} {exact}"));

        // How far aside the tip is after a second of swaying.
        static float Tip(int rate)
        {
            int[] joints = { 1, 2, 3, 4, 5, 6 };
            var remembered = new Quaternion[joints.Length + 1];
            MovingPose pose = new(skeleton);
            DampedChain.Reset(joints, RootPlace.Identity, pose.Model, remembered);
            for (int i = 1; i <= rate; i++)
            {
                pose = new MovingPose(skeleton);
                var place = new RootPlace(Vector3.Zero, Rotation.FromAxisAngle(Vector3.UnitX, 0.6 * PortableMath.Sin(PortableMath.Tau * 1.3 * i / rate)));
                DampedChain.Update(skeleton, joints, new ChainCurve(12f), 3f, place, 1f / rate, remembered, pose.Local, pose.Model);
            }

            return pose.ModelPositions[7].Z;
        }
    }

    [Fact]
    public void A_ponytail_of_bones_along_any_axis_stays_where_it_is_animated_and_swings_like_one_along_Y()
    {
        // Joints of identity rotations whose bones point back and down, as other programs make them.
        var placements = new System.Collections.Generic.List<JointPlacement> { new("Head", -1, Quaternion.Identity, new Vector3(0f, 1.7f, 0f)) };
        for (int i = 0; i < 5; i++)
        {
            placements.Add(new JointPlacement(FormattableString.Invariant($"Hair{i}"), i, Quaternion.Identity, i == 0 ? new Vector3(0f, 0.1f, -0.1f) : new Vector3(0f, -0.04f, -0.03f)));
        }

        Skeleton hair = Skeleton.Build(placements);
        SpringRig swinging = new(hair, new[] { 1 });
        SpringState state = new(swinging);
        MovingPose pose = new(hair);
        for (int i = 0; i < 120; i++)
        {
            pose = new MovingPose(hair);
            SpringBones.Update(swinging, state, soft, RootPlace.Identity, default, 1f / 60f, pose.Local, pose.Model);
        }

        AssertClose(new MovingPose(hair), pose, 1e-5f);

        // Pushed aside, every bone keeps its length and leaves its place.
        for (int i = 0; i < 10; i++)
        {
            pose = new MovingPose(hair);
            SpringBones.Update(swinging, state, soft, new RootPlace(new Vector3(0.02f * i, 0f, 0f), Quaternion.Identity), default, 1f / 60f, pose.Local, pose.Model);
        }

        for (int i = 2; i < hair.Count; i++)
        {
            Assert.Equal(0.05f, Vec.Distance(pose.ModelPositions[i], pose.ModelPositions[i - 1]), 5);
        }

        Assert.True(pose.ModelPositions[5].X < -0.01f);
    }

    [Theory]
    [InlineData(0f)]
    [InlineData(3f)]
    public void Bones_without_stiffness_swing_for_ever_unless_air_slows_them(float drag)
    {
        // They stand up against gravity and fall to one side.
        SpringSettings limp = new(new ChainCurve(0f), new ChainCurve(0f), gravity: new Vector3(0f, -9.81f, 1f), maxSwing: 3.1f, drag: new ChainCurve(drag));
        SpringState state = new(rig);
        Vector3 before = default;
        float speed = 0f;
        for (int i = 0; i < 900; i++)
        {
            MovingPose pose = new(skeleton);
            SpringBones.Update(rig, state, limp, RootPlace.Identity, default, 1f / 60f, pose.Local, pose.Model);
            speed = i > 840 ? Math.Max(speed, Vec.Distance(before, pose.ModelPositions[7]) * 60f) : 0f;
            before = pose.ModelPositions[7];
        }

        Assert.Equal(drag > 0f, speed < 0.05f);
    }

    [Fact]
    public void Wind_bends_bones_its_own_way_and_the_faster_the_farther()
    {
        Assert.Equal(0f, Blown(0f), 4);
        Assert.InRange(Blown(3f), 0.02f, Blown(6f) - 0.01f);
        Assert.Equal(-Blown(3f), Blown(-3f), 4);

        static float Blown(float wind)
        {
            SpringSettings airy = new(new ChainCurve(3f, 1.5f), new ChainCurve(0.5f), drag: new ChainCurve(4f), wind: new Vector3(wind, 0f, 0f));
            SpringState state = new(rig);
            MovingPose pose = new(skeleton);
            for (int i = 0; i < 300; i++)
            {
                pose = new MovingPose(skeleton);
                SpringBones.Update(rig, state, airy, RootPlace.Identity, default, 1f / 60f, pose.Local, pose.Model);
            }

            return pose.ModelPositions[7].X;
        }
    }

    [Fact]
    public void Swinging_allocates_nothing_and_refuses_what_is_no_number()
    {
        SpringState state = new(rig);
        MovingPose pose = new(skeleton);
        SpringCollider[] colliders = { SpringCollider.Plane(Vector3.Zero, Vector3.UnitY) };
        Assert.Equal(0, MovingPose.Allocated(() => SpringBones.Update(rig, state, soft, RootPlace.Identity, colliders, 1f / 60f, pose.Local, pose.Model)));
        Assert.Throws<ArgumentOutOfRangeException>(() => SpringBones.Update(rig, state, soft, RootPlace.Identity, colliders, float.NaN, pose.Local, pose.Model));
        Assert.Throws<ArgumentException>(() => SpringBones.Update(rig, state, soft, default, colliders, 0.1f, pose.Local, pose.Model));
        Assert.Throws<ArgumentException>(() => SpringBones.Update(rig, new SpringState(new SpringRig(skeleton, new[] { 2 })), soft, RootPlace.Identity, colliders, 0.1f, pose.Local, pose.Model));
        Assert.Throws<ArgumentException>(() => new SpringRig(skeleton, new[] { 1, 3 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => new RootPlace(new Vector3(float.NaN), Quaternion.Identity));
        Assert.Throws<ArgumentException>(() => new RootPlace(Vector3.Zero, default));
        pose.ModelRotations[3].X = float.NaN;
        Assert.Contains("joint 3", Assert.Throws<ArgumentException>(() => SpringBones.Update(rig, state, soft, RootPlace.Identity, colliders, 0.1f, pose.Local, pose.Model)).Message);
    }

    /// <summary>Running to and fro with turns.</summary>
    private static RootPlace Running(float time) => new(
        new Vector3((float)PortableMath.Sin(2 * time), 0.2f * (float)PortableMath.Sin(5 * time), 1.5f * time),
        Rotation.FromAxisAngle(Vec.Normalize(new Vector3(0.2f, 1f, 0f)), PortableMath.Sin(3 * time)));

    private static MovingPose Step(SpringState state, in SpringSettings settings, in RootPlace root, float seconds)
    {
        MovingPose pose = new(skeleton);
        SpringBones.Update(rig, state, settings, root, ReadOnlySpan<SpringCollider>.Empty, seconds, pose.Local, pose.Model);
        return pose;
    }

    private static void AssertClose(MovingPose expected, MovingPose actual, float tolerance)
    {
        for (int i = 0; i < expected.ModelPositions.Length; i++)
        {
            Assert.True(Vec.Distance(expected.ModelPositions[i], actual.ModelPositions[i]) < tolerance, $"joint {i}: {expected.ModelPositions[i]} {actual.ModelPositions[i]}");
        }
    }
}
