using System;

namespace CreatureGen.Motion.Toolkit.Chains;

/// <summary>Checks at the door: what comes in is finite, and time goes forward in steps that are not too long.</summary>
internal static class StepCheck
{
    /// <summary>Longest step of time, seconds; what is longer counts as this much: after a pause the motion goes on where it was.</summary>
    public const double LongestStep = 0.25;

    /// <summary>Passes a step of time.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is negative or not finite.</exception>
    public static double Step(float dt)
    {
        if (!(dt >= 0f) || float.IsInfinity(dt))
        {
            throw new ArgumentOutOfRangeException(nameof(dt), dt, "expected finite seconds, not negative");
        }

        return Math.Min(dt, LongestStep);
    }

    /// <summary>Passes a finite number.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is not finite.</exception>
    public static double Finite(float value, string name)
    {
        if (float.IsNaN(value) || float.IsInfinity(value))
        {
            throw new ArgumentOutOfRangeException(name, value, "expected a finite number");
        }

        return value;
    }
}
