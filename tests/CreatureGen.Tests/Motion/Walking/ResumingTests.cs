using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

/// <summary>Who is to stop and goes on after all, as a player lets go of a stick and pushes it again.</summary>
public sealed class ResumingTests
{
    private const float Frame = 1f / 480f;

    // What short legs at a run turn by themselves.
    private const double FastestJoint = 75;

    /// <summary>The tempo that who stops keeps up was dropped at once, the body jumped to the bounce of another one, and knees with it: in eight of these 18 by 75 to 199 rad/s.</summary>
    [Fact]
    public void No_leg_jumps_as_a_creature_that_stops_goes_on_after_all()
    {
        const int Pauses = 8;
        int walked = 0;
        for (ulong seed = 10742000; seed < 10742000 + (ulong)Thoroughness.Of(18); seed++)
        {
            Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            var profile = new MotionProfile(creature);
            for (int pause = 0; pause < Pauses; pause++)
            {
                walked += Watch(creature, profile, (pause + (int)(seed % Pauses)) % 24, seed) ? 1 : 0;
            }
        }

        Assert.True(walked > Thoroughness.Of(18) * Pauses / 2, $"{walked} walked");
    }

    /// <summary>Has it go, stop, and go on after a while, and watches its legs from when it stops.</summary>
    private static bool Watch(Creature creature, MotionProfile profile, int kind, ulong seed)
    {
        float pause = 0.05f + (0.07f * kind);
        float before = creature.DefaultSpeed * (0.5f + (0.7f * (kind % 4)));
        float after = creature.DefaultSpeed * (0.4f + (0.9f * (kind % 3)));
        float turn = 1.5f * ((kind % 3) - 1);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Skeleton skeleton = creature.Skeleton;
        Quaternion[] last = [];
        int stop = (int)(1.5f / Frame);
        int go = stop + (int)(pause / Frame);
        for (int i = 0; i < go + 240; i++)
        {
            animator.Update(Frame, i < stop ? new MotionInput(before) : i < go ? default : new MotionInput(after, turn), FlatGround.Level);
            ReadOnlySpan<Quaternion> now = animator.LocalPose.Rotations;
            for (int j = 0; i > stop && j < skeleton.Count; j++)
            {
                if (skeleton.Joints[j].Role is JointRole.Hip or JointRole.Knee or JointRole.Ankle)
                {
                    double speed = Rotation.Angle(Rotation.Multiply(Rotation.Inverse(last[j]), now[j])) / Frame;
                    Assert.True(speed < FastestJoint, $"{seed}: {skeleton.Joints[j].Name} turns by {speed} rad/s {(i - go) * Frame} s after it goes on, {pause} s after it was to stop");
                }
            }

            last = i >= stop ? now.ToArray() : last;
        }

        return profile.LegLength > 0f;
    }
}
