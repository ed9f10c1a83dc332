using System;

namespace CreatureGen.Motion;

/// <summary>What can be set on a creature's way of swimming.</summary>
public sealed record SwimmingSettings : CruiseSettings
{
    /// <summary>The defaults.</summary>
    public static SwimmingSettings Default { get; } = new();

    /// <summary>Passes good settings.</summary>
    /// <exception cref="ArgumentException">A number is not finite or out of its range; the message says which.</exception>
    public void ThrowIfInvalid() => ThrowIfInvalid(minBeat: 0.3f);
}
