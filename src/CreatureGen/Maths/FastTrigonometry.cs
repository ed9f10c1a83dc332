using System;
using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <summary>
/// Sines, cosines and angles in single precision, for code that runs for every joint of every frame: short polynomials for small angles, <see cref="PortableMath"/> for the others. Within 2 ulp of either.
/// </summary>
internal static class FastTrigonometry
{
    private const float QuarterPi = 0.7853982f;

    /// <summary>Tangent up to which the polynomial of the angle goes.</summary>
    private const float Flat = 0.5f;

    // Interpolation at Chebyshev's nodes on 0..(π/4)² in the squared angle, and on 0..1/4 in the squared tangent: (sin x / x − 1) / x², (cos x − 1 + x²/2) / x⁴ and (atan t / t − 1) / t².
    private const float S0 = -0.166666647f;
    private const float S1 = 0.00833274827f;
    private const float S2 = -0.000195878909f;

    private const float C0 = 0.0416666647f;
    private const float C1 = -0.0013888303f;
    private const float C2 = 2.45479419e-05f;

    private const float A0 = -0.333333244f;
    private const float A1 = 0.199982119f;
    private const float A2 = -0.14227204f;
    private const float A3 = 0.104227162f;
    private const float A4 = -0.0558166278f;

    /// <summary>Sine and cosine of an angle in radians.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void SinCos(float angle, out float sine, out float cosine)
    {
        if (Math.Abs(angle) <= QuarterPi)
        {
            Near(angle, out sine, out cosine);
            return;
        }

        PortableMath.SinCos(angle, out double s, out double c);
        sine = (float)s;
        cosine = (float)c;
    }

    /// <summary>Sine and cosine of an angle in turns; of many turns only what is left of the last counts.</summary>
    public static void OfTurns(float turns, out float sine, out float cosine)
    {
        float quarters = (float)Math.Round(4f * turns);
        Near((turns - (0.25f * quarters)) * (float)PortableMath.Tau, out float s, out float c);
        switch ((int)(quarters - (4f * (float)Math.Floor(0.25f * quarters))))
        {
            case 0:
                (sine, cosine) = (s, c);
                break;
            case 1:
                (sine, cosine) = (c, -s);
                break;
            case 2:
                (sine, cosine) = (-s, -c);
                break;
            default:
                (sine, cosine) = (-c, s);
                break;
        }
    }

    /// <summary>Angle of the point (run, rise), radians, −π..π.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Of(float rise, float run)
    {
        if (!(Math.Abs(rise) <= Flat * run) || run == 0f)
        {
            return (float)PortableMath.Atan2(rise, run);
        }

        float t = rise / run;
        float z = t * t;
        return t + (t * z * (A0 + (z * (A1 + (z * (A2 + (z * (A3 + (z * A4)))))))));
    }

    /// <summary>Angle whose sine is given, radians, −π/2..π/2; what is beyond −1..1 counts as the end.</summary>
    public static float OfSine(float sine) => Of(sine, (float)Math.Sqrt(Math.Max((1f - sine) * (1f + sine), 0f)));

    /// <summary>Up to π/4.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Near(float x, out float sine, out float cosine)
    {
        float z = x * x;
        sine = x + (x * z * (S0 + (z * (S1 + (z * S2)))));
        cosine = 1f - (0.5f * z) + (z * z * (C0 + (z * (C1 + (z * C2)))));
    }
}
