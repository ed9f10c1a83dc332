using System;
using CreatureGen.Maths;

namespace CreatureGen.Sounds;

/// <summary>Whose sounds they are.</summary>
public readonly record struct SoundSettings
{
    /// <summary>Takes settings.</summary>
    /// <param name="mass">Kilograms, 10⁻⁶ to 10⁶: heavy creatures sound lower and louder.</param>
    /// <param name="seed">No two steps sound quite alike; the same seed gives the same sounds.</param>
    /// <param name="rate">Samples per second, 8 000 to 192 000.</param>
    /// <exception cref="ArgumentException">A number is not finite or out of its range.</exception>
    public SoundSettings(float mass, ulong seed, int rate = 44_100)
    {
        Finite.RequireWithin(mass, 1e-6f, 1e6f, nameof(mass));
        if (rate is < 8_000 or > 192_000)
        {
            throw new ArgumentOutOfRangeException(nameof(rate), rate, "expected 8000 to 192000 samples per second");
        }

        Mass = mass;
        Seed = seed;
        Rate = rate;
    }

    /// <summary>Kilograms.</summary>
    public float Mass { get; }

    /// <summary>What makes no two steps sound alike.</summary>
    public ulong Seed { get; }

    /// <summary>Samples per second.</summary>
    public int Rate { get; }
}
