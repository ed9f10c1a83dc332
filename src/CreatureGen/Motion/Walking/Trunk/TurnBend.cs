using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Pace;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>The bend of a trunk into a turn: it follows the arc on which the body goes, with a lag.</summary>
internal struct TurnBend
{
    /// <summary>How quickly the trunk bends, per second.</summary>
    private const float Rate = 4f;

    /// <summary>Part of the angle of the arc that is under the trunk.</summary>
    private const float ArcFraction = 0.7f;

    /// <summary>Most that it bends, radians.</summary>
    private const float Max = 0.5f;

    /// <summary>Part of a walking speed below which an arc is no narrower.</summary>
    private const float SlowestFraction = 0.35f;

    /// <summary>How far an end of the trunk is aside of the other from which on feet step after it, leg lengths.</summary>
    private const float BentWay = 0.1f;

    private CriticallyDampedSpring spring;

    /// <summary>Radians.</summary>
    public readonly float Angle => (float)spring.Value;

    /// <summary>Whether the trunk has so far to go until it is straight that it takes its hips away from their feet.</summary>
    /// <param name="body">Gives its length.</param>
    public readonly bool IsBent(LeggedBody body) => Math.Abs(Angle) * body.TrunkLength > BentWay * body.LegLength;

    /// <summary>Follows the turn.</summary>
    /// <param name="body">Gives the length of the trunk.</param>
    /// <param name="velocity">How it goes.</param>
    /// <param name="gravity">Metres per second squared.</param>
    /// <param name="balance">The angle to the inside at which the turn would be in balance, radians.</param>
    /// <param name="dt">Seconds.</param>
    public void Follow(LeggedBody body, in RootVelocity velocity, float gravity, float balance, float dt)
    {
        float walking = (float)Math.Sqrt(0.12f * gravity * body.LegLength);
        float arc = velocity.Turn / Math.Max(Math.Abs(velocity.Speed), SlowestFraction * walking) * body.TrunkLength;
        spring.Step(Scalar.Clamp((arc * ArcFraction) + (balance * body.Traits.FastBend), -Max, Max), Rate, dt);
    }
}
