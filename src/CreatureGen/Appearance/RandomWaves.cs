using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>Noise of a single wavelength: plane waves in well spread directions with random phases. Its zero set is a labyrinth.</summary>
/// <remarks>
/// Based on: M. V. Berry, "Regular and irregular semiclassical wavefunctions" (1977): a sum of plane waves of one wave number and random phases is a stationary random field.
/// What A. Turing's "The chemical basis of morphogenesis" (1952) grows to is such a field, cut at its mean.
/// </remarks>
internal sealed class RandomWaves
{
    private const int SimdKernels = 4;
    private const int Count = 3 * SimdKernels;

    // Adding and subtracting it rounds a number below 2²² to the nearest integer.
    private const float Rounding = 12582912f;

    // Steps of this share of a turn never come near an earlier one.
    private const double GoldenTurn = 0.38196601125010515;

    private static readonly Vector4 rounding = new(Rounding);
    private static readonly Vector4 fourth = new(34f / 9f);
    private static readonly Vector4 second = new(-44f / 9f);

    // The variance of a cosine is ½.
    private static readonly float height = (float)Math.Sqrt(2.0 / Count);

    /// <summary>Of four waves at a time: waves per unit of length along x, along y and along z, and the phases in waves.</summary>
    private readonly Vector4[] waves = new Vector4[Count];

    /// <summary>Draws the waves.</summary>
    /// <param name="frequency">Waves per unit of length.</param>
    /// <param name="salt">Which noise.</param>
    public RandomWaves(float frequency, int salt)
    {
        Span<float> x = stackalloc float[Count];
        Span<float> y = stackalloc float[Count];
        Span<float> z = stackalloc float[Count];
        Span<float> phase = stackalloc float[Count];
        double turn = LatticeHash.Unit(LatticeHash.Bits(Count, 0, 0, salt));
        for (int i = 0; i < Count; i++)
        {
            double rise = (i + LatticeHash.Unit(LatticeHash.Bits(i, 1, 0, salt))) / Count;
            double flat = Math.Sqrt(1 - (rise * rise)) * frequency;
            PortableMath.SinCos(PortableMath.Tau * (turn + (i * GoldenTurn)), out double sine, out double cosine);
            x[i] = (float)(flat * cosine);
            y[i] = (float)(rise * frequency);
            z[i] = (float)(flat * sine);
            phase[i] = LatticeHash.Unit(LatticeHash.Bits(i, 2, 0, salt));
        }

        for (int i = 0; i < Count; i += SimdKernels)
        {
            waves[i] = Four(x, i);
            waves[i + 1] = Four(y, i);
            waves[i + 2] = Four(z, i);
            waves[i + 3] = Four(phase, i);
        }
    }

    /// <summary>The noise at a point: mean 0, standard deviation 1.</summary>
    public float At(Vector3 point)
    {
        Vector4 sum = Vector4.Zero;
        for (int i = 0; i < waves.Length; i += SimdKernels)
        {
            Vector4 turns = (waves[i] * point.X) + (waves[i + 1] * point.Y) + (waves[i + 2] * point.Z) + waves[i + 3];

            // A cosine of period 1 within 0.001, after G. Wyvill's polynomial in the square of the distance.
            Vector4 t = turns - (turns + rounding - rounding);
            Vector4 s = t * t * 4f;
            sum += (((((s * (-8f / 9f)) + fourth) * s) + second) * s) + Vector4.One;
        }

        return ((sum.X + sum.Y) + (sum.Z + sum.W)) * height;
    }

    private static Vector4 Four(ReadOnlySpan<float> values, int first) => new(values[first], values[first + 1], values[first + 2], values[first + 3]);
}
