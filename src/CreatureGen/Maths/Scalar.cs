using System;
using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <summary>Small functions of one or a few numbers.</summary>
internal static class Scalar
{
    /// <summary>x².</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Square(float x) => x * x;

    /// <summary>Cubic ease x²(3 − 2x) of x clamped to 0..1: zero slope at both ends.</summary>
    public static double Smooth(double x)
    {
        x = Clamp(x, 0, 1);
        return x * x * (3 - (2 * x));
    }

    /// <summary>Cubic ease x²(3 − 2x) of x clamped to 0..1: zero slope at both ends.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Smooth(float x)
    {
        x = x < 0f ? 0f : x > 1f ? 1f : x;
        return x * x * (3f - (2f * x));
    }

    /// <summary>Quintic ease x³(10 − 15x + 6x²) of x clamped to 0..1: no jump of speed or acceleration at either end.</summary>
    public static double Smoother(double x)
    {
        x = Clamp(x, 0, 1);
        return x * x * x * (10 + (x * ((6 * x) - 15)));
    }

    /// <inheritdoc cref="Smoother(double)"/>
    public static float Smoother(float x)
    {
        x = Clamp(x, 0f, 1f);
        return x * x * x * (10f + (x * ((6f * x) - 15f)));
    }

    /// <summary>The value between <paramref name="min"/> and <paramref name="max"/> nearest to <paramref name="x"/>.</summary>
    public static double Clamp(double x, double min, double max) => x < min ? min : x > max ? max : x;

    /// <summary>The value between <paramref name="min"/> and <paramref name="max"/> nearest to <paramref name="x"/>.</summary>
    public static float Clamp(float x, float min, float max) => x < min ? min : x > max ? max : x;

    /// <summary>A number that comes ever slower to a most on both sides.</summary>
    /// <param name="x">Any finite number.</param>
    /// <param name="max">The most, above 0.</param>
    public static float ClampSoftly(float x, float max)
    {
        float part = x * x / Math.Max(max * max, 1e-12f);
        return x / (float)Math.Sqrt(Math.Sqrt(1f + (part * part)));
    }

    /// <summary>The value at <paramref name="t"/> of the way from <paramref name="a"/> to <paramref name="b"/>.</summary>
    public static double Lerp(double a, double b, double t) => a + ((b - a) * t);

    /// <summary>The value at <paramref name="t"/> of the way from <paramref name="a"/> to <paramref name="b"/>.</summary>
    public static float Lerp(float a, float b, float t) => a + ((b - a) * t);

    /// <summary>Degrees as radians.</summary>
    public static double Radians(double degrees) => degrees * (PortableMath.Pi / 180.0);

    /// <summary>Radians as degrees.</summary>
    public static double Degrees(double radians) => radians * (180.0 / PortableMath.Pi);
}
