using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Chains;

public sealed class SoftLimitTests
{
    private static readonly JointLimit lopsided = new(new AngleRange(-0.3f, 1.2f), new AngleRange(-0.8f, 0.1f), new AngleRange(-0.2f, 0.5f));

    [Fact]
    public void A_rotation_well_within_is_left_as_it_is()
    {
        Quaternion q = Rotation.Multiply(Rotation.FromAxisAngle(Vector3.UnitX, 0.5), Rotation.FromAxisAngle(Vector3.UnitY, -0.1));
        Assert.Equal(q, new SoftLimit(lopsided).Apply(q));
    }

    [Fact]
    public void No_rotation_gets_out()
    {
        var limit = new SoftLimit(lopsided);
        var random = new RandomStream(5);
        for (int i = 0; i < 2000; i++)
        {
            var axis = Vec.Normalize(new Vector3((float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1)), Vector3.UnitX);
            Quaternion kept = limit.Apply(Rotation.FromAxisAngle(axis, random.Uniform(-2.5, 2.5)));
            SoftLimit.Angles(kept, out double x, out double twist, out double z);
            Assert.InRange(x, lopsided.SwingX.Min - 1e-5, lopsided.SwingX.Max + 1e-5);
            Assert.InRange(z, lopsided.SwingZ.Min - 1e-5, lopsided.SwingZ.Max + 1e-5);
            Assert.InRange(twist, lopsided.Twist.Min - 1e-5, lopsided.Twist.Max + 1e-5);
        }
    }

    [Fact]
    public void What_is_told_to_be_free_without_a_root_is_free_as_it_is_measured()
    {
        var limit = new SoftLimit(lopsided);
        var bounds = new SwingTwistBounds(lopsided, 0.84f);
        var random = new RandomStream(7);
        int held = 0;
        for (int i = 0; i < 20000; i++)
        {
            var axis = Vec.Normalize(new Vector3((float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1)), Vector3.UnitX);
            Quaternion turn = Rotation.FromAxisAngle(axis, random.Uniform(-1.5, 1.5));
            if (bounds.HoldSmall(turn))
            {
                held++;
                SoftLimit.Angles(turn, out double x, out double twist, out double z);
                double across = x / (x < 0 ? lopsided.SwingX.Min : lopsided.SwingX.Max);
                double aside = z / (z < 0 ? lopsided.SwingZ.Min : lopsided.SwingZ.Max);
                Assert.InRange(Math.Sqrt((across * across) + (aside * aside)), 0, 0.85);
                Assert.InRange(twist, 0.85 * lopsided.Twist.Min, 0.85 * lopsided.Twist.Max);
                Assert.Equal(turn, limit.Apply(turn));
            }
        }

        Assert.InRange(held, 200, 19000);
    }

    [Fact]
    public void Its_slope_never_jumps_and_never_falls()
    {
        var limit = new SoftLimit(lopsided);
        double last = 0;
        double slope = 1;
        for (int i = 1; i < 300; i++)
        {
            SoftLimit.Angles(limit.Apply(Rotation.FromAxisAngle(Vector3.UnitX, 0.01 * i)), out double x, out _, out _);
            double now = (x - last) / 0.01;
            Assert.True(now > -1e-3, $"falls at {i}");
            Assert.True(Math.Abs(now - slope) < 0.08, FormattableString.Invariant($"slope jumps from {slope} to {now} at {i}"));
            slope = now;
            last = x;
        }
    }

    [Fact]
    public void A_swing_bounded_all_round_is_within_the_limit_as_it_is_measured()
    {
        var limit = new SoftLimit(lopsided);
        var random = new RandomStream(6);
        for (int i = 0; i < 2000; i++)
        {
            var axis = Vec.Normalize(new Vector3((float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1)), Vector3.UnitX);
            Quaternion q = Rotation.FromAxisAngle(axis, random.Uniform(-2.5, 2.5));
            Quaternion kept = limit.Apply(q);
            Assert.True(SwingTwistLimit.Excess(kept, lopsided) < 1e-5f);
            SoftLimit.Angles(q, out double x, out _, out double z);
            SoftLimit.Angles(kept, out double keptX, out _, out double keptZ);
            Assert.True(Math.Abs((x * keptZ) - (z * keptX)) < 1e-5 && (x * keptX) + (z * keptZ) >= 0, "it swings another way");
        }

        Quaternion within = Rotation.Multiply(Rotation.FromAxisAngle(Vector3.UnitX, 0.5), Rotation.FromAxisAngle(Vector3.UnitY, -0.1));
        Assert.Equal(within, limit.Apply(within));
    }

    [Fact]
    public void A_fixed_joint_does_not_turn()
    {
        Quaternion kept = new SoftLimit(JointLimit.Fixed).Apply(Rotation.FromAxisAngle(Vector3.UnitZ, 1));
        Assert.True(Rotation.Angle(kept) < 1e-6);
    }
}
