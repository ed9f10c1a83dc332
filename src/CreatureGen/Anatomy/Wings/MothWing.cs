namespace CreatureGen.Anatomy.Wings;

/// <summary>Hawk moths and their kin: blunt wings with a round hind edge. After: Willmott and Ellington, J. Exp. Biol. 200 (1997).</summary>
internal static class MothWing
{
    /// <summary>The outline of the fore wing.</summary>
    public static readonly ThinWingForm Fore = new(
        (0, 0.02), (0.12, 0.07), (0.25, 0.12), (0.4, 0.165), (0.55, 0.2), (0.7, 0.22), (0.84, 0.22), (0.94, 0.2),
        (1, 0.15), (1, 0.09), (0.97, 0.03), (0.92, -0.03), (0.86, -0.09), (0.79, -0.15), (0.7, -0.2), (0.61, -0.225),
        (0.52, -0.23), (0.43, -0.22), (0.34, -0.2), (0.26, -0.17), (0.18, -0.13), (0.11, -0.09), (0.05, -0.055), (0, -0.02));

    /// <summary>The outline of the hind wing.</summary>
    public static readonly ThinWingForm Hind = new(
        (0, 0.03), (0.1, 0.04), (0.22, 0.03), (0.34, 0.01), (0.45, -0.03), (0.54, -0.09), (0.6, -0.17), (0.62, -0.26),
        (0.6, -0.35), (0.55, -0.42), (0.48, -0.47), (0.4, -0.49), (0.32, -0.48), (0.25, -0.455), (0.19, -0.41), (0.14, -0.36),
        (0.1, -0.3), (0.07, -0.25), (0.05, -0.2), (0.035, -0.16), (0.025, -0.12), (0.015, -0.09), (0.008, -0.06), (0, -0.03));
}
