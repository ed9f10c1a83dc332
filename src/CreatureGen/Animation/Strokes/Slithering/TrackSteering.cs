using CreatureGen.Maths;

namespace CreatureGen.Animation.Strokes.Slithering;

/// <summary>How the head steers during one step: its way turns evenly from one heading to another, and the track swings about it.</summary>
internal readonly struct TrackSteering
{
    private readonly double from;
    private readonly double to;
    private readonly double slant;
    private readonly double alpha;

    /// <summary>Takes headings of the way at the beginning and end of the step, the angle from the way to the track's middle line, and the swing of the track, radians.</summary>
    public TrackSteering(double from, double to, double slant, double alpha)
    {
        this.from = from;
        this.to = to;
        this.slant = slant;
        this.alpha = alpha;
    }

    /// <summary>Heading of the way at a share of the step.</summary>
    public double TravelAt(double share) => from + ((to - from) * share);

    /// <summary>Heading of the track at an arc length and a share of the step.</summary>
    public double HeadingAt(double arc, double share, double wavelength) =>
        TravelAt(share) + slant + (alpha * PortableMath.Cos(2 * PortableMath.Pi * arc / wavelength));
}
