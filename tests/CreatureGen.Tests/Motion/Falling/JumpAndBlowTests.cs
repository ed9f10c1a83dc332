using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>Jumps to a point, and blows.</summary>
public sealed class JumpAndBlowTests
{
    private const float Frame = 1f / 60f;

    [Fact]
    public void Jumps_within_reach_land_where_they_were_asked_to_and_others_are_refused_with_the_reason()
    {
        int jumped = 0;
        foreach (MotionProfile profile in FreeFallTests.Lot(680, 10))
        {
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            JumpReach reach = animator.JumpReach;
            if (reach.Length == 0f)
            {
                Assert.Equal(JumpResult.TooHeavy, animator.Jump(Vector3.UnitZ));
                continue;
            }

            Assert.Equal(JumpResult.OutOfReach, animator.Jump(new Vector3(0f, 0f, 1.1f * reach.Length)));
            Assert.Equal(JumpResult.OutOfReach, animator.Jump(new Vector3(0f, 1.1f * reach.Height, 0f)));
            var target = new Vector3(0.2f * reach.Length, 0f, 0.8f * reach.Length);
            Assert.Equal(JumpResult.Begun, animator.Jump(target));
            Assert.Equal(JumpResult.NotOnFeet, animator.Jump(target));
            var kinds = new List<MotionEventKind>();
            for (int i = 0; i < 600 && !kinds.Contains(MotionEventKind.Landed); i++)
            {
                animator.Update(Frame, default, FlatGround.Level);
                kinds.AddRange(animator.Events.ToArray().Where(e => e.Foot < 0).Select(e => e.Kind));
            }

            float miss = Vec.Distance(animator.Root.Position, target);
            Assert.Equal([MotionEventKind.Jumped, MotionEventKind.Landed], kinds);
            Assert.True(miss < 0.3f * profile.LegLength, $"{profile.Subject.Seed} {profile.Subject.Plan}: {miss / profile.LegLength} legs from its target");
            jumped++;
        }

        Assert.True(jumped > 3, $"{jumped} jumped");
    }

    /// <summary>Who crouched at full speed ran past its target, turned round in the air and jumped back to it.</summary>
    [Fact]
    public void Jumps_out_of_a_run_land_ahead_where_they_were_asked_to()
    {
        int jumped = 0;
        foreach (MotionProfile profile in FreeFallTests.Lot(9970001, 12))
        {
            CreatureAnimator animator = AtFullSpeed(profile);
            JumpReach reach = animator.JumpReach;
            if (reach.Length == 0f || animator.State != BodyState.Supported)
            {
                continue;
            }

            Vector3 target = animator.Root.ToWorld(new Vector3(0f, 0f, 0.8f * reach.Length));
            Vector3 heading = Rotation.Rotate(animator.Root.Rotation, Vector3.UnitZ);
            Assert.Equal(JumpResult.Begun, animator.Jump(target));
            Assert.Equal(JumpResult.OutOfReach, new CreatureAnimator(profile).Jump(target));
            bool landed = false;
            for (int i = 0; i < 600 && !landed; i++)
            {
                Vector3 before = animator.Root.Position;
                animator.Update(Frame, default, FlatGround.Level);
                landed = animator.Events.ToArray().Any(e => e.Kind == MotionEventKind.Landed);
                Assert.True(Vec.Dot(animator.Root.Position - before, heading) > -1e-3f * profile.LegLength, $"{profile.Subject.Seed} goes back");
            }

            float miss = Vec.Distance(animator.Root.Position, target);
            Assert.True(landed && miss < 0.3f * profile.LegLength, $"{profile.Subject.Seed} {profile.Subject.Plan}: {miss / profile.LegLength} legs from its target");
            jumped++;
        }

        Assert.True(jumped > 6, $"{jumped} jumped");
    }

    /// <summary>Who braked to the speed of its flight did not come down to it in time: it stopped in the air, or flew back to its target.</summary>
    [Theory]
    [InlineData(0.7f)]
    [InlineData(0.85f)]
    [InlineData(0.98f)]
    public void A_jump_out_of_a_run_flies_on_at_the_speed_of_the_run(float part)
    {
        int jumped = 0;
        foreach (MotionProfile profile in FreeFallTests.Lot(9970001, Thoroughness.Of(24)))
        {
            CreatureAnimator animator = AtFullSpeed(profile);
            float length = animator.JumpReach.Length;
            float before = animator.Speed;
            if (length == 0f || animator.State != BodyState.Supported || before < 0.3f * MathF.Sqrt(9.81f * profile.LegLength))
            {
                continue;
            }

            Vector3 heading = Rotation.Rotate(animator.Root.Rotation, Vector3.UnitZ);
            Assert.Equal(JumpResult.Begun, animator.Jump(animator.Root.ToWorld(new Vector3(0f, 0f, part * length))));
            bool landed = false;
            for (int i = 0; i < 600 && !landed; i++)
            {
                Vector3 from = animator.Root.Position;
                animator.Update(Frame, default, FlatGround.Level);
                float speed = Vec.Dot(animator.Root.Position - from, heading) / Frame;
                Assert.True(Math.Abs(speed - before) < 0.12f * MathF.Sqrt(9.81f * profile.LegLength), $"{profile.Subject.Seed}: from {before} to {speed} m/s in an update");
                before = speed;
                landed = animator.Events.ToArray().Any(e => e.Kind == MotionEventKind.Landed);
            }

            Assert.True(landed);
            jumped++;
        }

        Assert.True(jumped > 3, $"{jumped} jumped");
    }

