using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>Backs of limp bodies, which the edge of a stair is under.</summary>
public sealed class DoubledOverTests
{
    /// <summary>The weight of rump and chest bent these by 87, 72, 93, 66, 65 and 97° between pelvis and chest, as far as all of the joints went that muscles would have held.</summary>
    [Theory]
    [InlineData(24940048UL, CourseGround.Stairs)]
    [InlineData(24940026UL, CourseGround.Stairs, Explicit = true)]
    [InlineData(24940055UL, CourseGround.Slope)]
    [InlineData(24940012UL, CourseGround.Flat, Explicit = true)]
    [InlineData(24920016UL, CourseGround.Stairs, Explicit = true)]
    [InlineData(24816002UL, CourseGround.Stairs)]
    public void Nobody_is_doubled_over_as_it_falls(ulong seed, CourseGround ground)
    {
        const double MaxBend = 55;
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        Skeleton skeleton = profile.Subject.Skeleton;
        int pelvis = skeleton.FirstOf(JointRole.Pelvis);
        int chest = skeleton.FirstOf(JointRole.Chest);
        var runs = new MotionInput(profile.Gaits!.Speeds[^1].Comfortable);
        var script = new CourseScript("down", [new(2f, runs), new(3f, default) { Body = BodyCommand.KnockDown }]);
        var course = new CourseSimulation(profile, script, ground, CourseRate.Of(60f));
        double bend = 0;
        foreach (float _ in course.Updates())
        {
            CreatureAnimator animator = course.Animator;
            if (animator.State == BodyState.Limp)
            {
                Vector3 back = Ahead(skeleton, animator, pelvis);
                Vector3 breast = Ahead(skeleton, animator, chest);
                bend = Math.Max(bend, Scalar.Degrees(PortableMath.Atan2(Vec.Length(Vec.Cross(back, breast)), Vec.Dot(back, breast))));
            }
        }

        Assert.InRange(bend, 1, MaxBend);
    }

    /// <summary>Where in model space a joint has turned what was ahead of it.</summary>
    private static Vector3 Ahead(Skeleton skeleton, CreatureAnimator animator, int joint) =>
        Rotation.Rotate(Rotation.Multiply(animator.ModelPose.Rotations[joint], Rotation.Inverse(skeleton.ModelRotations[joint])), Vector3.UnitZ);
}
