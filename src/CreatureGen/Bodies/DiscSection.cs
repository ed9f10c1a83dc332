using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>The sections of a body whose flanks are drawn out to wings, as those of rays are: a domed middle that goes over into thin wings, whose edge bows ahead and is rippled. Straight from ridge to edge they are a tent.</summary>
internal sealed class DiscSection
{
    // Half width of a section in mean half heights from which on it is a disc's, and over which it becomes one.
    private const double Broad = 1.7;
    private const double Broadening = 2.6;

    // The dome: its thickness in spans that discs are drawn to and how far, how much of it is above the spine and below against what is told, how far it reaches to the side in half widths, and what of its height the wings have.
    private const double Thickness = 0.165;
    private const double Drawn = 0.8;
    private const double Back = 1.1;
    private const double Belly = 0.87;
    private const double Dome = 0.62;
    private const double Wing = 0.22;

    // Parts of the greatest half width: how far the wings bow ahead in their middle, and how far the edge goes up and down; and how many waves there are from nose to tail, and how much a wave lies behind at the edge.
    private const double Bow = 0.11;
    private const double Ripple = 0.075;
    private const double Waves = 1.7;
    private const double Lag = 0.8;

    /// <summary>How much of the bend of the tips there is beside the dome: bent evenly, the wings are planks.</summary>
    private const double Stiff = 0.5;

    // The ring up to which a snout has no wings, and over how many they begin.
    private const double Snout = 3;
    private const double SnoutLength = 4;

    private readonly BodyShape shape;
    private readonly DiscBlueprint disc;
    private readonly double widest;
    private readonly double length;
    private readonly double thicker;

    /// <summary>Takes the sections of a body and how its edges lie.</summary>
    public DiscSection(BodyShape shape, DiscBlueprint disc)
    {
        this.shape = shape;
        this.disc = disc;
        int middle = 0;
        for (int i = 0; i < StationRing.TailFirst; i++)
        {
            middle = shape.Width[i] > shape.Width[middle] ? i : middle;
        }

        widest = shape.Width[middle];
        thicker = PortableMath.Pow(2 * widest * Thickness / (shape.Top[middle] + shape.Bottom[middle]), Drawn);
        length = shape.Arc[StationRing.TailFirst];
    }

    /// <summary>Gives a point of a section its height above the spine.</summary>
    /// <param name="ring">Its ring.</param>
    /// <param name="x">How far it is from the midline, metres.</param>
    /// <param name="y">How far above the spine it is on a section without wings, metres.</param>
    public float Height(int ring, float x, float y)
    {
        double half = y > 0 ? shape.Top[ring] : shape.Bottom[ring];
        double u = Math.Min(1, x / Math.Max(shape.Width[ring], 1e-6));
        double dome = Scalar.Lerp(Wing * Math.Sqrt(1 - (u * u)), 1, 1 - Scalar.Smooth(u / Dome));
        double height = half * thicker * (y > 0 ? Back : Belly) * dome;
        return (float)Scalar.Lerp(y, y > 0 ? height : -height, Winged(ring));
    }

    /// <summary>How far a point lies ahead of its section, metres.</summary>
    public float Along(float x)
    {
        double g = Math.Min(1, x / widest);
        return (float)((Bow * widest * 4 * g * g * (1 - g)) - (disc.Sweep * PortableMath.Pow(x, 1.35)));
    }

    /// <summary>How far a point is raised with the edge, metres.</summary>
    public float Lift(int ring, float x)
    {
        double g = Math.Min(1, x / widest);
        double wave = PortableMath.Sin((PortableMath.Tau * Waves * shape.Arc[ring] / length) - (Lag * g));
        return (float)((disc.Curl * PortableMath.Pow(x, 1.8) * Scalar.Lerp(Stiff, 1, g * g)) + (Ripple * widest * g * g * wave));
    }

    /// <summary>How far a section is a disc's, 0..1: not where the mouth is, whose corners would come through the skin of thin wings.</summary>
    private double Winged(int ring) => Scalar.Smooth((ring - Snout) / SnoutLength) * Scalar.Smooth(((2 * shape.Width[ring] / (shape.Top[ring] + shape.Bottom[ring])) - Broad) / Broadening);
}
