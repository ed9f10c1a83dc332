using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Gaze;

/// <summary>What heads do that sit on their trunks without a neck.</summary>
public sealed class FishGazeTests
{
    [Fact]
    public void Fish_look_aside_with_their_eyes_and_hardly_turn_their_heads()
    {
        foreach (Creature fish in StrokeSubject.Of(BodyPlan.Fish))
        {
            (double head, double eye) = Turned(fish);
            Assert.InRange(head, 0.05, 0.2);
            Assert.True(eye > head, $"seed {fish.Blueprint.Seed}: head {head}, eye {eye}");
        }
    }

    [Fact]
    public void Heads_on_necks_turn_with_the_look()
    {
        foreach (Creature dog in StrokeSubject.Of(BodyPlan.Digitigrade))
        {
            Assert.True(Turned(dog).Head > 0.4);
        }
    }

    /// <summary>How far a head and its left eye are turned as the creature has looked for a while at what is obliquely ahead to its left, radians; the head as seen from the trunk, the eye from the head.</summary>
    private static (double Head, double Eye) Turned(Creature creature)
    {
        var profile = new MotionProfile(creature);
        var animator = new CreatureAnimator(profile) { Settings = MotionSettings.Default with { Idle = 0f } };
        double before = Yaw(animator, profile);
        animator.LookAt = new Vector3(70f, animator.ModelPose.Positions[profile.Gaze!.Head].Y, 100f);
        Walkers.Run(animator, 3f, 60f, default, FlatGround.Level);
        Quaternion eye = Rotation.Multiply(Rotation.Inverse(creature.Skeleton.Joints[profile.Gaze.LeftEye].LocalRotation), animator.LocalPose.Rotations[profile.Gaze.LeftEye]);
        return (Math.Abs(Yaw(animator, profile) - before), Rotation.Angle(eye));
    }

    private static double Yaw(CreatureAnimator animator, MotionProfile profile)
    {
        Pose model = animator.ModelPose;
        Quaternion head = Rotation.Multiply(model.Rotations[profile.Gaze!.Head], profile.Gaze.HeadToModel);
        Quaternion trunk = Rotation.Multiply(model.Rotations[profile.Gaze.Base], profile.Gaze.BaseToModel);
        Vector3 ahead = Rotation.Rotate(Rotation.Inverse(trunk), Rotation.Rotate(head, Vector3.UnitZ));
        return Math.Atan2(ahead.X, ahead.Z);
    }
}
