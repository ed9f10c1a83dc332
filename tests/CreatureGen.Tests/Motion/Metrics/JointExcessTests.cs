using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Metrics;

public sealed class JointExcessTests
{
    private static readonly JointLimit limit = new(new AngleRange(-0.2f, 1.2f), new AngleRange(-0.5f, 0.3f), new AngleRange(-0.1f, 0.4f));

    [Theory]
    [InlineData(1.0, 0, 0, 0)]
    [InlineData(1.3, 0, 0, 0.1)]
    [InlineData(-0.3, 0, 0, 0.1)]
    [InlineData(0, 0.9, 0, 0.6)]
    [InlineData(0, -0.4, 0, 0)]
    [InlineData(0, 0, 0.5, 0.1)]
    [InlineData(0, 0, -0.4, 0.3)]
    public void Along_an_axis_it_is_the_angle_past_the_end_of_the_range(double swingX, double swingZ, double twist, double expected)
    {
        Quaternion rotation = Rotation.Multiply(Rotation.FromAxisAngle(swingX != 0 ? Vector3.UnitX : Vector3.UnitZ, swingX + swingZ), Rotation.FromAxisAngle(Vector3.UnitY, twist));
        Assert.Equal(expected, JointExcess.Of(rotation, limit), 1e-5);
    }

    [Fact]
    public void A_hinge_has_no_room_aside()
    {
        var hinge = new JointLimit(new AngleRange(0f, 1f), new AngleRange(0f, 0f), new AngleRange(0f, 0f));
        Assert.Equal(0, JointExcess.Of(Rotation.FromAxisAngle(Vector3.UnitX, 0.7), hinge), 1e-5);
        Assert.Equal(0.25, JointExcess.Of(Rotation.FromAxisAngle(Vector3.UnitZ, 0.25), hinge), 1e-5);
        Assert.Equal(0.5, JointExcess.Of(Rotation.FromAxisAngle(Vector3.UnitX, 1.5), hinge), 1e-5);
        Assert.Equal(0.3, JointExcess.Of(Rotation.FromAxisAngle(Vector3.UnitX, 0.3), JointLimit.Fixed), 1e-5);
    }

    [Fact]
    public void It_agrees_with_the_limit_that_joints_are_kept_to()
    {
        RandomStream random = new Seed(5).Stream();
        for (int i = 0; i < 2000; i++)
        {
            var axis = Vec.Normalize(new Vector3((float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1), (float)random.Uniform(-1, 1)));
            Quaternion rotation = Rotation.FromAxisAngle(axis, random.Uniform(0, 1.6));
            double kept = SwingTwistLimit.Excess(rotation, limit);
            double measured = JointExcess.Of(rotation, limit);
            Assert.True(Math.Abs(kept - measured) < 1e-3 + (0.25 * Math.Max(kept, measured)), FormattableString.Invariant($"{rotation}: {measured} rad, kept by {kept}"));
            Assert.True(JointExcess.Of(SwingTwistLimit.Clamp(rotation, limit), limit) < 1e-4);
        }
    }
}
