using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Tails;

/// <summary>Whales and dolphins: two level lobes with a notch between them, full beside it, hollow before their tips; fans on some and sickles on others.</summary>
internal static class FlukeTail
{
    private static readonly double[] stations = { 0, 0.12, 0.3, 0.5, 0.75, 0.9, 1 };
    private static readonly MonotoneCurve edge = new(stations, new[] { -0.16, 0.2, 0.4, 0.5, 0.62, 0.8, 1 });
    private static readonly MonotoneCurve fan = new(stations, new[] { -0.2, 0.3, 0.58, 0.72, 0.84, 0.92, 1 });
    private static readonly MonotoneCurve sickle = new(stations, new[] { -0.04, 0.08, 0.16, 0.27, 0.5, 0.75, 1 });

    /// <summary>How far the tips droop, in half spans: a level fluke is a thread from the side, and of one that is bent up the near lobe is edge on from above it, from ahead as from behind.</summary>
    private const double Droop = 0.2;

    // How far a lobe's leading edge bows out, in half spans, and by how much less on a sickle or more on a fan.
    private const double Bow = 0.5;
    private const double BowOfFan = 0.3;

    /// <summary>How far a lobe has come down at a share of its half span, in half spans: level at its root and again at its tip.</summary>
    public static double FallAt(double across) => Droop * Scalar.Smooth(across);

    /// <summary>Where the rear edge of a lobe lies at a share of its half span, in sweeps of its tip behind the root; negative ahead of it.</summary>
    /// <param name="across">0 in the notch to 1 at the tip.</param>
    /// <param name="hollow">−1 for a fan, 1 for a sickle.</param>
    public static double EdgeAt(double across, double hollow = 0) =>
        Scalar.Lerp(edge.At(across), (hollow < 0 ? fan : sickle).At(across), System.Math.Abs(hollow));

    /// <summary>Half width of a fluke at a share of its length, in half spans.</summary>
    /// <param name="opened">0 where it leaves the stalk to 1 at its rear edge.</param>
    /// <param name="hollow">−1 for a fan, 1 for a sickle.</param>
    public static double WidthAt(double opened, double hollow) => opened * (1 + ((Bow - (BowOfFan * hollow)) * (1 - opened)));
}
