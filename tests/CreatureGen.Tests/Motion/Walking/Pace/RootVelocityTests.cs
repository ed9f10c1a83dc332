using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Pace;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Pace;

public class RootVelocityTests
{
    private static readonly VelocityBounds bounds = new(new SpeedBounds(6f, 7f, 0.15f), new SpeedBounds(4f, 4f, 0.15f), 6f);

    [Fact]
    public void The_way_does_not_depend_on_the_steps_of_time()
    {
        Vector3 coarse = Go(20);
        Vector3 fine = Go(1000);
        Assert.True(Vector3.Distance(coarse, fine) < 3e-3f, $"{coarse} {fine}");

        static Vector3 Go(int steps)
        {
            RootVelocity velocity = Starting(1.5f, 0.6f);
            Vector3 at = Vector3.Zero;
            Quaternion heading = Quaternion.Identity;
            for (int i = 0; i < steps; i++)
            {
                at += Rotation.Rotate(heading, velocity.Advance(1f / steps, out float yaw));
                heading = Rotation.Multiply(heading, AxisRotation.Yaw(yaw));
            }

            return at;
        }
    }

    [Fact]
    public void A_steady_turn_goes_round_a_circle()
    {
        RootVelocity velocity = RootVelocity.At(2f, 0f, 1f);
        Vector3 half = velocity.Predict((float)PortableMath.Pi, out float yaw);
        Assert.Equal((float)PortableMath.Pi, yaw, 4);
        Assert.True(Vector3.Distance(half, new Vector3(4f, 0f, 0f)) < 1e-4f);
    }

    [Fact]
    public void What_is_foretold_is_what_comes()
    {
        RootVelocity velocity = Starting(3f, 0f);
        Vector3 foretold = velocity.Predict(0.7f, out _);
        float speed = velocity.SpeedAfter(0.7f);
        float way = 0f;
        for (int i = 0; i < 70; i++)
        {
            way += velocity.Advance(0.01f, out _).Z;
        }

        Assert.Equal(foretold.Z, way, 4);
        Assert.Equal(speed, velocity.Speed, 4);
    }

    [Theory]
    [InlineData(0f, 3f)]
    [InlineData(3f, 0f)]
    [InlineData(3f, -2f)]
    [InlineData(-1f, 0.2f)]
    public void Speed_changes_by_no_more_than_its_bounds_without_a_jump_of_acceleration_and_comes_to_its_goal(float from, float to)
    {
        const float Step = 1f / 480f;
        var along = new SpeedBounds(6f, 7f, 0.15f);
        IntendedSpeed speed = IntendedSpeed.At(from);
        speed.Ask(to);
        float before = 0f;
        for (int i = 0; i < 3 * 480; i++)
        {
            float last = speed.Speed;
            speed.Advance(Step, along);
            float acceleration = (speed.Speed - last) / Step;
            Assert.InRange(Math.Abs(acceleration), 0f, 7.001f);
            Assert.InRange(Math.Abs(acceleration - before), 0f, (1.01f * 13f * Step / along.Lag) + 1e-2f);
            Assert.InRange(speed.Speed, Math.Min(from, to) - 1e-4f, Math.Max(from, to) + 1e-4f);
            before = acceleration;
        }

        Assert.True(speed.IsSteady);
        Assert.Equal(to, speed.Speed);
    }

    [Fact]
    public void Left_and_right_are_alike()
    {
        Vector3 left = Starting(2f, 1f).Predict(0.8f, out float toLeft);
        Vector3 right = Starting(2f, -1f).Predict(0.8f, out float toRight);
        Assert.Equal(toLeft, -toRight);
        Assert.Equal(left.X, -right.X);
        Assert.Equal(left.Z, right.Z);
    }

    [Fact]
    public void Turns_are_as_sharp_as_the_grip_allows_at_the_speed()
    {
        var velocity = RootVelocity.At(4f, 0f, 0f);
        velocity.Bounds = bounds;
        velocity.Ask(4f, 0f, 3f);
        velocity.Advance(5f, out _);
        Assert.Equal(1.5f, velocity.Turn, 4);
    }

    private static RootVelocity Starting(float speed, float turn)
    {
        var velocity = new RootVelocity { Bounds = bounds };
        velocity.Ask(speed, 0f, turn);
        return velocity;
    }
}
