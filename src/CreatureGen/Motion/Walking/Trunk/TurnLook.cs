using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Pace;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>How the head looks into a turn before the body is in it. What a body will do changes at once where another turn is asked of it; a head does not.</summary>
internal struct TurnLook
{
    /// <summary>The head goes by the turn in so many seconds, of which the spring takes back a half, and looks as far into it as the body turns in so many.</summary>
    private const float Lead = 0.3f;
    private const float Look = 0.28f;

    /// <summary>How quickly the head turns, per second.</summary>
    private const float Rate = 13f;

    /// <summary>Most that it looks into a turn, radians.</summary>
    private const float Max = 0.45f;

    /// <summary>Radians, and radians per second, below which it looks ahead again.</summary>
    private const double Ahead = 1e-5;

    private CriticallyDampedSpring spring;

    /// <summary>Yaw of the head, radians.</summary>
    public readonly float Angle => (float)spring.Value;

    /// <summary>Follows the turn.</summary>
    /// <param name="velocity">How the body goes.</param>
    /// <param name="dt">Seconds.</param>
    public void Follow(in RootVelocity velocity, float dt)
    {
        float turn = velocity.TurnAfter(Lead);
        if (turn == 0f && Math.Abs(spring.Value) < Ahead && Math.Abs(spring.Rate) < Ahead)
        {
            spring = default;
            return;
        }

        spring.Step(Scalar.Clamp(Look * turn, -Max, Max), Rate, dt);
    }
}
