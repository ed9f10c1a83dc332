using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Clips;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Gaze;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Idle;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

public sealed class StandingLifeTests
{
    [Theory]
    [InlineData(0.001)]
    [InlineData(1)]
    [InlineData(70)]
    [InlineData(5000)]
    public void Big_creatures_are_slower_at_rest_and_all_breathe_in_whole_numbers(float mass)
    {
        IdleRhythm small = IdleRhythm.Of(mass);
        IdleRhythm big = IdleRhythm.Of(10 * mass);
        Assert.True(big.Period > small.Period);
        Assert.True(big.Breaths / big.Period <= small.Breaths / small.Period);
        Assert.True(small.Breaths >= 1 && small.TailSwings >= 1);
    }

    [Theory]
    [InlineData(5000)]
    [InlineData(5006)]
    [InlineData(5019)]
    [InlineData(5022)]
    public void What_a_standing_body_does_begins_anew_after_a_period_and_has_no_gaps(int seed)
    {
        LeggedBody body = new MotionProfile(Walkers.Any((ulong)seed)).Legs!;
        double period = body.Idle.Period;
        IdlePose before = IdleLife.At(body, 0, 0f, 1f);
        for (int i = 1; i <= 2000; i++)
        {
            IdlePose now = IdleLife.At(body, period * i / 1000, 0f, 1f);
            IdlePose earlier = IdleLife.At(body, period * (i + 3000) / 1000, 0f, 1f);
            Assert.Equal(now.Shift, earlier.Shift, 5);
            Assert.Equal(now.Breath, earlier.Breath, 5);
            Assert.Equal(now.TailSway, earlier.TailSway, 4);
            Assert.True(Math.Abs(now.Shift - before.Shift) < 0.02f * body.HalfTrack);
            Assert.True(Math.Abs(now.TailSway - before.TailSway) < 0.02f);
            before = now;
        }

        Assert.Equal(default, IdleLife.At(body, 0.3 * period, 0f, 0f));
    }

    [Theory]
    [InlineData(5000)]
    [InlineData(5006)]
    [InlineData(5011)]
    [InlineData(5019)]
    [InlineData(5022)]
    public void The_clip_of_standing_looks_about_shifts_its_weight_and_flicks_its_ears(int seed)
    {
        Creature creature = Walkers.Any((ulong)seed);
        Clip clip = ClipBaker.Bake(creature).Single(clip => clip.Name == "Idle");
        var profile = new MotionProfile(creature);
        Assert.Equal(profile.Legs!.Idle.Period, clip.Frames > 1 ? (clip.Frames - 1) / (double)clip.Rate : 0, 1);
        Assert.True(clip.RotationsAt(0).SequenceEqual(clip.RotationsAt(clip.Frames - 1)));
        Skeleton skeleton = creature.Skeleton;
        int head = Enumerable.Range(0, skeleton.Count).First(i => skeleton.Joints[i].Role == JointRole.Head);
        int pelvis = skeleton.IndexOf("Pelvis");
        var pose = new MovingPose(skeleton);
        float leftmost = 0f;
        float rightmost = 0f;
        float aside = 0f;
        float otherSide = 0f;
        float ears = 0f;
        for (int frame = 0; frame < clip.Frames; frame++)
        {
            clip.RotationsAt(frame).CopyTo(pose.LocalRotations);
            clip.PositionsAt(frame).CopyTo(pose.LocalPositions);
            pose.Chained();
            Vector3 ahead = Vector3.Transform(Vector3.UnitZ, pose.ModelRotations[head] * Quaternion.Inverse(skeleton.ModelRotations[head]));
            float yaw = MathF.Atan2(ahead.X, ahead.Z);
            leftmost = Math.Max(leftmost, yaw);
            rightmost = Math.Min(rightmost, yaw);
            aside = Math.Max(aside, pose.ModelPositions[pelvis].X);
            otherSide = Math.Min(otherSide, pose.ModelPositions[pelvis].X);
            for (int i = 0; i < skeleton.Count; i++)
            {
                if (skeleton.Joints[i].Role == JointRole.Ear)
                {
                    ears = Math.Max(ears, 2f * MathF.Acos(Math.Min(1f, Math.Abs(Quaternion.Dot(skeleton.LocalRotations[i], pose.LocalRotations[i])))));
                }
            }
        }

        Assert.True(leftmost > 0.2f, $"{leftmost} rad to the left");
        Assert.True(rightmost < -0.15f, $"{rightmost} rad to the right");
        Assert.True(aside - otherSide > 0.2f * profile.Legs.HalfTrack, $"{(aside - otherSide) / profile.Legs.HalfTrack} of half the track");
        Assert.True(ears > 0.2f || skeleton.Joints.All(joint => joint.Role != JointRole.Ear), $"{ears} rad of the ears");
    }

