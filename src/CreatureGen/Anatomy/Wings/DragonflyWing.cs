namespace CreatureGen.Anatomy.Wings;

/// <summary>Dragonflies: long straight wings, the hind ones broad at the root. After: Wakeling and Ellington, J. Exp. Biol. 200 (1997).</summary>
internal static class DragonflyWing
{
    /// <summary>The outline of the fore wing.</summary>
    public static readonly ThinWingForm Fore = new(
        (0, 0.03), (0.08, 0.045), (0.2, 0.05), (0.35, 0.055), (0.5, 0.05), (0.62, 0.055), (0.75, 0.05), (0.88, 0.03),
        (0.96, 0), (1, -0.05), (0.99, -0.09), (0.94, -0.13), (0.86, -0.155), (0.76, -0.165), (0.66, -0.165), (0.56, -0.16),
        (0.46, -0.15), (0.36, -0.135), (0.28, -0.12), (0.2, -0.1), (0.13, -0.08), (0.07, -0.06), (0.03, -0.04), (0, -0.02));

    /// <summary>The outline of the hind wing.</summary>
    public static readonly ThinWingForm Hind = new(
        (0, 0.03), (0.1, 0.05), (0.22, 0.05), (0.36, 0.05), (0.5, 0.045), (0.64, 0.045), (0.76, 0.035), (0.88, 0.01),
        (0.96, -0.03), (1, -0.08), (0.98, -0.13), (0.92, -0.16), (0.84, -0.18), (0.74, -0.19), (0.64, -0.195), (0.54, -0.205),
        (0.44, -0.22), (0.34, -0.24), (0.24, -0.255), (0.15, -0.25), (0.08, -0.22), (0.04, -0.16), (0.02, -0.09), (0, -0.03));
}
