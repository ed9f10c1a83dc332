using System;
using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Wings;

/// <summary>The outline of a family of wings as numbers, spread and seen from above: x out from the shoulder and y to the front, in spans of one wing.</summary>
/// <remarks>Drawn by eye to the shapes that the works named at each family describe, and checked by their aspect ratios.</remarks>
internal sealed record WingForm
{
    /// <summary>By how much more the blade of a wing hangs at rest than in flight, radians: from the front it is seen as a wing and not as the line of its edge.</summary>
    public const double RestIncidence = 0.34;

    /// <summary>The same of what is beyond the elbow against what is before it, radians.</summary>
    public const double OuterIncidence = 0.21;

    /// <summary>Where along the span the edges are given, 0..1, ascending.</summary>
    public double[] Stations { get; init; } = Array.Empty<double>();

    /// <summary>The leading edge at the stations.</summary>
    public double[] Lead { get; init; } = Array.Empty<double>();

    /// <summary>The trailing edge of feathers at the stations; none for membranes.</summary>
    public double[] Trail { get; init; } = Array.Empty<double>();

    /// <summary>Feathers along the trailing edge; 0 for a membrane.</summary>
    public int Feathers { get; init; }

    /// <summary>Depth of the notches between the outermost feathers, in depths of the wing.</summary>
    public double Slots { get; init; }

    /// <summary>Fingers in a membrane: points from the wrist to the tip of each.</summary>
    public WingPoint[][] Digits { get; init; } = Array.Empty<WingPoint[]>();

    /// <summary>Where a membrane's free edge is held, from the body to the tip.</summary>
    public WingPoint[] Tips { get; init; } = Array.Empty<WingPoint>();

    /// <summary>How far the free edge is drawn in between these, one less than <see cref="Tips"/>.</summary>
    public double[] Scallops { get; init; } = Array.Empty<double>();

    /// <summary>Length of one wing relative to that of a common one on the same body.</summary>
    public double Span { get; init; } = 1;

    /// <summary>Greatest depth, in spans.</summary>
    public double Depth { get; init; }

    /// <summary>The form of a style.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The style is none of a spread wing.</exception>
    public static WingForm Of(WingStyle style) => style switch
    {
        WingStyle.Bat => BatWing.Form,
        WingStyle.Feathered => HenWing.Form,
        WingStyle.Falcon => FalconWing.Form,
        WingStyle.Albatross => AlbatrossWing.Form,
        WingStyle.Hummingbird => HummingbirdWing.Form,
        WingStyle.Owl => OwlWing.Form,
        WingStyle.Dragon => DragonWing.Form,
        WingStyle.Pterosaur => PterosaurWing.Form,
        WingStyle.GlidingLizard => GlidingLizardWing.Form,
        WingStyle.FlyingFish => FlyingFishWing.Form,
        _ => throw new ArgumentOutOfRangeException(nameof(style), style, "expected the style of a spread wing"),
    };

    /// <summary>The leading edge at a share of the span.</summary>
    public double LeadAt(double s) => Evaluate(Lead, s);

    /// <summary>The trailing edge at a share of the span, without the notches between feathers.</summary>
    public double TrailAt(double s)
    {
        if (Feathers > 0)
        {
            return Evaluate(Trail, s);
        }

        int i = 1;
        while (i < Tips.Length - 1 && s > Tips[i].X)
        {
            i++;
        }

        WingPoint a = Tips[i - 1], b = Tips[i];
        double t = Scalar.Clamp((s - a.X) / (b.X - a.X), 0, 1);
        return Scalar.Lerp(a.Y, b.Y, t) + (Scallops[i - 1] * PortableMath.Sin(PortableMath.Pi * t));
    }

    /// <summary>How far a point is from the nearest finger, in spans.</summary>
    public double FromFingers(double x, double y)
    {
        double nearest = double.MaxValue;
        foreach (WingPoint[] digit in Digits)
        {
            for (int i = 1; i < digit.Length; i++)
            {
                nearest = Math.Min(nearest, FromSegment(digit[i - 1], digit[i], x, y));
            }
        }

        return nearest;
    }

    private static double FromSegment(WingPoint a, WingPoint b, double x, double y)
    {
        (double dx, double dy) = (b.X - a.X, b.Y - a.Y);
        double t = Scalar.Clamp((((x - a.X) * dx) + ((y - a.Y) * dy)) / ((dx * dx) + (dy * dy)), 0, 1);
        (double ox, double oy) = (x - a.X - (t * dx), y - a.Y - (t * dy));
        return Math.Sqrt((ox * ox) + (oy * oy));
    }

    private double Evaluate(double[] values, double s)
    {
        double[] slopes = new double[values.Length];
        MonotoneCubic.Slopes(Stations, values, slopes);
        return MonotoneCubic.Evaluate(Stations, values, slopes, s);
    }
}

/// <summary>A point of a spread wing, in spans.</summary>
/// <param name="X">Out from the shoulder.</param>
/// <param name="Y">To the front.</param>
internal readonly record struct WingPoint(double X, double Y);
