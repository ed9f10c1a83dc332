namespace CreatureGen.Anatomy.Wings;

/// <summary>Butterflies: broad triangles, the hind wings rounded: a tail of three points is a square bite beside it.</summary>
internal static class ButterflyWing
{
    /// <summary>The outline of the fore wing.</summary>
    public static readonly ThinWingForm Fore = new(
        (0, 0.02), (0.1, 0.1), (0.22, 0.19), (0.36, 0.28), (0.5, 0.35), (0.64, 0.4), (0.78, 0.425), (0.9, 0.42),
        (0.97, 0.39), (1, 0.33), (0.985, 0.25), (0.95, 0.17), (0.92, 0.09), (0.9, 0), (0.87, -0.08), (0.81, -0.14),
        (0.72, -0.17), (0.61, -0.17), (0.5, -0.155), (0.39, -0.13), (0.28, -0.1), (0.17, -0.07), (0.08, -0.04), (0, -0.02));

    /// <summary>The outline of the hind wing.</summary>
    public static readonly ThinWingForm Hind = new(
        (0, 0.03), (0.1, 0.05), (0.22, 0.06), (0.35, 0.05), (0.48, 0.01), (0.6, -0.06), (0.69, -0.15), (0.75, -0.25),
        (0.78, -0.36), (0.77, -0.46), (0.73, -0.55), (0.67, -0.62), (0.62, -0.66), (0.55, -0.69), (0.47, -0.7), (0.39, -0.68),
        (0.31, -0.63), (0.24, -0.56), (0.18, -0.48), (0.12, -0.39), (0.07, -0.29), (0.04, -0.19), (0.02, -0.1), (0, -0.04));
}
