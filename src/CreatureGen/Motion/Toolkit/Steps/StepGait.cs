using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>A gait for the feet of a <see cref="LegStepper"/>: how long a cycle lasts, and what part of it feet are down.</summary>
public readonly struct StepGait
{
    /// <summary>Sets the gait.</summary>
    /// <param name="duty">Part of the cycle that a foot is down, 0.05 to 0.95: a walk has 0.6 or more, a run less than 0.5.</param>
    /// <param name="seconds">Of a cycle, above 0.</param>
    /// <exception cref="System.ArgumentOutOfRangeException">A number is outside its range or not a number.</exception>
    public StepGait(float duty, float seconds)
    {
        Finite.RequireWithin(duty, 0.05f, 0.95f, nameof(duty));
        Finite.RequireWithin(seconds, 1e-4f, 1e4f, nameof(seconds));
        Duty = duty;
        Seconds = seconds;
    }

    /// <summary>Part of the cycle that a foot is down.</summary>
    public float Duty { get; }

    /// <summary>Seconds of a cycle.</summary>
    public float Seconds { get; }
}
