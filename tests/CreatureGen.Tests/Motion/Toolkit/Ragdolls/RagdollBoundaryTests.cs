using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Ragdolls;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ragdolls;

public sealed class RagdollBoundaryTests
{
    public static IEnumerable<TheoryDataRow<float, float, float, float, float>> Corners =>
        from gravity in new[] { 0f, 1000f }
        from damping in new[] { 0f, 1e4f }
        from friction in new[] { 0f, 100f }
        from tone in new[] { 0f, 1e4f }
        select new TheoryDataRow<float, float, float, float, float>(gravity, tone > 0f ? 0f : damping, damping, friction, tone) { Explicit = friction > 0f };

    /// <summary>Every corner of what is accepted, at even and uneven frames.</summary>
    [Theory]
    [MemberData(nameof(Corners))]
    public void Every_accepted_setting_keeps_a_ragdoll_finite(float gravity, float jointDamping, float airDamping, float friction, float tone)
    {
        Creature creature = CreatureGenerator.Generate(42);
        RagdollRig rig = new RagdollRig(creature.Skeleton, creature.Bones);
        var state = new RagdollState(rig);
        MovingPose pose = new(creature.Skeleton);
        var settings = new RagdollSettings(new Vector3(0.3f * gravity, -gravity, 0f), jointDamping, airDamping, friction, tone);
        var root = new RootPlace(new Vector3(0f, 0.5f, 0f), Quaternion.Normalize(new Quaternion(0.3f, 0.2f, 0.4f, 0.9f)));
        Ragdoll.Start(rig, state, root, pose.Model, root, pose.Model, 0f, FlatGround.Level);
        for (int i = 0; i < 120; i++)
        {
            Ragdoll.Advance(rig, state, settings, FlatGround.Level, i % 10 == 0 ? 0.2f : i % 3 == 0 ? 1e-4f : 1f / 60f);
        }

        Ragdoll.Show(rig, state, root, pose.Local, pose.Model);
        foreach (Quaternion q in pose.ModelRotations)
        {
            Assert.True(Math.Abs(q.LengthSquared() - 1f) < 1e-3f);
        }

        foreach (Vector3 p in pose.ModelPositions)
        {
            Assert.True(float.IsFinite(p.X + p.Y + p.Z));
        }
    }

    [Fact]
    public void Gravity_of_any_number_is_refused()
    {
        Assert.Contains("gravity", Assert.ThrowsAny<ArgumentException>(() => new RagdollSettings(new Vector3(0f, -1e20f, 0f))).Message, StringComparison.Ordinal);
        Assert.ThrowsAny<ArgumentException>(() => new RagdollSettings(new Vector3(0f, float.NaN, 0f)));
    }

    [Fact]
    public void Every_accepted_velocity_gives_a_finite_path()
    {
        float[] speeds = { 0f, 1f, 1e9f, -1e9f };
        float[] turns = { 0f, 1e6f, -1e6f };
        float[] rates = { 0f, 1e-6f, 1e6f };
        float[] times = { 0f, 1e-6f, 1f, 1e6f };
        foreach (float speed in speeds)
        {
            foreach (float turn in turns)
            {
                foreach (float rate in rates)
                {
                    foreach (float seconds in times)
                    {
                        var velocity = new BodyVelocity(new Vector3(speed, 0f, -speed), turn);
                        RootDelta delta = VelocityDamping.Advance(ref velocity, new BodyVelocity(new Vector3(-speed, speed, 1f), -turn), rate, rate, seconds);
                        Assert.True(float.IsFinite(delta.Shift.X + delta.Shift.Y + delta.Shift.Z + delta.Turn), $"{speed} {turn} {rate} {seconds}");
                        Assert.True(float.IsFinite(velocity.Linear.X + velocity.YawRate));
                    }
                }
            }
        }

        var fast = new BodyVelocity(new Vector3(1e20f, 0f, 0f), 0f);
        Assert.ThrowsAny<ArgumentException>(() => VelocityDamping.Advance(ref fast, default, 1f, 1f, 1f));
        BodyVelocity none = default;
        Assert.ThrowsAny<ArgumentException>(() => VelocityDamping.Advance(ref none, default, 1f, 1f, 1e30f));
    }
}
