using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Modes;
using Xunit;

namespace CreatureGen.Tests.Motion.Modes;

public sealed class RootStepTests
{
    private static readonly RootPlace Here = new(new Vector3(1f, 2f, 3f), AxisRotation.Yaw(0.3f), 1f);

    [Theory]
    [InlineData(1f)]
    [InlineData(-1f)]
    public void What_was_asked_of_a_moved_creature_does_not_depend_on_the_sign_of_a_quaternion(float sign)
    {
        Quaternion turned = AxisRotation.Yaw(0.35f);
        var there = new RootPlace(Here.Position + Rotation.Rotate(Here.Rotation, new Vector3(0f, 0f, 0.2f)), new Quaternion(sign * turned.X, sign * turned.Y, sign * turned.Z, sign * turned.W), 1f);
        MotionInput asked = RootStep.Asked(Here, 0.1f, there, MotionMedium.Ground);
        Assert.Equal(2f, asked.Speed, 1e-4f);
        Assert.Equal(0.5f, asked.YawRate, 1e-3f);
    }

    /// <summary>The chord of an arc: half of the turn before the way.</summary>
    [Fact]
    public void A_step_that_turns_goes_along_the_chord_of_its_arc()
    {
        RootPlace there = RootStep.Advance(new RootPlace(Vector3.Zero, Quaternion.Identity, 2f), new BodyVelocity(new Vector3(0f, 0f, 1f), 1f), 0.5f);
        Assert.True(Vector3.Distance(new Vector3((float)PortableMath.Sin(0.25), 0f, (float)PortableMath.Cos(0.25)), there.Position) < 1e-5f, there.Position.ToString());
        Assert.Equal(0.5, Rotation.Angle(there.Rotation), 1e-4);
    }
}
