using System;

namespace CreatureGen.Motion.Toolkit.Chains;

/// <summary>Bounds and parts of numbers without a kink, so that what depends on them has no jump of speed.</summary>
internal static class Curve
{
    /// <summary>Half width of the rounding of <see cref="Positive"/> at 0.</summary>
    private const double Rounding = 0.1;

    /// <summary>The number itself when it is small; it comes ever nearer to ±<paramref name="max"/> and never reaches it.</summary>
    public static double Bounded(double x, double max) => x / Math.Sqrt(1 + (x * x / (max * max)));

    /// <summary>About the number where it is positive and about 0 where it is negative; exactly 0 at 0.</summary>
    public static double Positive(double x) => 0.5 * (x + Math.Sqrt((x * x) + (Rounding * Rounding)) - Rounding);

    /// <summary>One or the other or both, 0..1.</summary>
    public static double Either(double a, double b) => 1 - ((1 - a) * (1 - b));
}
