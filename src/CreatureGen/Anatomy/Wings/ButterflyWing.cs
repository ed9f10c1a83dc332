namespace CreatureGen.Anatomy.Wings;

/// <summary>Butterflies: broad triangles, the hind wings with a tail.</summary>
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
        (0.78, -0.36), (0.76, -0.46), (0.71, -0.54), (0.64, -0.6), (0.6, -0.68), (0.55, -0.72), (0.51, -0.66), (0.44, -0.64),
        (0.35, -0.62), (0.26, -0.57), (0.18, -0.5), (0.12, -0.41), (0.07, -0.3), (0.04, -0.19), (0.02, -0.1), (0, -0.04));
}
