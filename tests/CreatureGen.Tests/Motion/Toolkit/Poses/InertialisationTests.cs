using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Poses;

public sealed class InertialisationTests
{
    private const float Step = 1f / 240f;
    private static readonly Skeleton skeleton = MovingPose.Chain(3, 0.3f, JointLimit.Free);

    /// <summary>Two motions about different axes; a joint's place swings too.</summary>
    private static void First(float time, MovingPose pose) => Motion(time, pose, new Vector3(0.6f, 0f, 0.8f), 1.1, 3.0, 0.2f);

    private static void Second(float time, MovingPose pose) => Motion(time, pose, Vector3.UnitY, -0.7, 2.0, -0.1f);

    private static void Motion(float time, MovingPose pose, Vector3 axis, double amplitude, double speed, float shift)
    {
        for (int i = 0; i < pose.LocalRotations.Length; i++)
        {
            pose.LocalRotations[i] = Rotation.FromAxisAngle(axis, amplitude * PortableMath.Sin((speed * time) + i + 0.4));
            pose.LocalPositions[i] = new Vector3(shift * (float)PortableMath.Sin(4 * time), i == 0 ? 0f : 0.3f, shift * time);
        }
    }

    [Fact]
    public void Neither_place_nor_velocity_jumps_and_the_new_motion_is_all_that_is_left_in_the_end()
    {
        const float Switch = 0.6f;
        const float Duration = 0.4f;
        MovingPose before = new(skeleton), shown = new(skeleton), next = new(skeleton), nextBefore = new(skeleton), result = new(skeleton);
        First(Switch - Step, before);
        First(Switch, shown);
        Second(Switch, next);
        Second(Switch - Step, nextBefore);
        var offsets = new InertialOffset[skeleton.Count];
        Inertialisation.Start(shown.Local, before.Local, next.Local, nextBefore.Local, Step, Duration, offsets);

        Quaternion[] lastRotations = (Quaternion[])shown.LocalRotations.Clone();
        Vector3[] lastPositions = (Vector3[])shown.LocalPositions.Clone();
        double[] lastSpeed = new double[skeleton.Count];
        Vector3[] lastVelocity = new Vector3[skeleton.Count];
        for (int i = 0; i < skeleton.Count; i++)
        {
            lastSpeed[i] = MovingPose.Between(before.LocalRotations[i], shown.LocalRotations[i]) / Step;
            lastVelocity[i] = (shown.LocalPositions[i] - before.LocalPositions[i]) / Step;
        }

        for (int k = 0; k * Step <= Duration + Step; k++)
        {
            Second(Switch + (k * Step), result);
            Inertialisation.Apply(offsets, k * Step, result.Local);
            for (int i = 0; i < skeleton.Count; i++)
            {
                double turned = MovingPose.Between(lastRotations[i], result.LocalRotations[i]);
                Vector3 moved = result.LocalPositions[i] - lastPositions[i];
                if (k == 0)
                {
                    Assert.True(turned < 1e-5 && Vec.Length(moved) < 1e-6f);
                }
                else
                {
                    Assert.InRange((turned / Step) - lastSpeed[i], -0.6, 0.6);
                    Assert.True(Vec.Distance(moved / Step, lastVelocity[i]) < 0.15f);
                    lastSpeed[i] = turned / Step;
                    lastVelocity[i] = moved / Step;
                }
            }

            result.LocalRotations.CopyTo(lastRotations, 0);
            result.LocalPositions.CopyTo(lastPositions, 0);
        }

        Second(Switch + Duration, next);
        Second(Switch + Duration, result);
        Inertialisation.Apply(offsets, Duration, result.Local);
        Assert.Equal(next.LocalRotations, result.LocalRotations);
        Assert.Equal(next.LocalPositions, result.LocalPositions);
    }

    [Fact]
    public void A_still_offset_is_half_gone_at_half_time_and_never_overshoots()
    {
        MovingPose shown = new(skeleton), next = new(skeleton), result = new(skeleton);
        shown.LocalRotations[1] = Rotation.FromAxisAngle(Vector3.UnitX, 1);
        var offsets = new InertialOffset[skeleton.Count];
        Inertialisation.Start(shown.Local, shown.Local, next.Local, next.Local, Step, 1f, offsets);
        double last = 1.0001;
        for (int k = 0; k <= 100; k++)
        {
            next.LocalRotations.CopyTo(result.LocalRotations, 0);
            Inertialisation.Apply(offsets, k / 100f, result.Local);
            double angle = 2 * PortableMath.Asin(result.LocalRotations[1].X);
            Assert.True(angle <= last && angle >= 0);
            last = angle;
            if (k == 50)
            {
                Assert.Equal(0.5, angle, 5);
            }
        }
    }

    [Fact]
    public void A_fast_approach_ends_early_instead_of_swinging_through()
    {
        MovingPose before = new(skeleton), shown = new(skeleton), next = new(skeleton), result = new(skeleton);
        before.LocalRotations[1] = Rotation.FromAxisAngle(Vector3.UnitX, 1 + (20 * Step));
        shown.LocalRotations[1] = Rotation.FromAxisAngle(Vector3.UnitX, 1);
        var offsets = new InertialOffset[skeleton.Count];
        Inertialisation.Start(shown.Local, before.Local, next.Local, next.Local, Step, 1f, offsets);
        for (int k = 0; k <= 100; k++)
        {
            next.LocalRotations.CopyTo(result.LocalRotations, 0);
            Inertialisation.Apply(offsets, k / 100f, result.Local);
            Assert.True(result.LocalRotations[1].X >= -1e-6f);
            Assert.True(k < 25 || result.LocalRotations[1].X == 0f, "gone at 5 · 1 / 20 s");
        }
    }

    [Fact]
    public void Without_an_earlier_pose_or_with_no_time_at_all_the_result_is_finite()
    {
        MovingPose shown = new MovingPose(skeleton).Shaken(3, 3.1), next = new(skeleton);
        var offsets = new InertialOffset[skeleton.Count];
        foreach (float duration in new[] { 0f, 1e-8f, 0.3f })
        {
            Inertialisation.Start(shown.Local, next.Local, next.Local, shown.Local, 0f, duration, offsets);
            MovingPose result = new(skeleton);
            Inertialisation.Apply(offsets, 0f, result.Local);
            Assert.All(result.LocalRotations, q => Assert.Equal(1f, q.Length(), 1e-5f));
        }

        MovingPose untouched = new(skeleton);
        Inertialisation.Apply(new InertialOffset[skeleton.Count], 0f, untouched.Local);
        Assert.Equal(next.LocalRotations, untouched.LocalRotations);
    }

    [Fact]
    public void A_pose_that_is_not_finite_is_refused()
    {
        MovingPose shown = new(skeleton), next = new(skeleton);
        shown.LocalPositions[2].Y = float.NaN;
        var offsets = new InertialOffset[skeleton.Count];
        Assert.Contains("joint 2", Assert.Throws<ArgumentException>(() => Inertialisation.Start(shown.Local, shown.Local, next.Local, next.Local, Step, 1f, offsets)).Message);
        Assert.Contains("3 offsets", Assert.Throws<ArgumentException>(() => Inertialisation.Apply(offsets.AsSpan(0, 3), 0f, next.Local)).Message);
    }
}
