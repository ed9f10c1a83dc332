using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Pace;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>How the head looks into a turn before the body is in it, and to the side to which the body steps. What a body will do changes at once where another turn is asked of it; a head does not.</summary>
internal struct TurnLook
{
    /// <summary>The head goes by the turn in so many seconds, of which the spring takes back a half, and looks as far into it as the body turns in so many.</summary>
    private const float Lead = 0.3f;
    private const float Look = 0.28f;

    /// <summary>How far it looks to the side to which it goes, parts of the angle of its way, and the speed, √(gℓ), below which that counts less.</summary>
    private const float Aside = 0.35f;
    private const float SlowAside = 0.1f;

    /// <summary>How quickly the head turns, per second.</summary>
    private const float Rate = 13f;

    /// <summary>Most that it looks aside, radians.</summary>
    private const float Max = 0.45f;

    /// <summary>Radians, and radians per second, below which it looks ahead again.</summary>
    private const double Ahead = 1e-5;

    private CriticallyDampedSpring spring;

    /// <summary>Yaw of the head, radians.</summary>
    public readonly float Angle => (float)spring.Value;

    /// <summary>Follows the turn.</summary>
    /// <param name="velocity">How the body goes.</param>
    /// <param name="unit">Square of the speed of creatures of its size, gℓ.</param>
    /// <param name="dt">Seconds.</param>
    public void Follow(in RootVelocity velocity, float unit, float dt)
    {
        float look = Look * velocity.TurnAfter(Lead);
        if (velocity.Sideways != 0f)
        {
            look += Aside * FastTrigonometry.Of(velocity.Sideways, Math.Abs(velocity.Speed) + (SlowAside * (float)Math.Sqrt(unit)));
        }

        if (look == 0f && Math.Abs(spring.Value) < Ahead && Math.Abs(spring.Rate) < Ahead)
        {
            spring = default;
            return;
        }

        spring.Step(Scalar.Clamp(look, -Max, Max), Rate, dt);
    }
}
