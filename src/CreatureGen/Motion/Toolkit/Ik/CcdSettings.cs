using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>How hard <see cref="CcdIk"/> tries.</summary>
public readonly struct CcdSettings
{
    /// <summary>Sets the effort.</summary>
    /// <param name="rounds">Most passes over the chain, at least 1.</param>
    /// <param name="tolerance">Share of the chain's length within which the target counts as reached; above 0.</param>
    /// <param name="maxTurn">Radians that a joint turns in one pass at most, above 0; small turns spread the bend over the chain.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is outside its range or not a number.</exception>
    public CcdSettings(int rounds, float tolerance = 1e-3f, float maxTurn = 0.6f)
    {
        if (rounds < 1)
        {
            throw new ArgumentOutOfRangeException(nameof(rounds), FormattableString.Invariant($"{rounds} rounds; expected at least 1"));
        }

        Finite.RequireWithin(tolerance, 1e-7f, 1f, nameof(tolerance));
        Finite.RequireWithin(maxTurn, 1e-4f, (float)PortableMath.Pi, nameof(maxTurn));
        Rounds = rounds;
        Tolerance = tolerance;
        MaxTurn = maxTurn;
    }

    /// <summary>16 passes, 0.1 % of the length, 0.6 rad at a time.</summary>
    public static CcdSettings Default { get; } = new(16);

    /// <summary>Most passes over the chain.</summary>
    public int Rounds { get; }

    /// <summary>Share of the chain's length within which the target counts as reached.</summary>
    public float Tolerance { get; }

    /// <summary>Radians that a joint turns in one pass at most.</summary>
    public float MaxTurn { get; }
}
