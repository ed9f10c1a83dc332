using System;
using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <summary>Half angles without the angles.</summary>
internal static class HalfAngle
{
    /// <summary>Cosine and sine of half an angle in −π..π from those of the angle, which need not be exact to the last digits.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Of(double cosine, double sine, out double halfCosine, out double halfSine)
    {
        // Only the greater of the two roots has all its digits; the sine gives the other.
        if (cosine > 0)
        {
            halfCosine = Math.Sqrt(0.5 * (1 + cosine));
            halfSine = 0.5 * sine / halfCosine;
        }
        else
        {
            double s = Math.Sqrt(0.5 * (1 - cosine));
            halfCosine = 0.5 * Math.Abs(sine) / s;
            halfSine = sine < 0 ? -s : s;
        }
    }
}
