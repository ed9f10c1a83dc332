using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit.Ik;

public sealed class SwingTwistLimitTests
{
    private static readonly JointLimit lopsided = new(new AngleRange(-0.4f, 1.2f), new AngleRange(-0.2f, 0.6f), new AngleRange(-0.1f, 0.5f));

    [Theory]
    [InlineData(0.7f, 1f, 0f, 0f)]
    [InlineData(-1.0f, 1f, 0f, 0f)]
    [InlineData(2.9f, 1f, 0f, 0f)]
    [InlineData(0.9f, 0f, 0f, 1f)]
    [InlineData(-0.9f, 0f, 0f, 1f)]
    [InlineData(0.9f, 0f, 1f, 0f)]
    [InlineData(-0.9f, 0f, 1f, 0f)]
    public void About_each_axis_the_turn_ends_at_that_range(float angle, float x, float y, float z)
    {
        var axis = new Vector3(x, y, z);
        Quaternion bounded = SwingTwistLimit.Clamp(Rotation.FromAxisAngle(axis, angle), lopsided);
        AngleRange range = x > 0 ? lopsided.SwingX : y > 0 ? lopsided.Twist : lopsided.SwingZ;
        Assert.True(MovingPose.Between(Rotation.FromAxisAngle(axis, range.Clamp(angle)), bounded) < 1e-5);
    }

    [Fact]
    public void In_a_round_cone_a_swing_keeps_its_direction_and_ends_at_the_cone()
    {
        var limit = new JointLimit(0.5f, 0.5f, 0.2f);
        for (int i = 0; i < 24; i++)
        {
            double a = i * PortableMath.Tau / 24;
            var axis = new Vector3((float)PortableMath.Cos(a), 0f, (float)PortableMath.Sin(a));
            Quaternion bounded = SwingTwistLimit.Clamp(Rotation.FromAxisAngle(axis, 1.7), limit);
            Assert.True(MovingPose.Between(Rotation.FromAxisAngle(axis, 0.5), bounded) < 1e-5);
        }
    }

    [Fact]
    public void A_rotation_is_bounded_alike_by_either_of_its_quaternions()
    {
        RandomStream random = new Seed(6).Stream();
        for (int i = 0; i < 20000; i++)
        {
            Quaternion any = MovingPose.AnyRotation(random);
            Quaternion q = i % 2 == 0 ? any : Rotation.Nlerp(Quaternion.Identity, any, 0.3);
            var same = new Quaternion(-q.X, -q.Y, -q.Z, -q.W);
            Quaternion bounded = SwingTwistLimit.Clamp(q, lopsided);
            Assert.True(MovingPose.Between(bounded, SwingTwistLimit.Clamp(same, lopsided)) < 3e-5);
            Assert.Equal(SwingTwistLimit.TryBound(q, out float x, out float z, out float twist), SwingTwistLimit.TryBound(same, out float x2, out float z2, out float twist2));
            Assert.Equal((x, z, twist), (x2, z2, twist2));
        }
    }

    [Fact]
    public void Turns_within_come_back_to_the_bit_and_turns_outside_end_within()
    {
        RandomStream random = new Seed(5).Stream();
        int inside = 0;
        for (int i = 0; i < 20000; i++)
        {
            Quaternion q = MovingPose.AnyRotation(random);
            Quaternion bounded = SwingTwistLimit.Clamp(q, lopsided);
            SwingTwistLimit.Split(bounded, out double x, out double z, out double twist);
            double a = x < 0 ? 0.4 : 1.2;
            double b = z < 0 ? 0.2 : 0.6;
            Assert.True((x / a * (x / a)) + (z / b * (z / b)) < 1 + 2e-4);
            Assert.InRange(twist, -0.1 - 2e-5, 0.5 + 2e-5);
            Quaternion again = SwingTwistLimit.Clamp(bounded, lopsided);
            Assert.True(MovingPose.Between(bounded, again) < 3e-5);
            if (bounded == q)
            {
                inside++;
            }
        }

        Assert.InRange(inside, 500, 5000);
    }

