using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Tails;

/// <summary>Whales and dolphins: two level lobes with a notch between them, full beside it, hollow before their tips.</summary>
internal static class FlukeTail
{
    private static readonly MonotoneCurve edge = new(new[] { 0, 0.12, 0.3, 0.5, 0.75, 0.9, 1 }, new[] { -0.16, 0.2, 0.4, 0.5, 0.62, 0.8, 1 });

    /// <summary>How far the tips are bent up, in half spans: a level fluke is a thread from the side.</summary>
    private const double Camber = 0.36;

    /// <summary>How far a lobe is bent up at a share of its half span, in half spans: level at its root and again at its tip, as the wing of a gull, or from ahead its tip is a horn beside the head.</summary>
    public static double RiseAt(double across) => Camber * Scalar.Smooth(across);

    /// <summary>Where the rear edge of a lobe lies at a share of its half span, in sweeps of its tip behind the root; negative ahead of it.</summary>
    public static double EdgeAt(double across) => edge.At(across);
}
