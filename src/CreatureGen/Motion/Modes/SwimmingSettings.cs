using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>What can be set on a creature's way of swimming. All are factors, 1 by default.</summary>
public sealed record SwimmingSettings
{
    /// <summary>The defaults.</summary>
    public static SwimmingSettings Default { get; } = new();

    /// <summary>How hard it speeds up and brakes; 0.25..4.</summary>
    public float SpeedResponse { get; init; } = 1f;

    /// <summary>How hard its fins slow it down, on top of that; 0..4. At 0 it glides out.</summary>
    public float Braking { get; init; } = 1f;

    /// <summary>How quickly it goes into turns and out of them; 0.25..4.</summary>
    public float YawResponse { get; init; } = 1f;

    /// <summary>Lean into turns; 0..2. Fish stay nearly upright whatever it is, whales and turtles bank.</summary>
    public float Bank { get; init; } = 1f;

    /// <summary>Width of the beat of tail, flukes or flippers; 0.3..1.5.</summary>
    public float BeatAmplitude { get; init; } = 1f;

    /// <summary>Passes good settings.</summary>
    /// <exception cref="ArgumentException">A number is not finite or out of its range; the message says which.</exception>
    public void ThrowIfInvalid()
    {
        Finite.RequireWithin(SpeedResponse, 0.25f, 4f, nameof(SpeedResponse));
        Finite.RequireWithin(Braking, 0f, 4f, nameof(Braking));
        Finite.RequireWithin(YawResponse, 0.25f, 4f, nameof(YawResponse));
        Finite.RequireWithin(Bank, 0f, 2f, nameof(Bank));
        Finite.RequireWithin(BeatAmplitude, 0.3f, 1.5f, nameof(BeatAmplitude));
    }
}