    [Fact]
    public void The_nearest_swing_is_nearer_than_any_other_of_the_limit()
    {
        RandomStream random = new Seed(6).Stream();
        for (int i = 0; i < 300; i++)
        {
            double px = random.Uniform(-3, 3);
            double pz = random.Uniform(-3, 3);
            double x = px;
            double z = pz;
            SwingTwistLimit.ClampSwing(lopsided.SwingX, lopsided.SwingZ, ref x, ref z);
            double found = Math.Sqrt(((x - px) * (x - px)) + ((z - pz) * (z - pz)));
            double best = double.MaxValue;
            for (int k = 0; k < 4000; k++)
            {
                double angle = k * PortableMath.Tau / 4000;
                double c = PortableMath.Cos(angle);
                double s = PortableMath.Sin(angle);
                double ex = c * (c < 0 ? 0.4 : 1.2);
                double ez = s * (s < 0 ? 0.2 : 0.6);
                best = Math.Min(best, Math.Sqrt(((ex - px) * (ex - px)) + ((ez - pz) * (ez - pz))));
            }

            Assert.True(found <= best + 1e-6);
        }
    }

    [Fact]
    public void A_hinge_keeps_its_axis_alone_and_a_fixed_joint_nothing()
    {
        RandomStream random = new Seed(7).Stream();
        var hinge = new JointLimit(new AngleRange(-0.2f, 2f), default, default);
        for (int i = 0; i < 1000; i++)
        {
            Quaternion q = MovingPose.AnyRotation(random);
            Quaternion bounded = SwingTwistLimit.Clamp(q, hinge);
            Assert.True(Math.Abs(bounded.Y) < 1e-5f && Math.Abs(bounded.Z) < 1e-5f);
            Assert.True(Rotation.Angle(SwingTwistLimit.Clamp(q, JointLimit.Fixed)) < 1e-5);
            Assert.Equal(q, SwingTwistLimit.Clamp(q, JointLimit.Free));
        }
    }

    [Fact]
    public void Split_parts_make_up_the_turn_also_when_the_bone_points_back()
    {
        RandomStream random = new Seed(8).Stream();
        for (int i = 0; i < 5000; i++)
        {
            Quaternion q = i == 0 ? new Quaternion(0.6f, 0f, 0.8f, 0f) : MovingPose.AnyRotation(random);
            SwingTwistLimit.Split(q, out double x, out double z, out double twist);
            Quaternion made = Rotation.Multiply(SwingTwistLimit.Swing(x, z), Rotation.FromAxisAngle(Vector3.UnitY, twist));
            Assert.True(MovingPose.Between(q, made) < 2e-6);
        }
    }

    [Fact]
    public void The_mirrored_limit_of_the_mirrored_turn_gives_the_mirror_image()
    {
        RandomStream random = new Seed(9).Stream();
        for (int i = 0; i < 2000; i++)
        {
            Quaternion q = MovingPose.AnyRotation(random);
            Quaternion left = SwingTwistLimit.Clamp(q, lopsided);
            Quaternion right = SwingTwistLimit.Clamp(Rotation.Mirror(q), lopsided.Mirrored());
            Assert.True(MovingPose.Between(Rotation.Mirror(left), right) < 1e-6);
        }
    }

    [Fact]
    public void Excess_is_how_far_a_turn_lies_outside()
    {
        Assert.Equal(0f, SwingTwistLimit.Excess(Rotation.FromAxisAngle(Vector3.UnitX, 1.1), lopsided));
        Assert.Equal(0.3f, SwingTwistLimit.Excess(Rotation.FromAxisAngle(Vector3.UnitX, 1.5), lopsided), 1e-5f);
        Assert.Equal(0.4f, SwingTwistLimit.Excess(Rotation.FromAxisAngle(Vector3.UnitY, -0.5), lopsided), 1e-5f);
    }
}
