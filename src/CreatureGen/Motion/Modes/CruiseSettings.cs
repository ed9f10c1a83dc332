using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>What can be set on going through air and through water alike. All are factors, 1 by default.</summary>
public abstract record CruiseSettings
{
    private protected CruiseSettings()
    {
    }

    /// <summary>How hard it speeds up and brakes; 0.25..4.</summary>
    public float SpeedResponse { get; init; } = 1f;

    /// <summary>How hard flared wings or fins slow it down, on top of that; 0..4. At 0 it glides out; to land a flier brakes in any case.</summary>
    public float Braking { get; init; } = 1f;

    /// <summary>How quickly it goes into turns and out of them; 0.25..4.</summary>
    public float YawResponse { get; init; } = 1f;

    /// <summary>Lean into turns; 0..2. At 1 gravity and the turn of a flier balance; in water, fish stay nearly upright whatever it is, whales and turtles bank.</summary>
    public float Bank { get; init; } = 1f;

    /// <summary>Width of the beat of wings, 0.5..1.5, or of tail, flukes or flippers, 0.3..1.5.</summary>
    public float BeatAmplitude { get; init; } = 1f;

    private protected void ThrowIfInvalid(float minBeat)
    {
        Finite.RequireWithin(SpeedResponse, 0.25f, 4f, nameof(SpeedResponse));
        Finite.RequireWithin(Braking, 0f, 4f, nameof(Braking));
        Finite.RequireWithin(YawResponse, 0.25f, 4f, nameof(YawResponse));
        Finite.RequireWithin(Bank, 0f, 2f, nameof(Bank));
        Finite.RequireWithin(BeatAmplitude, minBeat, 1.5f, nameof(BeatAmplitude));
    }
}
