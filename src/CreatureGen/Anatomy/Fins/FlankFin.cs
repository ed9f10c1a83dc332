using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Fins;

/// <summary>The outline of a fin on the flank: how far its edges lie behind its axis, in lengths of the fin.</summary>
/// <remarks>After the ratios of Wainwright, Bellwood and Westneat, Environ. Biol. Fishes 65 (2002), drawn by eye.</remarks>
internal sealed class FlankFin
{
    /// <summary>Part of the sweep that the axis of a fin takes on whose outline is swept itself.</summary>
    private const double AxisOfSwept = 0.4;

    /// <summary>Where along the axis the edges are given.</summary>
    private static readonly double[] stations = { 0, 0.15, 0.3, 0.5, 0.7, 0.85, 0.95, 1 };

    private readonly MonotoneCurve lead;
    private readonly MonotoneCurve trail;

    /// <summary>Takes both edges at 0, 15, 30, 50, 70, 85, 95 and 100 % of the length.</summary>
    public FlankFin(double[] lead, double[] trail)
    {
        this.lead = new MonotoneCurve(stations, lead);
        this.trail = new MonotoneCurve(stations, trail);
        for (int i = 0; i < stations.Length; i++)
        {
            Depth = System.Math.Max(Depth, trail[i] - lead[i]);
        }
    }

    /// <summary>Greatest distance between the edges, in lengths.</summary>
    public double Depth { get; }

    /// <summary>The outline of a style; null for one that has none on the flank.</summary>
    public static FlankFin? Of(FinStyle style) => style switch
    {
        FinStyle.Paddle => PaddleFin.Flank,
        FinStyle.Shark => SharkFin.Flank,
        FinStyle.Tuna => TunaFin.Flank,
        FinStyle.Carp => CarpFin.Flank,
        FinStyle.Veil => VeilFin.Flank,
        FinStyle.Ray => RayFin.Flank,
        FinStyle.Flying => FlyingFin.Flank,
        _ => null,
    };

    /// <summary>Part of a fin's sweep that its axis takes on: all of it on a paddle, less where the outline is swept itself.</summary>
    public static double AxisSweep(FinStyle style) => style == FinStyle.Paddle || Of(style) is null ? 1 : AxisOfSwept;

    /// <summary>The leading edge behind the axis.</summary>
    public double LeadAt(double s) => lead.At(s);

    /// <summary>The trailing edge behind the axis.</summary>
    public double TrailAt(double s) => trail.At(s);
}
