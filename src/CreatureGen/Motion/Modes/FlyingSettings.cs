using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>What can be set on a creature's way of flying. All are factors, 1 by default. On its legs a flier goes by <see cref="WalkingSettings"/>.</summary>
public sealed record FlyingSettings
{
    /// <summary>The defaults.</summary>
    public static FlyingSettings Default { get; } = new();

    /// <summary>How hard it speeds up and brakes; 0.25..4.</summary>
    public float SpeedResponse { get; init; } = 1f;

    /// <summary>How hard its flared wings slow it down, on top of that; 0..4. At 0 it glides out; to land it brakes in any case.</summary>
    public float Braking { get; init; } = 1f;

    /// <summary>How quickly it goes into turns and out of them; 0.25..4.</summary>
    public float YawResponse { get; init; } = 1f;

    /// <summary>Lean into turns; 0..2. At 1 gravity and the turn balance.</summary>
    public float Bank { get; init; } = 1f;

    /// <summary>Width of the wingbeat; 0.5..1.5.</summary>
    public float BeatAmplitude { get; init; } = 1f;

    /// <summary>Passes good settings.</summary>
    /// <exception cref="ArgumentException">A number is not finite or out of its range; the message says which.</exception>
    public void ThrowIfInvalid()
    {
        Finite.RequireWithin(SpeedResponse, 0.25f, 4f, nameof(SpeedResponse));
        Finite.RequireWithin(Braking, 0f, 4f, nameof(Braking));
        Finite.RequireWithin(YawResponse, 0.25f, 4f, nameof(YawResponse));
        Finite.RequireWithin(Bank, 0f, 2f, nameof(Bank));
        Finite.RequireWithin(BeatAmplitude, 0.5f, 1.5f, nameof(BeatAmplitude));
    }
}
