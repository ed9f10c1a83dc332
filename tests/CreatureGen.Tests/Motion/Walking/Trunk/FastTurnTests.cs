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

/// <summary>What is seen of a fast turn in four-footed runners.</summary>
public sealed class FastTurnTests
{
    private const float Step = 1f / 60f;

    /// <summary>A turn that grip allows at no run: it is as sharp as it can be.</summary>
    private const float Sharp = 2.5f;

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Unguligrade)]
    public void Runners_lean_into_a_fast_turn_bend_along_its_arc_look_ahead_and_swing_their_tails_out(BodyPlan plan)
    {
        Creature creature = Walkers.Of(plan, 1);
        var run = new Run(creature);
        run.For(3f, 0f);
        run.For(1.5f, Sharp);
        Seen left = run.Mean(1f, Sharp);
        run.For(3f, -Sharp);
        Seen right = run.Mean(1f, -Sharp);
        float balance = (float)Math.Atan(left.Turn * run.Speed / 9.81f);
        Assert.InRange((right.Lean - left.Lean) / 2f, 0.6f * balance, 0.8f * balance);
        Assert.True((left.Bend - right.Bend) / 2f > 0.9f * left.Turn * run.TrunkLength / run.Speed, FormattableString.Invariant($"bend {left.Bend} to {right.Bend}, arc {left.Turn * run.TrunkLength / run.Speed}"));
        Assert.True((left.Look - right.Look) / 2f > 0.2f * Math.Min(left.Turn, 1f), FormattableString.Invariant($"look {left.Look} to {right.Look}"));
        Assert.True(left.Tail < right.Tail, FormattableString.Invariant($"tail {left.Tail} to {right.Tail}"));
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Unguligrade)]
    public void The_head_is_ahead_of_the_turn(BodyPlan plan)
    {
        var run = new Run(Walkers.Of(plan, 1));
        run.For(3f, 0f);
        run.For(0.15f, Sharp);
        Seen seen = run.Mean(Step, Sharp);
        Assert.True(seen.Look > 0.15f * seen.Turn, FormattableString.Invariant($"{seen.Look} rad at {seen.Turn} rad/s"));
        Assert.True(seen.Look > 0.05f, FormattableString.Invariant($"{seen.Look} rad"));
    }

    /// <param name="Turn">Radians per second to the left.</param>
    /// <param name="Lean">Roll of the pelvis, left side up, radians.</param>
    /// <param name="Bend">Yaw of the chest from that of the pelvis, radians to the left.</param>
    /// <param name="Look">Yaw of the head, seen from the root, radians to the left.</param>
    /// <param name="Tail">How far to the left of the pelvis's middle plane the tail ends, metres.</param>
    private readonly record struct Seen(float Turn, float Lean, float Bend, float Look, float Tail)
    {
        public static Seen operator +(Seen a, Seen b) => new(a.Turn + b.Turn, a.Lean + b.Lean, a.Bend + b.Bend, a.Look + b.Look, a.Tail + b.Tail);

        public static Seen operator /(Seen a, float by) => new(a.Turn / by, a.Lean / by, a.Bend / by, a.Look / by, a.Tail / by);
    }

    private sealed class Run
    {
        private readonly CreatureAnimator animator;
        private readonly Skeleton skeleton;
        private readonly float asked;

        public Run(Creature creature)
        {
            var profile = new MotionProfile(creature);
            skeleton = creature.Skeleton;
            asked = profile.Gaits!.Speeds[^1].Comfortable;
            animator = new CreatureAnimator(profile);
            animator.Teleport(animator.Root, FlatGround.Level);
        }

        public float Speed => animator.Speed;

        public float TrunkLength => Vec.Distance(skeleton.ModelPositions[skeleton.FirstOf(JointRole.Pelvis)], skeleton.ModelPositions[skeleton.FirstOf(JointRole.Chest)]);

        public void For(float seconds, float turn) => Walkers.Run(animator, seconds, 1f / Step, new MotionInput(asked, turn), FlatGround.Level);

        public Seen Mean(float seconds, float turn)
        {
            int count = (int)Math.Round(seconds / Step);
            return Enumerable.Range(0, count).Select(_ => Look(turn)).Aggregate((a, b) => a + b) / count;
        }

        private Seen Look(float turn)
        {
            Quaternion before = animator.Root.Rotation;
            For(Step, turn);
            Quaternion pelvis = TurnOf(skeleton.FirstOf(JointRole.Pelvis));
            Vector3 up = Rotation.Rotate(pelvis, Vector3.UnitX);
            int tip = Array.FindLastIndex(skeleton.Joints.ToArray(), joint => joint.Role == JointRole.Tail);
            Vector3 tail = animator.ModelPose.Positions[tip] - animator.ModelPose.Positions[skeleton.FirstOf(JointRole.Pelvis)];
            return new Seen(
                Yaw(Rotation.Multiply(Rotation.Inverse(before), animator.Root.Rotation)) / Step,
                (float)Math.Asin(up.Y),
                Yaw(TurnOf(skeleton.FirstOf(JointRole.Chest))) - Yaw(pelvis),
                Yaw(TurnOf(skeleton.FirstOf(JointRole.Head))),
                Rotation.Rotate(Rotation.Inverse(pelvis), tail).X);
        }

        private Quaternion TurnOf(int joint) => Rotation.Multiply(animator.ModelPose.Rotations[joint], Rotation.Inverse(skeleton.ModelRotations[joint]));

        private static float Yaw(Quaternion turn)
        {
            Vector3 ahead = Rotation.Rotate(turn, Vector3.UnitZ);
            return (float)Math.Atan2(ahead.X, ahead.Z);
        }
    }
}
