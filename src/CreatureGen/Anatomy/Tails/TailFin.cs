using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Tails;

/// <summary>An upright fin at the end of a tail, as numbers: how it spreads from its stalk and where its rear edge lies.</summary>
internal sealed class TailFin
{
    private static readonly double[] stations = { 0, 0.25, 0.5, 0.75, 1 };

    /// <summary>Exponent of the spread along the stalk: above 1 narrow at first, then sudden.</summary>
    public double Spread { get; init; } = 1.3;

    /// <summary>Half heights of the upper and the lower half relative to the fin's size.</summary>
    public (double Upper, double Lower) Halves { get; init; } = (1, 0.95);

    /// <summary>How far the rear edge of the upper half lies behind its middle, at 0, ¼, ½, ¾ and all of the height, in sizes; negative ahead of it.</summary>
    public double[] Upper { get; init; } = { 0, 0, 0, 0, 0 };

    /// <summary>The same of the lower half.</summary>
    public double[] Lower { get; init; } = { 0, 0, 0, 0, 0 };

    /// <summary>The form of a style; null for all others than these.</summary>
    public static TailFin? Of(TailStyle style) => style switch
    {
        TailStyle.Lunate => LunateTail.Form,
        TailStyle.Heterocercal => HeterocercalTail.Form,
        TailStyle.Truncate => TruncateTail.Form,
        TailStyle.Veil => VeilTail.Form,
        _ => null,
    };

    /// <summary>Where the rear edge lies at a share of the height of its half, in sizes behind the middle.</summary>
    /// <param name="height">−1 at the lower tip, 1 at the upper one.</param>
    public double EdgeAt(double height)
    {
        double[] edge = height > 0 ? Upper : Lower;
        double[] slopes = new double[stations.Length];
        MonotoneCubic.Slopes(stations, edge, slopes);
        return MonotoneCubic.Evaluate(stations, edge, slopes, System.Math.Min(1, System.Math.Abs(height)));
    }
}
