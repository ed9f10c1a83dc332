using System;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>How far a hinge turns either way from rest, as cosines and sines: angles are bounded without an inverse function.</summary>
internal readonly struct FoldLimit
{
    /// <summary>Cosine of the angle by which a turn may begin beyond the end towards which it goes, 8°.</summary>
    private const double Beyond = 0.99;

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
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float Clamp(ref double cosine, ref double sine, float tolerance)
    {
        bool beyond = (sine < 0 && cosine < minCosine) || (sine > 0 && cosine < maxCosine);
        return beyond ? Approach(sine < 0, ref cosine, ref sine, tolerance) : 0f;
    }

    /// <summary>Stops a turn from an angle within the range to another, by the shorter way, at the end of the range on that way, even if the other angle is within it too.</summary>
    /// <param name="fromCosine">Of the angle within the range.</param>
    /// <param name="fromSine">Of the angle within the range.</param>
    /// <param name="cosine">Of the other angle.</param>
    /// <param name="sine">Of the other angle.</param>
    /// <param name="tolerance">How far beyond that end it may go, as the chord of the difference on the unit circle.</param>
    public void Stop(double fromCosine, double fromSine, ref double cosine, ref double sine, float tolerance)
    {
        double turn = (sine * fromCosine) - (cosine * fromSine);
        bool down = turn < 0;
        double endCosine = down ? minCosine : maxCosine;
        double endSine = down ? minSine : maxSine;
        double roomCosine = (endCosine * fromCosine) + (endSine * fromSine);
        double roomSine = (endSine * fromCosine) - (endCosine * fromSine);

        // Where the sine of what is left up to the end is on the other side, that is more than half a turn, or less than nothing.
        bool half = down ? roomSine > 0 : roomSine < 0;
        bool beyond = half ? roomCosine > Beyond : (cosine * fromCosine) + (sine * fromSine) < roomCosine;
        if (beyond)
        {
            Approach(down, ref cosine, ref sine, tolerance);
        }
    }

    /// <summary>Brings an angle to an end of the range, but for a tolerance; says how far from it it was.</summary>
    private float Approach(bool down, ref double cosine, ref double sine, float tolerance)
    {
        double endCosine = down ? minCosine : maxCosine;
        double endSine = down ? minSine : maxSine;
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
