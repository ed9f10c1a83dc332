using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;
using static CreatureGen.Tests.Motion.Falling.GettingUpTests;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>What comes at once, another wish, a blow, the end of an act, does not show at once. Seen at 480 Hz, where a jump from one pose to the next is as fast as it is wide.</summary>
public sealed class SuddenChangeTests
{
    private const float Frame = 1f / 480f;

    /// <summary>Fastest joint of what a gait does not ask for, rad/s.</summary>
    private const double FastestJoint = 60;

    /// <summary>Necks turned up to 0.3 rad in one update, each joint a little, as the body would turn to the other side in a moment.</summary>
    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    public void A_head_goes_over_to_another_turn_in_a_while(RequestedKind kind)
    {
        const double FastestHead = 12;
        int looked = 0;
        for (ulong seed = 10740000; seed < 10740000 + (ulong)Thoroughness.Of(6); seed++)
        {
            Creature creature = Of(kind, seed);
            int head = creature.Skeleton.FirstOf(JointRole.Head);
            var animator = new CreatureAnimator(creature);
            Quaternion before = Quaternion.Identity;
            for (int i = 0; i < 1920; i++)
            {
                float yaw = (i / 480) switch { 0 => 0f, 1 => 1.6f, 2 => -1.6f, _ => 0.4f };
                animator.Update(Frame, new MotionInput(0.4f * creature.DefaultSpeed, yaw), FlatGround.Level);
                Quaternion now = animator.ModelPose.Rotations[head];
                double speed = i == 0 ? 0 : Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before), now)) / Frame;
                Assert.True(speed < FastestHead, $"{kind} {seed}: its head turns by {speed} rad/s at {i * Frame} s");
                before = now;
            }

            looked += head >= 0 ? 1 : 0;
        }

        Assert.Equal(Thoroughness.Of(6), looked);
    }

    /// <summary>The body sat back as far as it does in the hardest braking in the update after the blow: knees bent by up to 0.24 rad in it.</summary>
    [Theory]
    [InlineData(10740000UL)]
    [InlineData(10740002UL)]
    [InlineData(10740008UL)]
    [InlineData(10740010UL)]
    public void A_blow_that_is_withstood_moves_no_leg_at_once(ulong seed)
    {
        Creature creature = Of(RequestedKind.Walking, seed);
        int body = creature.Skeleton.FirstOf(JointRole.Body);
        foreach (Vector3 way in new[] { Vector3.UnitZ, -Vector3.UnitZ, Vector3.UnitX })
        {
            var watched = new Watched(creature);
            watched.Go(480, default);
            watched.Animator.Hit(body, way * (0.4f * creature.Mass.Mass * MathF.Sqrt(9.81f * watched.Animator.Profile.LegLength)));
            watched.Go(24, default);
            Assert.Equal(BodyState.Supported, watched.Animator.State);
            Assert.True(watched.Fastest < FastestJoint, $"{watched.Joint} turns by {watched.Fastest} rad/s");
        }
    }

    /// <summary>Legs took the stride of the new speed in one update, by up to 0.4 rad.</summary>
    [Theory]
    [InlineData(10740009UL)]
    [InlineData(10740003UL)]
    [InlineData(10740008UL)]
    public void A_blow_in_the_midst_of_a_jump_moves_no_leg_at_once(ulong seed)
    {
        Creature creature = Of(RequestedKind.Walking, seed);
        int body = creature.Skeleton.FirstOf(JointRole.Body);
        var watched = new Watched(creature);
        CreatureAnimator animator = watched.Animator;
        watched.Go(240, default);
        Assert.Equal(JumpResult.Begun, animator.Jump(new Vector3(0f, 0f, 0.4f * animator.JumpReach.Length)));
        for (int i = 0; i < 960 && animator.State != BodyState.Falling; i++)
        {
            watched.Go(1, default);
        }

        watched.Go(24, default);
        watched.Forget();
        animator.Hit(body, Vector3.UnitZ * (0.5f * creature.Mass.Mass * MathF.Sqrt(9.81f * animator.Profile.LegLength)));
        watched.Go(2, default);
        Assert.Equal(BodyState.Falling, animator.State);
        Assert.True(watched.Fastest < FastestJoint, $"{watched.Joint} turns by {watched.Fastest} rad/s");
    }

    /// <summary>The way from the rest pose to that in which it stands was taken for a velocity, and threw it up to 86 m away.</summary>
    [Theory]
    [InlineData(RequestedKind.Walking, 10740005UL)]
    [InlineData(RequestedKind.Walking, 10740007UL)]
    [InlineData(RequestedKind.Flying, 10740005UL)]
    [InlineData(RequestedKind.Flying, 10740007UL)]
    public void Who_goes_limp_before_it_has_moved_falls_where_it_is(RequestedKind kind, ulong seed)
    {
        Creature creature = Of(kind, seed);
        var animator = new CreatureAnimator(creature);
        animator.GoLimp();
        animator.Update(Frame, default, FlatGround.Level);
        Vector3 before = Middle(animator);
        for (int i = 0; i < 48; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
        }

        float way = (Middle(animator) - before).Length();
        Assert.True(way < 0.1f * Extent(creature), $"{way / Extent(creature)} of its extent in a tenth of a second");
    }

    /// <summary>Who lay dead was first put on its feet and then, that taken for a velocity, thrown.</summary>
    [Theory]
    [InlineData("Die", 10740011UL)]
    [InlineData("Sleep", 10740011UL)]
    [InlineData("Die", 10740000UL)]
    [InlineData("Lie", 10740002UL)]
    public void Who_goes_limp_as_an_act_has_laid_it_down_stays_where_it_lies(string act, ulong seed)
    {
        Creature creature = Of(RequestedKind.Walking, seed);
        var animator = new CreatureAnimator(creature);
        Assert.Equal(ActStatus.Started, animator.Perform(act).Status);
        for (int i = 0; i < 4 * 480; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
        }

        Vector3 before = Middle(animator);
        animator.GoLimp();
        for (int i = 0; i < 48; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
        }

        float way = (Middle(animator) - before).Length();
        Assert.True(way < 0.05f * Extent(creature), $"{way / Extent(creature)} of its extent in a tenth of a second");
    }

    /// <summary>As soon as the ground was in reach of a ray the root was on it, two metres farther down, and a camera with it.</summary>
    [Theory]
    [InlineData(10740004UL)]
    [InlineData(10620013UL)]
    public void The_root_of_who_falls_limp_from_the_sky_comes_to_the_ground_with_its_body(ulong seed)
    {
        Creature creature = Of(RequestedKind.Flying, seed);
        float size = Extent(creature);
        var animator = new CreatureAnimator(creature);
        animator.Teleport(new RootPlace(new Vector3(0f, 12f * size, 0f), Quaternion.Identity), FlatGround.Level);
        for (int i = 0; i < 48; i++)
        {
            animator.Update(Frame, new MotionInput(0.5f, Medium: MotionMedium.Air), FlatGround.Level);
        }

        animator.GoLimp();
        Vector3 before = animator.Root.Position;
        Vector3 middle = Middle(animator);
        float highest = 0f;
        for (int i = 0; i < 2400 && animator.Root.Position.Y > 0.01f * size; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
            float way = (animator.Root.Position - before).Length();
            float fallen = (Middle(animator) - middle).Length();
            Assert.True(way < (3f * fallen) + (0.01f * size), $"its root goes {way / size} of its size in an update, its body {fallen / size}, {before.Y / size} above the ground");
            before = animator.Root.Position;
            middle = Middle(animator);
            highest = MathF.Max(highest, before.Y);
        }

        Assert.True(highest > 8f * size);
        Assert.InRange(animator.Root.Position.Y, -0.1f * size, 0.1f * size);
    }

    /// <summary>It reached for where it would have drunk as it was asked to, which lay under its chest once it had come to a stand: its head went over its back and down again at 720 m/s.</summary>
    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    public void Who_is_to_drink_as_it_runs_drinks_ahead_of_where_it_has_come_to_a_stand(RequestedKind kind)
    {
        const double FastestNeck = 30;
        Creature creature = Of(kind, 10744002);
        int[] neck = [.. Enumerable.Range(0, creature.Skeleton.Count).Where(j => creature.Skeleton.Joints[j].Role is JointRole.Neck or JointRole.Head)];
        int head = creature.Skeleton.FirstOf(JointRole.Head);
        var animator = new CreatureAnimator(creature);
        for (int i = 0; i < 528; i++)
        {
            animator.Update(Frame, new MotionInput(1.52f, -1.07f), FlatGround.Level);
        }

        Assert.Equal(ActStatus.Started, animator.Perform("Drink").Status);
        Quaternion[] before = animator.LocalPose.Rotations.ToArray();
        float ahead = 0f;
        for (int i = 0; i < 1920; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
            foreach (int j in neck)
            {
                double speed = Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before[j]), animator.LocalPose.Rotations[j])) / Frame;
                Assert.True(speed < FastestNeck, $"{creature.Skeleton.Joints[j].Name} turns by {speed} rad/s at {i * Frame} s");
            }

            ahead = animator.ActEvents.ToArray().Any(e => e.Mark == ActMark.Contact) ? animator.ModelPose.Positions[head].Z : ahead;
            before = animator.LocalPose.Rotations.ToArray();
        }

        Assert.True(ahead > creature.Skeleton.ModelPositions[creature.Skeleton.FirstOf(JointRole.Neck)].Z, $"its head drank {ahead} m ahead of its root");
    }

    private static Creature Of(RequestedKind kind, ulong seed) => CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });

    /// <summary>A creature whose legs and trunk are watched.</summary>
    private sealed class Watched
    {
        private readonly Skeleton skeleton;
        private readonly int[] joints;
        private Quaternion[] before = [];

        /// <summary>Watches the joints of legs and trunk.</summary>
        public Watched(Creature creature)
        {
            skeleton = creature.Skeleton;
            joints = Enumerable.Range(0, skeleton.Count).Where(j => skeleton.Joints[j].Role is JointRole.Body or JointRole.Pelvis or JointRole.Spine or JointRole.Chest or JointRole.Girdle or JointRole.Hip or JointRole.Knee or JointRole.Ankle).ToArray();
            Animator = new CreatureAnimator(creature);
            Animator.Teleport(RootPlace.Identity, FlatGround.Level);
        }

        public CreatureAnimator Animator { get; }

        /// <summary>Rad/s of the fastest joint.</summary>
        public double Fastest { get; private set; }

        public string Joint { get; private set; } = "";

        public void Forget() => Fastest = 0;

        public void Go(int frames, MotionInput input)
        {
            for (int i = 0; i < frames; i++)
            {
                Animator.Update(Frame, input, FlatGround.Level);
                ReadOnlySpan<Quaternion> now = Animator.LocalPose.Rotations;
                foreach (int j in joints)
                {
                    double speed = before.Length == 0 ? 0 : Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before[j]), now[j])) / Frame;
                    if (speed > Fastest)
                    {
                        (Fastest, Joint) = (speed, skeleton.Joints[j].Name);
                    }
                }

                before = now.ToArray();
            }
        }
    }
}
