using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Footsteps;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Footsteps;

public class RootVelocityTests
{
    [Fact]
    public void The_way_does_not_depend_on_the_steps_of_time()
    {
        Vector3 coarse = Go(10);
        Vector3 fine = Go(1000);
        Assert.True(Vector3.Distance(coarse, fine) < 2e-3f, $"{coarse} {fine}");

        static Vector3 Go(int steps)
        {
            var velocity = new RootVelocity { GoalSpeed = 1.5f, GoalTurn = 0.6f, Rate = 4f };
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
        var velocity = new RootVelocity { Speed = 2f, GoalSpeed = 2f, Turn = 1f, GoalTurn = 1f, Rate = 4f };
        Vector3 half = velocity.Predict((float)PortableMath.Pi, out float yaw);
        Assert.Equal((float)PortableMath.Pi, yaw, 4);
        Assert.True(Vector3.Distance(half, new Vector3(4f, 0f, 0f)) < 1e-4f);
    }
}
