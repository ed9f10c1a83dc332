using System;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>How far a hinge turns either way from rest, as cosines and sines: angles are bounded without an inverse function.</summary>
internal readonly struct FoldLimit
{
    private readonly double minCosine;
    private readonly double minSine;
    private readonly double maxCosine;
    private readonly double maxSine;

    public FoldLimit(AngleRange range)
    {
        PortableMath.SinCos(range.Min, out minSine, out minCosine);
        PortableMath.SinCos(range.Max, out maxSine, out maxCosine);
    }

    /// <summary>Brings an angle in −π..π, given by its cosine and sine, back towards the nearer end of the range if it is beyond.</summary>
    /// <param name="cosine">Of the angle.</param>
    /// <param name="sine">Of the angle.</param>
    /// <param name="tolerance">How far from that end it may stay, as the chord of the difference on the unit circle.</param>
    /// <returns>The chord by which it was beyond; 0 for none.</returns>
    public float Clamp(ref double cosine, ref double sine, float tolerance)
    {
        bool beyond = (sine < 0 && cosine < minCosine) || (sine > 0 && cosine < maxCosine);
        if (!beyond)
        {
            return 0f;
        }

        double endCosine = sine < 0 ? minCosine : maxCosine;
        double endSine = sine < 0 ? minSine : maxSine;
        double c = cosine - endCosine;
        double s = sine - endSine;
        double chord = Math.Sqrt((c * c) + (s * s));
        if (chord <= tolerance)
        {
            return (float)chord;
        }

        double fraction = tolerance / chord;
        cosine = endCosine + (c * fraction);
        sine = endSine + (s * fraction);
        double length = Math.Sqrt((cosine * cosine) + (sine * sine));
        if (fraction > 0 && length > 1e-6)
        {
            cosine /= length;
            sine /= length;
        }

        return (float)chord;
    }
}
