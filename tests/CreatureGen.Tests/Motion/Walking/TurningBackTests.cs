using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Grounds;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Pace;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

/// <summary>Who goes ahead and is told to go backwards stands still for a moment, with feet in the air.</summary>
public sealed class TurningBackTests
{
    private const float Frame = 1f / 480f;
    private const float Gravity = 9.81f;

    [Theory]
    [InlineData(BodyPlan.Unguligrade)]
    [InlineData(BodyPlan.Theropod)]
    public void The_clock_does_not_stop_as_the_speed_goes_through_nothing(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            LeggedBody body = LeggedBody.Of(new MotionSubject(creature))!;
            RootVelocity velocity = RootVelocity.At(0f, 0f, 0f);
            velocity.Ask(-1f, 0f, 0f);
            var clock = new GaitClock(body, GaitLibrary.Walk);
            clock.Slide(Frame, velocity, Gravity, 1f, 0f);
            Assert.True(clock.Cycle < 13f * Math.Sqrt(body.LegLength / Gravity), FormattableString.Invariant($"{clock.Cycle} s on legs of {body.LegLength} m"));
        }
    }

    [Theory]
    [InlineData(15100010)]
    [InlineData(15100074)]
    [InlineData(15100273)]
    public void No_foot_is_flung_as_a_walker_turns_back(ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 1 });
        int[] joints = [.. creature.Limbs.Where(limb => limb.Kind == LimbKind.Leg).SelectMany(limb => limb.Joints)];
        for (int moment = 0; moment < 6; moment++)
        {
            var animator = new CreatureAnimator(creature);
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            Quaternion[] before = [.. animator.LocalPose.Rotations];
            float fastest = 0f;
            int turn = (int)((1.5f + (0.07f * moment)) / Frame);
            for (int i = 0; i < turn + 720; i++)
            {
                animator.Update(Frame, new MotionInput(i < turn ? creature.DefaultSpeed : -0.5f * creature.DefaultSpeed), FlatGround.Level);
                foreach (int joint in joints)
                {
                    Quaternion now = animator.LocalPose.Rotations[joint];
                    fastest = i > turn ? Math.Max(fastest, (float)Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before[joint]), now)) / Frame) : fastest;
                    before[joint] = now;
                }
            }

            Assert.True(fastest < 60f, FormattableString.Invariant($"{fastest} rad/s, turned back after {turn * Frame} s"));
        }
    }
}
