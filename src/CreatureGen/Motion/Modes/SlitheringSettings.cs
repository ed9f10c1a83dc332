using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>What can be set on a legless creature's way of crawling. Factors are 1 by default.</summary>
public sealed record SlitheringSettings
{
    /// <summary>The defaults.</summary>
    public static SlitheringSettings Default { get; } = new();

    /// <summary>How it crawls. A change passes down its body as it moves on.</summary>
    public SlitherGait Gait { get; init; }

    /// <summary>How quickly its speed follows what is asked, a factor; 0.25..4.</summary>
    public float SpeedResponse { get; init; } = 1f;

    /// <summary>Passes good settings.</summary>
    /// <exception cref="ArgumentException">A number is not finite or out of its range; the message says which.</exception>
    public void ThrowIfInvalid()
    {
        if (Gait is < SlitherGait.Undulating or > SlitherGait.Rectilinear)
        {
            throw new ArgumentOutOfRangeException(nameof(Gait), Gait, "expected Undulating, Sidewinding or Rectilinear");
        }

        Finite.RequireWithin(SpeedResponse, 0.25f, 4f, nameof(SpeedResponse));
    }
}