    [Fact]
    public void What_a_run_carries_past_is_out_of_reach()
    {
        int refused = 0;
        foreach (MotionProfile profile in FreeFallTests.Lot(9970001, 6))
        {
            CreatureAnimator animator = AtFullSpeed(profile);
            if (animator.JumpReach.Length > 0f)
            {
                Assert.Equal(JumpResult.OutOfReach, animator.Jump(animator.Root.ToWorld(new Vector3(0f, 0f, 0.15f * animator.JumpReach.Length))));
                refused++;
            }
        }

        Assert.True(refused > 2, $"{refused} could have jumped");
    }

    [Fact(Explicit = true)]
    public void A_light_blow_is_stepped_after_and_a_heavy_one_knocks_down_who_then_gets_up_by_itself()
    {
        foreach (MotionProfile profile in FreeFallTests.Lot(690, 4))
        {
            float unit = profile.Subject.Mass.Mass * MathF.Sqrt(9.81f * profile.LegLength);
            int head = profile.Subject.Skeleton.IndexOf("Head");
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            animator.Update(Frame, default, FlatGround.Level);
            animator.Hit(Math.Max(head, 1), new Vector3(0.3f * unit, 0f, 0f));
            animator.Update(Frame, default, FlatGround.Level);
            Assert.Contains(animator.Events.ToArray(), e => e.Kind == MotionEventKind.Struck);
            Run(animator, 180);
            Assert.Equal(BodyState.Supported, animator.State);
            Assert.True(animator.Root.Position.X > 0.01f * profile.LegLength, $"{profile.Subject.Seed}: pushed by {animator.Root.Position.X} m");
            animator.Hit(Math.Max(head, 1), new Vector3(unit, 0f, 0f));
            Run(animator, 2);
            Assert.Equal(BodyState.Limp, animator.State);
            Run(animator, 3000);
            Assert.Equal(BodyState.Supported, animator.State);
        }
    }

    [Fact]
    public void A_blow_tips_the_trunk_over_with_the_push_and_it_rights_itself_over_its_feet()
    {
        foreach (MotionProfile profile in FreeFallTests.Lot(690, 4))
        {
            float unit = profile.Subject.Mass.Mass * MathF.Sqrt(9.81f * profile.LegLength);
            Skeleton skeleton = profile.Subject.Skeleton;
            int chest = skeleton.FirstOf(JointRole.Chest);
            var animator = new CreatureAnimator(profile);
            animator.Settings = animator.Settings with { Idle = 0f };
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            float stood = Lean();
            animator.Hit(chest, new Vector3(0.4f * unit, 0f, 0f));
            float most = 0f;
            for (int i = 0; i < 60; i++)
            {
                animator.Update(Frame, default, FlatGround.Level);
                most = Math.Max(most, Lean() - stood);
            }

            Run(animator, 600);
            Assert.InRange(most, 0.05f, 0.5f);
            Assert.InRange(Lean() - stood, -0.02f, 0.02f);

            // To the left.
            float Lean() => Vector3.Transform(Vector3.UnitY, animator.ModelPose.Rotations[chest] * Quaternion.Inverse(skeleton.ModelRotations[chest])).X;
        }
    }

    /// <summary>Looking about held the head where it was, and a blow from the side was hardly to be seen on it (.09 to .4 rad); then each joint of a long neck gave as much as a single one, and the head looked backwards (1.9 rad).</summary>
    [Fact]
    public void A_blow_to_the_head_from_the_side_throws_it_aside_while_it_looks_about()
    {
        foreach (MotionProfile profile in FreeFallTests.Lot(690, 16))
        {
            int head = profile.Subject.Skeleton.FirstOf(JointRole.Head);
            float unit = profile.Subject.Mass.Mass * MathF.Sqrt(9.81f * profile.LegLength);
            var struck = new CreatureAnimator(profile);
            var spared = new CreatureAnimator(profile);
            Run(struck, 30);
            Run(spared, 30);
            struck.Hit(head, new Vector3(-0.4f * unit, 0f, 0f));
            double most = 0;
            for (int i = 0; i < 60; i++)
            {
                Run(struck, 1);
                Run(spared, 1);
                most = Math.Max(most, Rotation.Angle(Rotation.Multiply(Rotation.Inverse(spared.ModelPose.Rotations[head]), struck.ModelPose.Rotations[head])));
            }

            Assert.True(most is > 0.45 and < 1.4, $"{profile.Subject.Seed}: {most} rad");
        }
    }

