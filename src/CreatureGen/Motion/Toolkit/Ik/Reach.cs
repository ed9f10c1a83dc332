using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;

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
    private readonly double minVersine;
    private readonly double maxBelowFlat;
    private readonly float easing;

    /// <summary>Sets the ends of the reach.</summary>
    /// <param name="minBend">Radians at the middle joint that are always left; 0..π. 0.2 (12°) leaves 0.5 % of the length.</param>
    /// <param name="maxBend">Radians that the middle joint folds at most; more than the least, at most π.</param>
    /// <param name="easeFrom">Share of the greatest distance at which easing begins, 0..1; 1 for a hard end.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is outside its range or not a number.</exception>
    public Reach(float minBend, float maxBend = (float)BendRange.Max, float easeFrom = (float)BendRange.EaseFrom)
    {
        Finite.RequireWithin(minBend, 0f, (float)PortableMath.Pi, nameof(minBend));
        Finite.RequireWithin(maxBend, minBend, 3.1415928f, nameof(maxBend));
        Finite.RequireWithin(easeFrom, 0f, 1f, nameof(easeFrom));
        minVersine = 1 - PortableMath.Cos(minBend);
        maxBelowFlat = 1 + PortableMath.Cos(maxBend);
        easing = 1f - easeFrom;
    }

    /// <summary>Bends by 12° to 150°, easing over the last 3.2 % of the reach.</summary>
    public static Reach Default { get; } = new((float)BendRange.Min);

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
        double max = Math.Sqrt(Math.Max(0, squares + (product * (1 - minVersine))));
        double min = Math.Sqrt(Math.Max(0, squares + (product * (maxBelowFlat - 1))));
        double from = Math.Max(max * (1 - easing), min);
        if (distance <= from)
        {
            status = distance < min ? IkStatus.TooNear : IkStatus.Reached;
            return Math.Max(distance, min);
        }

        status = distance > max ? IkStatus.TooFar : IkStatus.Softened;
        double width = max - from;
        return width > max * 1e-9 ? from + (width * (1 - PortableMath.Exp(-(distance - from) / width))) : Math.Min(distance, max);
    }
}
