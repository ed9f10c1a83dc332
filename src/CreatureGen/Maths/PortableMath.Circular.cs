using System;
using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <content>Sine and cosine.</content>
internal static partial class PortableMath
{
    private const double QuarterPi = 0.7853981633974483;

    // Minimax polynomials (Remez exchange) on 0..(π/4)² in the squared angle: (sin x / x − 1) / x² and (cos x − 1 + x²/2) / x⁴.
    private const double S0 = -0.16666666666666666;
    private const double S1 = 0.008333333333333323;
    private const double S2 = -0.00019841269841254784;
    private const double S3 = 2.7557319214057226e-06;
    private const double S4 = -2.5052104879829926e-08;
    private const double S5 = 1.6058362902781687e-10;
    private const double S6 = -7.578527075554861e-13;

    private const double C0 = 0.041666666666666595;
    private const double C1 = -0.001388888888887304;
    private const double C2 = 2.4801587288841526e-05;
    private const double C3 = -2.75573141762741e-07;
    private const double C4 = 2.0875700420410854e-09;
    private const double C5 = -1.1358514163604317e-11;

    /// <summary>Sine of an angle in radians, within 0.85 ulp for every finite angle; infinities give NaN.</summary>
    public static double Sin(double x)
    {
        if (Math.Abs(x) <= QuarterPi)
        {
            return Math.Abs(x) < TinyArgument ? x : SineNear(x, 0);
        }

        if (!(Math.Abs(x) <= double.MaxValue))
        {
            return double.NaN;
        }

        int quarters = AngleReduction.Quarters(x, out double left, out double rest);
        double value = (quarters & 1) == 0 ? SineNear(left, rest) : CosineNear(left, rest);
        return (quarters & 2) == 0 ? value : -value;
    }

    /// <summary>Cosine of an angle in radians, within 0.85 ulp for every finite angle; infinities give NaN.</summary>
    public static double Cos(double x)
    {
        if (Math.Abs(x) <= QuarterPi)
        {
            return CosineNear(x, 0);
        }

        if (!(Math.Abs(x) <= double.MaxValue))
        {
            return double.NaN;
        }

        int quarters = AngleReduction.Quarters(x, out double left, out double rest);
        double value = (quarters & 1) == 0 ? CosineNear(left, rest) : SineNear(left, rest);
        return ((quarters + 1) & 2) == 0 ? value : -value;
    }

    /// <summary>Sine and cosine of an angle in radians, the same bits as <see cref="Sin"/> and <see cref="Cos"/> in less time.</summary>
    public static void SinCos(double x, out double sine, out double cosine)
    {
        if (Math.Abs(x) <= QuarterPi)
        {
            sine = Math.Abs(x) < TinyArgument ? x : SineNear(x, 0);
            cosine = CosineNear(x, 0);
            return;
        }

        if (!(Math.Abs(x) <= double.MaxValue))
        {
            sine = cosine = double.NaN;
            return;
        }

        int quarters = AngleReduction.Quarters(x, out double left, out double rest);
        double s = SineNear(left, rest);
        double c = CosineNear(left, rest);
        if ((quarters & 1) != 0)
        {
            (s, c) = (c, s);
        }

        sine = (quarters & 2) == 0 ? s : -s;
        cosine = ((quarters + 1) & 2) == 0 ? c : -c;
    }

    /// <summary>Sine of x + rest, |x| up to π/4.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double SineNear(double x, double rest)
    {
        double z = x * x;
        double w = z * z;
        double p = (S0 + (z * S1)) + (w * ((S2 + (z * S3)) + (w * ((S4 + (z * S5)) + (w * S6)))));
        return x + ((x * z * p) + (rest - (0.5 * z * rest)));
    }

    /// <summary>Cosine of x + rest, |x| up to π/4.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double CosineNear(double x, double rest)
    {
        double z = x * x;
        double w = z * z;
        double p = (C0 + (z * C1)) + (w * ((C2 + (z * C3)) + (w * (C4 + (z * C5)))));
        double half = 0.5 * z;
        double near = 1.0 - half;
        return near + (((1.0 - near) - half) + ((w * p) - (x * rest)));
    }
}