    [Fact]
    public void Who_is_struck_shuts_its_eyes_for_a_moment()
    {
        MotionProfile profile = FreeFallTests.Lot(690, 8).First(one => one.Subject.Skeleton.FirstOf(JointRole.Lid) >= 0);
        int lid = profile.Subject.Skeleton.FirstOf(JointRole.Lid);
        var struck = new CreatureAnimator(profile);
        var spared = new CreatureAnimator(profile);
        float unit = profile.Subject.Mass.Mass * MathF.Sqrt(9.81f * profile.LegLength);
        struck.Hit(profile.Subject.Skeleton.FirstOf(JointRole.Chest), new Vector3(0.1f * unit, 0f, 0f));
        Assert.True(After(0.25f) > 0.2f);
        Assert.InRange(After(1f), 0f, 1e-3f);

        float After(float seconds)
        {
            Run(struck, (int)(seconds / Frame));
            Run(spared, (int)(seconds / Frame));
            return (float)Rotation.Angle(Rotation.Multiply(Rotation.Inverse(spared.LocalPose.Rotations[lid]), struck.LocalPose.Rotations[lid]));
        }
    }

    [Fact]
    public void Blows_and_targets_that_are_no_numbers_and_unknown_joints_are_refused()
    {
        MotionProfile profile = FreeFallTests.Lot(690, 4).First();
        var animator = new CreatureAnimator(profile);
        Assert.Contains("impulse", Assert.ThrowsAny<ArgumentException>(() => animator.Hit(1, new Vector3(float.NaN, 0f, 0f))).Message, StringComparison.Ordinal);
        Assert.Contains("joint", Assert.ThrowsAny<ArgumentException>(() => animator.Hit(-1, Vector3.UnitX)).Message, StringComparison.Ordinal);
        Assert.Contains("joint", Assert.ThrowsAny<ArgumentException>(() => animator.Hit(profile.Subject.Skeleton.Count, Vector3.UnitX)).Message, StringComparison.Ordinal);
        Assert.Contains("target", Assert.ThrowsAny<ArgumentException>(() => animator.Jump(new Vector3(0f, float.PositiveInfinity, 0f))).Message, StringComparison.Ordinal);
    }

    private static CreatureAnimator AtFullSpeed(MotionProfile profile)
    {
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        float fastest = profile.Gaits!.Speeds[^1].Comfortable;
        for (int i = 0; i < 180; i++)
        {
            animator.Update(Frame, new MotionInput(fastest), FlatGround.Level);
        }

        return animator;
    }

    private static void Run(CreatureAnimator animator, int frames)
    {
        for (int i = 0; i < frames; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
        }
    }

    /// <summary>The whole turn was made at one rate until the feet were on the ground: the sprawler 10620052 came down turning at 8.5 rad/s, and a hip went at 172 rad/s as its feet passed below it.</summary>
    [Fact]
    public void Who_turns_in_a_jump_faces_its_target_and_comes_down_without_turning()
    {
        const float MaxTurn = 0.5f;
        const float MinFacing = 0.95f;
        int jumped = 0;
        foreach (MotionProfile profile in FreeFallTests.Lot(680, 10))
        {
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            float length = animator.JumpReach.Length;
            var target = new Vector3(0.5f * length, 0f, 0f);
            if (length == 0f || animator.Jump(target) != JumpResult.Begun)
            {
                continue;
            }

            bool landed = false;
            for (int i = 0; i < 600 && !landed; i++)
            {
                animator.Update(Frame, default, FlatGround.Level);
                landed = animator.Events.ToArray().Any(e => e.Kind == MotionEventKind.Landed);
            }

            string name = $"{profile.Subject.Seed} {profile.Subject.Plan}";
            Assert.True(landed, name);
            Quaternion before = animator.Root.Rotation;
            Vector3 ahead = Rotation.Rotate(before, Vector3.UnitZ);
            animator.Update(Frame, default, FlatGround.Level);
            float turn = 2f * MathF.Abs(Rotation.Multiply(Rotation.Inverse(before), animator.Root.Rotation).Y) / Frame;
            Assert.True(turn < MaxTurn, $"{name} turns at {turn} rad/s as it is down");
            Assert.True(ahead.X > MinFacing, $"{name} faces {ahead}");
            jumped++;
        }

        Assert.True(jumped > 3, $"{jumped} jumped");
    }
}
