using System;
using System.Collections.Generic;
using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Wings;

/// <summary>The outline of a thin wing as points, seen from above: x out from the shoulder and y to the front, in lengths of the wing. From the shoulder along the leading edge to the tip, and back along the trailing edge.</summary>
/// <remarks>Point k of the leading edge and the k-th from the end are joined by a line across the wing, so that an outline may run back on itself.</remarks>
internal sealed class ThinWingForm
{
    private readonly WingPoint[] points;

    /// <summary>Takes the points, an even number of them; between each two along the edges one more is laid on a curve through them, or the corners of broad wings would be seen.</summary>
    public ThinWingForm(params (double X, double Y)[] outline)
    {
        points = Rounded(Array.ConvertAll(outline, p => new WingPoint(p.X, p.Y)));
        double min = double.MaxValue, max = double.MinValue;
        foreach (WingPoint p in points)
        {
            min = Math.Min(min, p.Y);
            max = Math.Max(max, p.Y);
        }

        Depth = max - min;
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

    /// <summary>The points with those between them, but for the two at the tip. Based on: E. Catmull and R. Rom, "A class of local interpolating splines" (1974), at one half.</summary>
    private static WingPoint[] Rounded(WingPoint[] drawn)
    {
        int last = drawn.Length - 1;
        var points = new List<WingPoint>();
        for (int k = 0; k <= last; k++)
        {
            points.Add(drawn[k]);
            if (k < last && k != last / 2)
            {
                (WingPoint before, WingPoint a, WingPoint b, WingPoint after) = (drawn[Math.Max(0, k - 1)], drawn[k], drawn[k + 1], drawn[Math.Min(last, k + 2)]);
                points.Add(new WingPoint(Between(before.X, a.X, b.X, after.X), Between(before.Y, a.Y, b.Y, after.Y)));
            }
        }

        return points.ToArray();
    }

    private static double Between(double before, double a, double b, double after) => ((9 * (a + b)) - before - after) / 16;

    /// <summary>A point of a line across the wing.</summary>
    /// <param name="row">Number of the line from the shoulder.</param>
    /// <param name="fraction">0 at the leading edge, 1 at the trailing one.</param>
    public WingPoint At(int row, double fraction)
    {
        WingPoint lead = points[row];
        WingPoint trail = points[points.Length - 1 - row];
        return new WingPoint(Scalar.Lerp(lead.X, trail.X, fraction), Scalar.Lerp(lead.Y, trail.Y, fraction));
    }
}
