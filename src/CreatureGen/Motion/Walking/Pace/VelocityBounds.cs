using System;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;

namespace CreatureGen.Motion.Walking.Pace;

/// <summary>How quickly the motion of a body may change, by its build and its grip on the ground.</summary>
/// <remarks>
/// Based on: S. B. Williams et al., "Pitch then power: limitations to acceleration in quadrupeds" (2009); H. Tan and A. M. Wilson, "Grip and limb force limits to turning performance in competition horses" (2011).
/// </remarks>
/// <param name="Along">Metres per second, ahead and to the sides.</param>
/// <param name="Yaw">Radians per second.</param>
/// <param name="Aside">Most acceleration to a side in a turn, metres per second squared.</param>
internal readonly record struct VelocityBounds(SpeedBounds Along, SpeedBounds Yaw, float Aside)
{
    /// <summary>Accelerations, parts of gravity.</summary>
    private const float SpeedingUp = 0.6f;
    private const float Braking = 0.7f;
    private const float Turning = 0.6f;

    /// <summary>What of these pillars bear.</summary>
    private const float ColumnarFraction = 0.5f;

    /// <summary>Seconds of the lag, for a leg as long as gravity's acceleration in a second: of half a metre 0.15 s.</summary>
    private const float LagOfLeg = 0.664f;

    /// <summary>The rate of response, per second, for which that is.</summary>
    private const float UsualResponse = 4f;

    /// <summary>Least radius on which a body turns, leg lengths.</summary>
    private const float MinRadius = 0.5f;

    private const float SlowestTurning = 1.5f;
    private const float QuickestTurning = 12f;

    /// <summary>The bounds of a body.</summary>
    /// <param name="body">Gives legs and build.</param>
    /// <param name="settings">Give gravity, grip and response.</param>
    public static VelocityBounds Of(LeggedBody body, in MotionSettings settings)
    {
        float grip = settings.Gravity * settings.Walking.Traction * (body.Subject.Plan == BodyPlan.Columnar ? ColumnarFraction : 1f);
        float lag = LagOfLeg * UsualResponse * (float)Math.Sqrt(body.LegLength / settings.Gravity);
        float swing = Scalar.Clamp(Turning * grip / Math.Max(body.FarthestFoot, MinRadius * body.LegLength), SlowestTurning, QuickestTurning);
        return new VelocityBounds(
            new SpeedBounds(SpeedingUp * grip, Braking * grip, lag / settings.Walking.SpeedResponse),
            new SpeedBounds(swing, swing, lag / settings.Walking.YawResponse),
            Turning * grip);
    }
}
