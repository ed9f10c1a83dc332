using System;
using System.Numerics;

namespace CreatureGen.Maths;

/// <summary>
/// Exponential approach to a goal at a rate in s⁻¹, exact for any time step: two steps of half the time give what one whole step gives.
/// </summary>
/// <remarks>
/// <para>The solution of x′ = rate · (goal − x): x(t) = goal + (x₀ − goal) · e^(−rate · t). Moving a share rate · dt of the way each frame instead depends on the frame rate, and overshoots beyond rate · dt = 1.</para>
/// <para>Based on: WeaverDev, "Bonehead" (2018), for the damping and for <see cref="Follow(Vector3, Vector3, Vector3, float, float)"/>.</para>
/// </remarks>
public static class Damping
{
    // Below this, rate times time, the exponential series is exact in doubles where the quotients would cancel.
    private const double Small = 1e-4;

    /// <summary>The share of the distance to a goal that is left after some time: e^(−rate · seconds).</summary>
    /// <param name="rate">s⁻¹, not negative.</param>
    /// <param name="seconds">Not negative.</param>
    public static float Left(float rate, float seconds) => (float)PortableMath.Exp(-(double)rate * seconds);

    /// <summary>The rate in s⁻¹ at which a distance halves in the given time: ln 2 / seconds.</summary>
    public static float RateOfHalfLife(float seconds) => (float)(0.69314718055994530942 / seconds);

    /// <summary><paramref name="x"/> after some time on its way to <paramref name="goal"/>.</summary>
    public static float Approach(float x, float goal, float rate, float seconds) => goal + ((x - goal) * Left(rate, seconds));

    /// <summary><paramref name="x"/> after some time on its way to <paramref name="goal"/>.</summary>
    public static Vector3 Approach(Vector3 x, Vector3 goal, float rate, float seconds) => goal + ((x - goal) * Left(rate, seconds));

    /// <summary>The rotation after some time on its shorter way to <paramref name="goal"/>.</summary>
    public static Quaternion Approach(Quaternion x, Quaternion goal, float rate, float seconds) => Rotation.Slerp(goal, x, Left(rate, seconds));

    /// <summary>Time integral of <see cref="Left"/> from 0: (1 − e^(−rate · seconds)) / rate, or the seconds at rate 0. A velocity that fades from v to 0 covers v times this.</summary>
    public static float Integral(float rate, float seconds)
    {
        double x = (double)rate * seconds;
        double fraction = x < Small ? 1 - (x * (0.5 - (x * (1.0 / 6)))) : (1 - PortableMath.Exp(-x)) / x;
        return (float)(fraction * seconds);
    }

    /// <summary>Follows a goal that moved in a straight line during the step, where <see cref="Approach(float, float, float, float)"/> supposes that it was at its end all along.</summary>
    /// <param name="x">The follower at the beginning of the step.</param>
    /// <param name="goalBefore">The goal at the beginning of the step.</param>
    /// <param name="goal">The goal at its end.</param>
    /// <param name="rate">s⁻¹.</param>
    /// <param name="seconds">Not negative.</param>
    /// <remarks>With v = (goal − goalBefore) / seconds the solution is goal − v/rate + (x − goalBefore + v/rate) · e^(−rate · seconds); the follower trails a steady goal by v/rate.</remarks>
    public static float Follow(float x, float goalBefore, float goal, float rate, float seconds)
    {
        double left = PortableMath.Exp(-(double)rate * seconds);
        return (float)(goal + ((x - (double)goalBefore) * left) - (((double)goal - goalBefore) * Mean(rate, seconds, left)));
    }

    /// <inheritdoc cref="Follow(float, float, float, float, float)"/>
    public static Vector3 Follow(Vector3 x, Vector3 goalBefore, Vector3 goal, float rate, float seconds)
    {
        double left = PortableMath.Exp(-(double)rate * seconds);
        return goal + ((x - goalBefore) * (float)left) - ((goal - goalBefore) * (float)Mean(rate, seconds, left));
    }

    /// <summary>Mean of e^(−rate · t) over the step: (1 − left) / (rate · seconds).</summary>
    private static double Mean(float rate, float seconds, double left)
    {
        double x = (double)rate * seconds;
        return x < Small ? 1 - (x * (0.5 - (x * (1.0 / 6)))) : (1 - left) / x;
    }
}
