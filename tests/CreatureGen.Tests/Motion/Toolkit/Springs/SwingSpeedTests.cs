using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Springs;

public sealed class SwingSpeedTests
{
    private const float Frequency = 2f;
    private const float Width = 0.4f;
    private const float Length = 0.2f;

    [Theory]
    [InlineData(1f, 0.4f)]
    [InlineData(1f, 1.2f)]
    [InlineData(0.5f, 0.4f)]
    [InlineData(2f, 0.4f)]
    public void A_jolt_swings_a_bone_to_its_end_no_faster_than_a_free_swing(float maxSpeed, float damping)
    {
        (double widest, double fastest) = Jolted(damping, maxSpeed, out double left);
        double free = maxSpeed * PortableMath.Tau * Frequency * Width;
        Assert.InRange(fastest, 0.5 * free, 1.03 * free);
        Assert.InRange(widest, 0.25 * maxSpeed * Width, 1.001 * Width);
        Assert.True(left < 1e-3, $"{left} rad are left");
    }

    [Fact]
    public void Without_a_bound_the_same_jolt_whips_it()
    {
        (_, double fastest) = Jolted(0.4f, float.MaxValue, out _);
        Assert.True(fastest > 2 * PortableMath.Tau * Frequency * Width, $"{fastest}");
    }

    [Fact]
    public void A_bone_that_hangs_without_a_spring_falls_freely_whatever_the_bound()
    {
        Assert.Equal(Fallen(float.MaxValue), Fallen(1f));
        Assert.True(Fallen(1f) > 1);
    }

    [Fact]
    public void Tails_ears_and_feelers_go_no_faster_than_they_would_by_themselves() =>
        Assert.All(new[] { SpringSettings.Tail(1f), SpringSettings.Ear(0.2f), SpringSettings.Antenna(0.3f) }, settings => Assert.InRange(settings.MaxSpeed, 0.5f, 1f));

    [Theory]
    [InlineData(0f)]
    [InlineData(-1f)]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void A_bound_that_is_none_is_refused(float maxSpeed) =>
        Assert.ThrowsAny<ArgumentException>(() => new SpringSettings(new ChainCurve(1f), new ChainCurve(1f), maxSpeed: maxSpeed));

    /// <summary>A bone whose root is pulled away at 4 m/s from one moment to the next: how far it swings, and how fast at most, radians.</summary>
    private static (double Widest, double Fastest) Jolted(float damping, float maxSpeed, out double left)
    {
        const float Step = 1f / 120f;
        Skeleton one = MovingPose.Chain(2, Length, JointLimit.Free);
        var rig = new SpringRig(one, new[] { 1 });
        var state = new SpringState(rig);
        var settings = new SpringSettings(new ChainCurve(Frequency), new ChainCurve(damping), maxSwing: Width, maxSpeed: maxSpeed);
        double widest = 0;
        double fastest = 0;
        double last = 0;
        for (int i = 0; i < 600; i++)
        {
            var pose = new MovingPose(one);
            var root = new RootPlace(new Vector3(Math.Max(i - 10, 0) * 4f * Step, 0f, 0f), Quaternion.Identity);
            SpringBones.Update(rig, state, settings, root, ReadOnlySpan<SpringCollider>.Empty, Step, pose.Local, pose.Model);
            double angle = MovingPose.Between(pose.ModelRotations[1], one.ModelRotations[1]);
            widest = Math.Max(widest, angle);
            fastest = Math.Max(fastest, Math.Abs(angle - last) / Step);
            last = angle;
        }

        left = last;
        return (widest, fastest);
    }

    private static double Fallen(float maxSpeed)
    {
        Skeleton one = MovingPose.Chain(2, Length, JointLimit.Free);
        var rig = new SpringRig(one, new[] { 1 });
        var state = new SpringState(rig);
        var settings = new SpringSettings(new ChainCurve(0f), new ChainCurve(2f), gravity: new Vector3(9.81f, 0f, 0f), maxSwing: 3.14f, maxSpeed: maxSpeed);
        double angle = 0;
        for (int i = 0; i < 120; i++)
        {
            var pose = new MovingPose(one);
            SpringBones.Update(rig, state, settings, RootPlace.Identity, ReadOnlySpan<SpringCollider>.Empty, 1f / 60f, pose.Local, pose.Model);
            angle = Math.Max(angle, MovingPose.Between(pose.ModelRotations[1], one.ModelRotations[1]));
        }

        return angle;
    }
}
