using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>Jumps of what has wings besides legs.</summary>
public sealed class WingedJumpTests
{
    private const float Frame = 1f / 60f;

    /// <summary>Who flies was asked to jump on foot and did nothing; its clip of a jump stood still.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_flier_on_its_feet_jumps_with_open_wings_lands_where_it_was_asked_to_and_folds_them_again(bool runs)
    {
        int jumped = 0;
        foreach (MotionProfile profile in FreeFallTests.Lot(9971000, Thoroughness.Of(45), RequestedKind.Flying))
        {
            string name = $"{profile.Subject.Seed} {profile.Subject.Plan}";
            CreatureAnimator animator = OnFoot(profile, runs);
            JumpReach reach = animator.JumpReach;
            if (reach.Length == 0f || animator.State != BodyState.Supported)
            {
                continue;
            }

            Vector3 target = animator.Root.ToWorld(new Vector3(0f, 0f, 0.85f * reach.Length));
            Quaternion[] folded = Wings(OnFoot(profile, runs: false));
            Assert.True(animator.Jump(target) == JumpResult.Begun, name);
            var kinds = new List<MotionEventKind>();
            float opened = 0f;
            float fastest = 0f;
            Quaternion[] before = Wings(animator);
            for (int i = 0; i < 600 && !kinds.Contains(MotionEventKind.Landed); i++)
            {
                animator.Update(Frame, default, FlatGround.Level);
                kinds.AddRange(animator.Events.ToArray().Where(e => e.Foot < 0 && e.Kind != MotionEventKind.WingBeat).Select(e => e.Kind));
                Quaternion[] now = Wings(animator);
                opened = Math.Max(opened, Greatest(folded, now));
                fastest = Math.Max(fastest, Greatest(before, now) / Frame);
                before = now;
            }

            float miss = Vec.Distance(animator.Root.Position, target);
            Assert.Equal([MotionEventKind.Jumped, MotionEventKind.Landed], kinds);
            Assert.True(miss < 0.3f * profile.LegLength, $"{name}: {miss / profile.LegLength} legs from its target");
            Assert.True(opened > 0.4f, $"{name}: wings opened by {opened} rad");
            Assert.True(fastest < 60f, $"{name}: wings opened at {fastest} rad/s");
            for (int i = 0; i < 300; i++)
            {
                animator.Update(Frame, default, FlatGround.Level);
            }

            Assert.Equal(BodyState.Supported, animator.State);
            Assert.True(Greatest(folded, Wings(animator)) < 0.15f, $"{name}: wings stay open by {Greatest(folded, Wings(animator))} rad");
            jumped++;
        }

        Assert.True(jumped > 6, $"{jumped} jumped");
    }

    [Fact]
    public void A_flier_that_is_asked_into_the_air_as_it_jumps_goes_on_on_its_wings_at_the_speed_that_it_has()
    {
        int flew = 0;
        foreach (MotionProfile profile in FreeFallTests.Lot(9971000, Thoroughness.Of(45), RequestedKind.Flying))
        {
            string name = $"{profile.Subject.Seed} {profile.Subject.Plan}";
            CreatureAnimator animator = OnFoot(profile, runs: true);
            if (animator.Jump(animator.Root.ToWorld(new Vector3(0f, 0f, 0.9f * animator.JumpReach.Length))) != JumpResult.Begun)
            {
                continue;
            }

            var up = new MotionInput(animator.Speed, Medium: MotionMedium.Air);
            Vector3 way = default;
            float change = 0f;
            for (int i = 0; i < 240; i++)
            {
                Vector3 from = animator.Root.Position;
                animator.Update(Frame, up, FlatGround.Level);
                Vector3 now = (animator.Root.Position - from) / Frame;
                if (animator.State == BodyState.Falling || (animator.State == BodyState.Supported && change > 0f))
                {
                    // Gravity, and what the push of the legs adds in its last update.
                    change = Math.Max(change, Vec.Length(Vec.Reject(now - way, Vector3.UnitY)));
                }

                way = now;
            }

            Assert.Equal(BodyState.Supported, animator.State);
            Assert.False(animator.StandsOnFeet, name);
            Assert.True(animator.Root.Position.Y > 0.5f * profile.LegLength, $"{name}: {animator.Root.Position.Y} m high");
            Assert.True(change < 0.35f * MathF.Sqrt(9.81f * profile.LegLength), $"{name}: {change} m/s in an update");
            flew++;
        }

        Assert.True(flew > 6, $"{flew} flew");
    }

    [Fact]
    public void A_flier_that_jumps_off_a_cliff_takes_wing_and_lands_on_its_feet()
    {
        int flew = 0;
        foreach (MotionProfile profile in FreeFallTests.Lot(9971000, Thoroughness.Of(45), RequestedKind.Flying))
        {
            string name = $"{profile.Subject.Seed} {profile.Subject.Plan}";
            float leg = profile.LegLength;
            CreatureAnimator animator = new(profile);
            var cliff = new Cliff(0.4f * leg, 40f * leg);
            animator.Teleport(RootPlace.Identity, cliff);
            if (animator.Jump(new Vector3(0f, 0f, 0.9f * animator.JumpReach.Length)) != JumpResult.Begun)
            {
                continue;
            }

            bool limp = false;
            for (int i = 0; i < 60 * 40; i++)
            {
                animator.Update(Frame, default, cliff);
                limp |= animator.State == BodyState.Limp;
            }

            Assert.False(limp, name);
            Assert.True(animator.StandsOnFeet, name);
            Assert.True(animator.Root.Position.Y < -39f * leg, $"{name}: at {animator.Root.Position.Y / leg} legs");
            flew++;
        }

        Assert.True(flew > 6, $"{flew} flew");
    }

    private static CreatureAnimator OnFoot(MotionProfile profile, bool runs)
    {
        float speed = runs ? profile.Gaits!.Speeds[^1].Comfortable : 0f;
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        for (int i = 0; i < 180; i++)
        {
            animator.Update(Frame, new MotionInput(speed), FlatGround.Level);
        }

        return animator;
    }

    private static Quaternion[] Wings(CreatureAnimator animator) => animator.Profile.Subject.Skeleton.Joints
        .Select((joint, i) => (joint.Role, Rotation: animator.LocalPose.Rotations[i])).Where(wing => wing.Role == JointRole.Wing).Select(wing => wing.Rotation).ToArray();

    private static float Greatest(Quaternion[] from, Quaternion[] to) => from.Zip(to, (a, b) => (float)Rotation.Angle(Rotation.Multiply(Rotation.Inverse(a), b))).DefaultIfEmpty().Max();
}
