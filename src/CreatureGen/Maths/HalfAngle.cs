using System;

namespace CreatureGen.Maths;

/// <summary>Half angles without the angles.</summary>
internal static class HalfAngle
{
    /// <summary>Cosine and sine of half an angle in −π..π from those of the angle, which need not be exact to the last digits.</summary>
    public static void Of(double cosine, double sine, out double halfCosine, out double halfSine)
    {
        double c = Math.Sqrt(Math.Max(0, 0.5 * (1 + cosine)));
        double s = Math.Sqrt(Math.Max(0, 0.5 * (1 - cosine)));

        // The smaller of the two roots has lost its digits; the sine gives them back.
        if (c > s)
        {
            halfCosine = c;
            halfSine = 0.5 * sine / c;
        }
        else
        {
            halfCosine = 0.5 * Math.Abs(sine) / s;
            halfSine = sine < 0 ? -s : s;
        }
    }
}
