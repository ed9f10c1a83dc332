using System;
using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Wings;

/// <summary>The outline of a thin wing as points, seen from above: x out from the shoulder and y to the front, in lengths of the wing. From the shoulder along the leading edge to the tip, and back along the trailing edge.</summary>
/// <remarks>Point k of the leading edge and the k-th from the end are joined by a line across the wing, so that an outline may run back on itself.</remarks>
internal sealed class ThinWingForm
{
    private readonly WingPoint[] points;

    /// <summary>Takes the points, an even number of them.</summary>
    public ThinWingForm(params (double X, double Y)[] outline)
    {
        points = Array.ConvertAll(outline, p => new WingPoint(p.X, p.Y));
        double least = double.MaxValue, most = double.MinValue;
        foreach (WingPoint p in points)
        {
            least = Math.Min(least, p.Y);
            most = Math.Max(most, p.Y);
        }

        Depth = most - least;
    }

    /// <summary>Number of lines across the wing.</summary>
    public int Rows => points.Length / 2;

    /// <summary>Extent from front to rear, in lengths.</summary>
    public double Depth { get; }

    /// <summary>The form of a style; null for one that follows from how broad the wing is.</summary>
    public static ThinWingForm? Of(ThinWingStyle style) => style switch
    {
        ThinWingStyle.DragonflyFore => DragonflyWing.Fore,
        ThinWingStyle.DragonflyHind => DragonflyWing.Hind,
        ThinWingStyle.ButterflyFore => ButterflyWing.Fore,
        ThinWingStyle.ButterflyHind => ButterflyWing.Hind,
        ThinWingStyle.MothFore => MothWing.Fore,
        ThinWingStyle.MothHind => MothWing.Hind,
        _ => null,
    };

    /// <summary>A point of a line across the wing.</summary>
    /// <param name="row">Number of the line from the shoulder.</param>
    /// <param name="share">0 at the leading edge, 1 at the trailing one.</param>
    public WingPoint At(int row, double share)
    {
        WingPoint lead = points[row];
        WingPoint trail = points[points.Length - 1 - row];
        return new WingPoint(Scalar.Lerp(lead.X, trail.X, share), Scalar.Lerp(lead.Y, trail.Y, share));
    }
}
