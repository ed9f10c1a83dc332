using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>When and how the feet of a <see cref="LegStepper"/> step.</summary>
public readonly struct LegStepSettings
{
    /// <summary>Sets the steps.</summary>
    /// <param name="distance">Metres from its home at which a foot steps, above 0.</param>
    /// <param name="duration">Seconds of a step, above 0.</param>
    /// <param name="overshoot">How far beyond its home a foot comes down, in parts of <paramref name="distance"/>, 0 to 1: it lasts longer until the next step.</param>
    /// <param name="lift">Height of a step over the line from lift-off to touch-down, in parts of its length, 0 to 2.</param>
    /// <param name="reach">Metres above and below the home in which ground is looked for, above 0.</param>
    /// <exception cref="System.ArgumentOutOfRangeException">A number is outside its range or not a number.</exception>
    public LegStepSettings(float distance, float duration, float overshoot = 0.8f, float lift = 0.25f, float reach = 2f)
    {
        Finite.RequireWithin(distance, 1e-6f, 1e6f, nameof(distance));
        Finite.RequireWithin(duration, 1e-4f, 1e4f, nameof(duration));
        Finite.RequireWithin(overshoot, 0f, 1f, nameof(overshoot));
        Finite.RequireWithin(lift, 0f, 2f, nameof(lift));
        Finite.RequireWithin(reach, 1e-6f, 1e6f, nameof(reach));
        Distance = distance;
        Duration = duration;
        Overshoot = overshoot;
        Lift = lift;
        Reach = reach;
    }

    /// <summary>Metres from its home at which a foot steps.</summary>
    public float Distance { get; }

    /// <summary>Seconds of a step.</summary>
    public float Duration { get; }

    /// <summary>How far beyond its home a foot comes down, in parts of <see cref="Distance"/>.</summary>
    public float Overshoot { get; }

    /// <summary>Height of a step, in parts of its length.</summary>
    public float Lift { get; }

    /// <summary>Metres above and below the home in which ground is looked for.</summary>
    public float Reach { get; }
}
