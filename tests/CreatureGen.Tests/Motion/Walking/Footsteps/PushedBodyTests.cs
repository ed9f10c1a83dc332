using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Pace;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Footsteps;

/// <summary>A body that a game moves stays on its legs.</summary>
public sealed class PushedBodyTests
{
    private const float Rate = 60f;
    private const float Gravity = 9.81f;
    private const float Leg = 0.5f;

    private static readonly VelocityBounds bounds = new(new SpeedBounds(6f, 7f, 0.15f), new SpeedBounds(6f, 6f, 0.15f), 6f);

    [Fact]
    public void One_that_is_moved_as_it_moves_itself_is_where_it_is_put_to_the_last_bit()
    {
        PushedBody pushed = default;
        RootPlace place = RootPlace.Identity;
        float speed = 0f;
        for (int i = 0; i < 120; i++)
        {
            speed = Math.Min(speed + (6f / Rate), 4f);
            RootPlace goal = new(place.Position + new Vector3(0f, 0.1f, speed / Rate), Quaternion.CreateFromAxisAngle(Vector3.UnitY, 0.3f * i / Rate));
            Assert.True(pushed.Follow(place, goal, 1f / Rate, bounds, Gravity, Leg));
            Assert.False(pushed.IsBehind);
            Assert.Equal(goal, pushed.At(goal));
            place = goal;
        }
    }

    [Fact]
    public void One_that_is_shoved_catches_up_within_a_second_and_no_faster_than_its_bound()
    {
        PushedBody pushed = default;
        RootPlace goal = new(new Vector3(0.3f, 0f, -0.2f), Quaternion.CreateFromAxisAngle(Vector3.UnitY, 0.6f));
        RootPlace before = RootPlace.Identity;
        Vector3 last = Vector3.Zero;
        Vector3 velocity = Vector3.Zero;
        int frames = 0;
        do
        {
            Assert.True(pushed.Follow(before, goal, 1f / Rate, bounds, Gravity, Leg));
            before = goal;
            Vector3 at = pushed.At(goal).Position;
            Vector3 now = (at - last) * Rate;
            Assert.True(Vector3.Distance(now, velocity) * Rate < 1.5f * Gravity * 1.01f, $"{Vector3.Distance(now, velocity) * Rate} m/s² in frame {frames}");
            (last, velocity) = (at, now);
            frames++;
        }
        while (pushed.IsBehind && frames < 100);
        Assert.InRange(frames, 5, 60);
        Assert.Equal(goal, pushed.At(goal));
    }

    [Fact]
    public void One_that_is_put_far_away_is_there_at_once()
    {
        PushedBody pushed = default;
        RootPlace goal = new(new Vector3(0f, 0f, 100f), Quaternion.Identity);
        Assert.False(pushed.Follow(RootPlace.Identity, goal, 1f / Rate, bounds, Gravity, Leg));
        Assert.Equal(goal, pushed.At(goal));
    }

    /// <summary>A lizard that is turned quicker than it would turn took no quicker steps than by itself: its feet were dragged to where no leg reaches, and its hips flipped over at 1,237 rad/s.</summary>
    [Fact]
    public void One_that_is_turned_quicker_than_it_would_turn_takes_quicker_steps()
    {
        const float Hertz = 480f;
        Creature creature = CreatureGenerator.Generate(10743015, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        var animator = new CreatureAnimator(creature);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Vector3 at = Vector3.Zero;
        float facing = 0f;
        var joints = new JointWatch(animator.Profile);
        for (int i = 0; i < 8 * Hertz; i++)
        {
            bool turns = i % (2 * (int)Hertz) > Hertz;
            facing += turns ? (i < 4 * Hertz ? 2.5f : -2.5f) / Hertz : 0f;
            Quaternion rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitY, facing);
            at += Vector3.Transform(new Vector3(0f, 0f, creature.DefaultSpeed / Hertz), rotation);
            animator.Follow(1f / Hertz, new RootPlace(at, rotation), FlatGround.Level);
            joints.Record(animator.LocalPose.Rotations, 1f / Hertz);
        }

        Assert.InRange(joints.Speed, 1f, 90f);
    }

    [Fact]
    public void Shoves_do_not_tear_legs()
    {
        foreach (ulong seed in new ulong[] { 1, 2, 3, 5, 6 })
        {
            var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
            if (profile.Legs is not LeggedBody body)
            {
                continue;
            }

            var animator = new CreatureAnimator(profile);
            var joints = new JointWatch(profile);
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            Vector3 place = Vector3.Zero;
            float heading = 0f;
            for (int i = 0; i < 6 * Rate; i++)
            {
                if (i % 60 == 30)
                {
                    place += new Vector3(i % 120 == 30 ? 0.4f : -0.3f, 0f, 0.25f) * body.LegLength;
                    heading += 0.5f;
                }

                animator.Follow(1f / Rate, new RootPlace(place, Quaternion.CreateFromAxisAngle(Vector3.UnitY, heading)), FlatGround.Level);
                joints.Record(animator.LocalPose.Rotations, 1f / Rate);
            }

            Assert.True(joints.Speed < 60f, $"{seed}: {joints.Speed} rad/s of {body.Skeleton.Joints[joints.SpeedJoint].Name}");
            Assert.True(joints.Excess < 0.01, $"{seed}: {joints.Excess} beyond limits");
        }
    }
}