    [Fact]
    public void Ears_flick_one_at_a_time_each_now_and_then_and_rest_most_of_the_time()
    {
        Seed seed = new Seed(7).Child("ears");
        int left = 0;
        int right = 0;
        const int All = 100_000;
        (float Left, float Right) before = default;
        for (int i = 0; i < All; i++)
        {
            (float Left, float Right) now = EarFlicks.At(seed, i * 0.01, 3f);
            Assert.InRange(now.Left, 0f, 1f);
            Assert.InRange(now.Right, 0f, 1f);
            Assert.True(now.Left == 0f || now.Right == 0f);
            Assert.True(Math.Abs(now.Left - before.Left) + Math.Abs(now.Right - before.Right) < 0.2f);
            left += now.Left > 0f ? 1 : 0;
            right += now.Right > 0f ? 1 : 0;
            before = now;
        }

        Assert.InRange(left + right, 0.08 * All, 0.2 * All);
        Assert.InRange(left, 0.3 * (left + right), 0.7 * (left + right));
    }

    [Theory]
    [InlineData(RequestedKind.Walking, 6014)]
    [InlineData(RequestedKind.Walking, 6033)]
    [InlineData(RequestedKind.Flying, 6044)]
    [InlineData(RequestedKind.Flying, 6052)]
    public void Feet_of_who_shifts_its_weight_stay_where_they_stand(RequestedKind kind, ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }));
        var animator = new CreatureAnimator(profile);
        animator.Teleport(animator.Root, FlatGround.Level);
        int[] balls = profile.Legs!.Legs.Select(leg => leg.Ball).ToArray();
        Vector3[] stood = Array.ConvertAll(balls, ball => animator.ModelPose.Positions[ball]);
        float most = 0f;
        for (int i = 0; i < 60 * profile.Legs.Idle.Period; i++)
        {
            animator.Update(1f / 60f, default, FlatGround.Level);
            most = Math.Max(most, balls.Select((ball, k) => (animator.ModelPose.Positions[ball] - stood[k]).Length()).Max() / profile.LegLength);
        }

        Assert.InRange(most, 0f, 0.008f);
    }

    [Theory]
    [InlineData(BodyPlan.Unguligrade, 3, 0.4f)]
    [InlineData(BodyPlan.Unguligrade, 8, 0.4f)]
    [InlineData(BodyPlan.Digitigrade, 5, 0.2f)]
    public void The_hind_foot_that_the_weight_has_left_rests_on_its_tip_and_stands_flat_before_the_weight_comes_back(BodyPlan plan, ulong seed, float least)
    {
        Creature creature = Walkers.Of(plan, seed);
        var animator = new CreatureAnimator(creature);
        animator.Teleport(animator.Root, FlatGround.Level);
        LeggedBody body = animator.Profile.Legs!;
        int rests = Array.FindIndex(body.Legs, leg => leg.Row == 0 && leg.Side == Side.Right);
        int foot = body.Legs[rests].Ball;
        int pelvis = creature.Skeleton.FirstOf(JointRole.Pelvis);
        Vector3 tip = Enumerable.Range(0, creature.Mesh.Positions.Length).Where(v => creature.Mesh.Weights[v].Joint0 == foot).Select(v => creature.Mesh.Positions[v]).MaxBy(p => p.Z - p.Y);
        Vector3 inFoot = Vector3.Transform(tip - creature.Skeleton.ModelPositions[foot], Quaternion.Inverse(creature.Skeleton.ModelRotations[foot]));
        Quaternion flat = animator.ModelPose.Rotations[foot];
        Vector3 stood = Tip();
        float middle = creature.Skeleton.ModelPositions[pelvis].X;
        float most = 0f;
        float carrying = 0f;
        for (int i = 0; i < 60 * body.Idle.Period; i++)
        {
            animator.Update(1f / 60f, default, FlatGround.Level);
            float pitch = 2f * MathF.Acos(Math.Min(1f, Math.Abs(Quaternion.Dot(flat, animator.ModelPose.Rotations[foot]))));
            most = Math.Max(most, pitch);
            carrying = animator.ModelPose.Positions[pelvis].X < middle ? Math.Max(carrying, pitch) : carrying;
            Assert.True(Vector3.Distance(stood, Tip()) < 0.03f * body.LegLength, $"{Vector3.Distance(stood, Tip()) / body.LegLength} legs from where its tip stood");
        }

        Assert.True(most > least, $"{most} rad");
        Assert.True(carrying < 0.1f, $"{carrying} rad under the weight");

        Vector3 Tip() => animator.ModelPose.Positions[foot] + Vector3.Transform(inFoot, animator.ModelPose.Rotations[foot]);
    }

    [Fact]
    public void The_recorded_look_ends_as_it_begins()
    {
        Assert.Equal(default, StandingScript.LookAt(0));
        Assert.Equal(default, StandingScript.LookAt(0.7));
        Assert.Equal(default, StandingScript.LookAt(1));
        Assert.Equal(default, StandingScript.ActAt(0, 6));
        Assert.Equal(default, StandingScript.ActAt(6, 6));
        Assert.True(StandingScript.LookAt(0.3).Yaw > 0.3f && StandingScript.LookAt(0.5).Yaw < -0.3f);
    }
}
