using System;
using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Fins;

/// <summary>The outline of a fin on the midline: its height over its base, in heights, and how far its rays lie over the ends of the base.</summary>
internal sealed class MidlineFin
{
    private readonly (double X, double Y)[] outline;

    /// <summary>Takes points from the front of the base, 0, to its rear, 1, the highest 1 high.</summary>
    public MidlineFin(params (double X, double Y)[] outline) => this.outline = outline;

    /// <summary>How far the foremost ray leans back at its tip and the rearmost hangs over, in lengths of the base; null where rays lean as the fin is swept.</summary>
    public (double Front, double Rear)? Overhang { get; init; }

    /// <summary>The outline of a style; null for sails, sharks' and spiny fins.</summary>
    public static MidlineFin? Of(FinStyle style) => style switch
    {
        FinStyle.Tuna => TunaFin.Midline,
        FinStyle.Carp => CarpFin.Midline,
        FinStyle.Veil => VeilFin.Midline,
        FinStyle.Ray => RayFin.Midline,
        _ => null,
    };

    /// <summary>The height over a point of the base.</summary>
    public double HeightAt(double u)
    {
        int i = 1;
        while (i < outline.Length - 1 && u > outline[i].X)
        {
            i++;
        }

        ((double x0, double y0), (double x1, double y1)) = (outline[i - 1], outline[i]);
        return Scalar.Lerp(y0, y1, Scalar.Clamp((u - x0) / Math.Max(x1 - x0, 1e-9), 0, 1));
    }
}
