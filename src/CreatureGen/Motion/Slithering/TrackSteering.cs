using CreatureGen.Maths;

namespace CreatureGen.Motion.Slithering;

/// <summary>How the head steers during one step: its way turns evenly from one heading to another, and the track swings about it.</summary>
internal readonly struct TrackSteering
{
    private readonly double from;
    private readonly double to;
    private readonly double slant;
    private readonly double alpha;
    private readonly double flatness;

    /// <summary>Takes headings of the way at the beginning and end of the step, the angle from the way to the track's middle line, and the swing of the track, radians; and how flat the swing is at its left end, 0..1.</summary>
    public TrackSteering(double from, double to, double slant, double alpha, double flatness)
    {
        this.flatness = flatness;
        this.from = from;
        this.to = to;
        this.slant = slant;
        this.alpha = alpha;
    }

    /// <summary>Heading of the way at a share of the step.</summary>
    public double CourseAngleAt(double fraction) => from + ((to - from) * fraction);

    /// <summary>Heading of the track at an arc length and a share of the step.</summary>
    public double HeadingAt(double arc, double fraction, double wavelength) =>
        CourseAngleAt(fraction) + slant + (alpha * Swing(arc / wavelength, flatness));

    /// <summary>The swing of the track, −1 to 1 at its left end, at a place in waves: a cosine, whose left end is straight over a third of the wave where flatness is 1.</summary>
    public static double Swing(double waves, double flatness)
    {
        double cosine = PortableMath.Cos(2 * PortableMath.Pi * waves);
        double squared = 1 - (cosine * cosine);

        // cos u is √(1 − s²) = 1 − ½s² − ⅛s⁴ − …, s = sin u: without these two terms it leaves 1 with the sixth power of u.
        return cosine + (flatness * squared * (0.5 + (0.125 * squared)));
    }

    /// <summary>Mean direction of a track over a wave, along (x) and across to the left (y) of its middle line.</summary>
    public static void Mean(double alpha, double flatness, out double along, out double across)
    {
        const int Samples = 16;
        along = 0;
        across = 0;
        for (int k = 0; k < Samples; k++)
        {
            PortableMath.SinCos(alpha * Swing((k + 0.5) / Samples, flatness), out double sine, out double cosine);
            along += cosine / Samples;
            across += sine / Samples;
        }
    }
}
