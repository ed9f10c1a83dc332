using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>How far a two-bone limb stretches and folds, as angles of its middle joint: 0 is straight, π is folded flat.</summary>
/// <remarks>
/// Near its full length L a limb's joint turns by 1/√(L − d) for each metre of the target: it snaps. So the limb never comes quite straight, and eases towards that:
/// beyond d_a it reaches d_a + δ(1 − e^(−(d − d_a)/δ)) with δ = d_max − d_a, whose value and slope go on from the identity at d_a and which never exceeds d_max.
/// Based on: the soft end of ozz-animation's two-bone solver (G. Blanc).
/// </remarks>
public readonly struct Reach
{
    // Stored so that the default value of the structure is Hard.
    private readonly double leastVersine;
    private readonly double mostBelowFlat;
    private readonly float easing;

    /// <summary>Sets the ends of the reach.</summary>
    /// <param name="leastBend">Radians at the middle joint that are always left; 0..π. 0.2 (12°) leaves 0.5 % of the length.</param>
    /// <param name="mostBend">Radians that the middle joint folds at most; more than the least, at most π.</param>
    /// <param name="easeFrom">Share of the greatest distance at which easing begins, 0..1; 1 for a hard end.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is outside its range or not a number.</exception>
    public Reach(float leastBend, float mostBend = 2.618f, float easeFrom = 0.968f)
    {
        Finite.RequireWithin(leastBend, 0f, (float)PortableMath.Pi, nameof(leastBend));
        Finite.RequireWithin(mostBend, leastBend, 3.1415928f, nameof(mostBend));
        Finite.RequireWithin(easeFrom, 0f, 1f, nameof(easeFrom));
        leastVersine = 1 - PortableMath.Cos(leastBend);
        mostBelowFlat = 1 + PortableMath.Cos(mostBend);
        easing = 1f - easeFrom;
    }

    /// <summary>Bends by 12° to 150°, easing over the last 3.2 % of the reach.</summary>
    public static Reach Default { get; } = new(0.2094f);

    /// <summary>Straight to folded flat, with a hard end; also the default value.</summary>
    public static Reach Hard { get; } = default;

    /// <summary>The distance that a limb of two bones takes up for a target at some distance.</summary>
    /// <param name="distance">From the root to the target, metres.</param>
    /// <param name="upper">Length of the upper bone, metres.</param>
    /// <param name="lower">Length of the lower bone, metres.</param>
    /// <param name="status">Which end of the reach is in the way.</param>
    /// <returns>Metres; never beyond the sum or within the difference of the bones.</returns>
    public double Limit(double distance, double upper, double lower, out IkStatus status)
    {
        double squares = (upper * upper) + (lower * lower);
        double product = 2 * upper * lower;
        double most = Math.Sqrt(Math.Max(0, squares + (product * (1 - leastVersine))));
        double least = Math.Sqrt(Math.Max(0, squares + (product * (mostBelowFlat - 1))));
        double from = Math.Max(most * (1 - easing), least);
        if (distance <= from)
        {
            status = distance < least ? IkStatus.TooNear : IkStatus.Reached;
            return Math.Max(distance, least);
        }

        status = distance > most ? IkStatus.TooFar : IkStatus.Softened;
        double width = most - from;
        return width > most * 1e-9 ? from + (width * (1 - PortableMath.Exp(-(distance - from) / width))) : Math.Min(distance, most);
    }
}
