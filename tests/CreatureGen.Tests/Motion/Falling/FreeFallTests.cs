using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>Walkers that lose the ground.</summary>
public sealed class FreeFallTests
{
    private const float Frame = 1f / 60f;
    private const float Gravity = 9.80665f;

    /// <summary>A mixed lot of walkers, strange ones too.</summary>
    public static IEnumerable<MotionProfile> Lot(ulong first, int count, RequestedKind kind = RequestedKind.Walking)
    {
        for (ulong seed = first; seed < first + (ulong)count; seed++)
        {
            Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind, Strangeness = seed % 2 == 0 ? 0f : 0.6f });
            var profile = new MotionProfile(creature);
            if (profile.LegLength > 0f)
            {
                yield return profile;
            }
        }
    }

    [Fact]
    public void A_walker_that_goes_over_an_edge_falls_lands_and_goes_on()
    {
        int fell = 0;
        int walked = 0;
        int collapsed = 0;
        foreach (MotionProfile profile in Lot(520, 24))
        {
            float leg = profile.LegLength;
            string name = $"{profile.Subject.Seed} {profile.Subject.Plan}";
            var cliff = new Cliff(3f * leg, 1.5f * leg);
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, cliff);
            var states = new List<BodyState> { animator.State };
            var kinds = new List<MotionEventKind>();
            double excess = 0;
            float speed = 0.6f * MathF.Sqrt(Gravity * leg);
            for (int i = 0; i < 1500 && !(animator.State == BodyState.Supported && (states.Count > 1 || animator.Root.Position.Y < -1.4f * leg)); i++)
            {
                animator.Update(Frame, new MotionInput(speed), cliff);
                kinds.AddRange(animator.Events.ToArray().Where(e => e.Foot < 0).Select(e => e.Kind));
                excess = animator.State == BodyState.Supported ? excess : Math.Max(excess, Excess(animator));
                if (animator.State != states[^1])
                {
                    states.Add(animator.State);
                }
            }

            // Long bodies on many legs have feet down below before their middle is over the edge.
            if (states.Count == 1)
            {
                walked++;
                continue;
            }

            // Short stiff legs do not take such a fall.
            if (states.Contains(BodyState.Limp))
            {
                Assert.Equal([BodyState.Supported, BodyState.Falling, BodyState.Limp, BodyState.Rising, BodyState.Supported], states);
                collapsed++;
                continue;
            }

            fell++;
            Assert.Equal([BodyState.Supported, BodyState.Falling, BodyState.Landed, BodyState.Supported], states);
            Assert.Equal([MotionEventKind.Fell, MotionEventKind.Landed], kinds);
            Assert.True(Math.Abs(animator.Root.Position.Y + (1.5f * leg)) < 0.05f * leg, $"{name}: root {animator.Root.Position.Y / leg} legs");
            Assert.True(excess < 1, $"{name}: {excess}° beyond a limit");
        }

        Assert.True(fell > walked + collapsed, $"{fell} fell, {walked} walked down, {collapsed} collapsed");
    }

    /// <summary>From rest a body falls ½gt²: its pelvis does, whatever its legs do meanwhile.</summary>
    [Fact]
    public void A_body_whose_ground_vanishes_falls_as_a_stone_does()
    {
        foreach (MotionProfile profile in Lot(550, 8))
        {
            var animator = new CreatureAnimator(profile);
            MotionSettings settings = animator.Settings;
            settings.Idle = 0f;
            animator.Settings = settings;
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            int pelvis = profile.Subject.Skeleton.IndexOf("Body");
            Walk(animator, 10, FlatGround.Level);
            float start = Height(animator, pelvis);
            int frames = 0;
            for (; animator.State == BodyState.Supported; frames++)
            {
                Walk(animator, 1, new Nothing());
                Assert.True(frames * Frame < 0.3f * MathF.Sqrt(profile.LegLength / Gravity) + (2f * Frame), "it hangs in the air");
            }

            Walk(animator, 29, new Nothing());
            Assert.Equal(BodyState.Falling, animator.State);
            float seconds = 30 * Frame;
            float fallen = start - Height(animator, pelvis);
            Assert.True(Math.Abs(fallen - (0.5f * Gravity * seconds * seconds)) < 0.1f * profile.LegLength, $"{profile.Subject.Seed}: {fallen} m in {seconds} s");
        }
    }

    /// <summary>A pose that stands still for seconds is that of a figure which is let go, not of a creature that falls.</summary>
    [Fact]
    public void In_a_long_fall_legs_tread_the_air_within_their_limits()
    {
        foreach (MotionProfile profile in Lot(550, 6))
        {
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            float tau = MathF.Sqrt(profile.LegLength / Gravity);
            Walk(animator, (int)(6f * tau / Frame), new Nothing());
            int[] hips = profile.Subject.Limbs.Where(limb => limb.Kind == LimbKind.Leg && limb.Stands).Select(limb => limb.Joints[1]).ToArray();
            var watch = new JointWatch(profile);
            var turned = new float[hips.Length];
            Quaternion[] before = animator.LocalPose.Rotations.ToArray();
            for (int i = 0; i < 60; i++)
            {
                Walk(animator, 1, new Nothing());
                watch.Record(animator.LocalPose.Rotations, Frame);
                for (int k = 0; k < hips.Length; k++)
                {
                    turned[k] += (float)Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before[hips[k]]), animator.LocalPose.Rotations[hips[k]]));
                    before[hips[k]] = animator.LocalPose.Rotations[hips[k]];
                }
            }

            string name = $"{profile.Subject.Seed} {profile.Subject.Plan}";
            Assert.Equal(BodyState.Falling, animator.State);
            Assert.True(turned.Min() > 0.3f, $"{name}: a hip turns by {turned.Min()} radians in a second");
            Assert.True(Scalar.Degrees(watch.Excess) < 1 && watch.Speed < 15f, $"{name}: {Scalar.Degrees(watch.Excess)}° beyond a limit, {watch.Speed} rad/s");
        }
    }

    /// <summary>The air takes the turning: half of it is gone in ln 2 / 1.5 s, whatever the player asks for meanwhile.</summary>
    [Fact]
    public void Who_turns_as_the_ground_vanishes_turns_ever_slower_in_the_air()
    {
        foreach (MotionProfile profile in Lot(550, 4))
        {
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            var circle = new MotionInput(0.3f * MathF.Sqrt(Gravity * profile.LegLength), 1f);
            Walk(animator, 60, FlatGround.Level, circle);
            while (animator.State == BodyState.Supported)
            {
                Walk(animator, 1, new Nothing(), circle);
            }

            float begun = TurnOfFrame(animator, circle);
            Walk(animator, 29, new Nothing(), circle);
            float left = TurnOfFrame(animator, circle);
            string name = $"{profile.Subject.Seed}: {begun / Frame} rad/s, half a second later {left / Frame}";
            Assert.True(begun > 0.1f * Frame, name);
            Assert.True(Math.Abs((left / begun) - MathF.Exp(-1.5f * 30 * Frame)) < 0.02f, name);
        }
    }

    [Fact]
    public void Nobody_falls_on_ground_that_goes_on()
    {
        foreach (MotionProfile profile in Lot(560, 8))
        {
            var hills = new Hills(profile.LegLength, 0.2f);
            var animator = new CreatureAnimator(profile);
            for (int i = 0; i < 300; i++)
            {
                animator.Update(Frame, new MotionInput(profile.Gaits!.TopSpeed, i % 100 < 50 ? 1f : -1f), hills);
                Assert.Equal(BodyState.Supported, animator.State);
            }
        }
    }

    [Fact]
    public void The_next_fall_allocates_nothing_and_has_the_same_bits()
    {
        MotionProfile profile = Lot(570, 1).Single();
        var cliff = new Cliff(2f * profile.LegLength, 2f * profile.LegLength);
        var animator = new CreatureAnimator(profile);
        Quaternion[] first = Fall();
        Assert.Equal(0, MovingPose.Allocated(() => Walk(animator, 120, cliff), 1));
        var fresh = new CreatureAnimator(profile);
        animator = fresh;
        Assert.Equal(first, Fall());

        Quaternion[] Fall()
        {
            animator.Teleport(RootPlace.Identity, cliff);
            Walk(animator, 100, cliff);
            Quaternion[] pose = animator.LocalPose.Rotations.ToArray();
            animator.Teleport(RootPlace.Identity, cliff);
            return pose;
        }

        static void Walk(CreatureAnimator animator, int frames, IGround ground)
        {
            for (int i = 0; i < frames; i++)
            {
                animator.Update(Frame, new MotionInput(1.5f), ground);
            }
        }
    }

    private static void Walk(CreatureAnimator animator, int frames, IGround ground, MotionInput input = default)
    {
        for (int i = 0; i < frames; i++)
        {
            animator.Update(Frame, input, ground);
        }
    }

    /// <summary>Radians by which the root turns in the next frame of a fall.</summary>
    private static float TurnOfFrame(CreatureAnimator animator, MotionInput input)
    {
        Quaternion before = animator.Root.Rotation;
        Walk(animator, 1, new Nothing(), input);
        Quaternion turned = Rotation.Multiply(animator.Root.Rotation, Rotation.Inverse(before));
        return 2f * MathF.Asin(MathF.Abs(turned.Y));
    }

    private static float Height(CreatureAnimator animator, int joint) => animator.Root.ToWorld(animator.ModelPose.Positions[joint]).Y;

    /// <summary>Degrees that the worst joint is beyond its limits.</summary>
    private static double Excess(CreatureAnimator animator)
    {
        var watch = new JointWatch(animator.Profile);
        watch.Record(animator.LocalPose.Rotations, Frame);
        return Scalar.Degrees(watch.Excess);
    }
}

/// <summary>Level ground that ends in a drop, across the Z axis.</summary>
internal sealed class Cliff : IGround
{
    private readonly float edge;
    private readonly float drop;

    public Cliff(float edge, float drop)
    {
        this.edge = edge;
        this.drop = drop;
    }

    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        float y = origin.Z < edge ? 0f : -drop;
        hit = new GroundHit(new Vector3(origin.X, y, origin.Z), Vector3.UnitY);
        return origin.Y - y <= distance;
    }
}

/// <summary>No ground at all.</summary>
internal sealed class Nothing : IGround
{
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        hit = default;
        return false;
    }
}
