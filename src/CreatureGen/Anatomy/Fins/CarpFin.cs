namespace CreatureGen.Anatomy.Fins;

/// <summary>Carps: a broad rounded fan; on the back a long one that falls off.</summary>
internal static class CarpFin
{
    /// <summary>Its outline on the flank.</summary>
    public static readonly FlankFin Flank = new(
        new[] { -0.17, -0.22, -0.23, -0.19, -0.1, 0.0, 0.1, 0.18 },
        new[] { 0.2, 0.34, 0.42, 0.45, 0.42, 0.36, 0.3, 0.23 });

    /// <summary>Its outline on the midline.</summary>
    public static readonly MidlineFin Midline = new(
        (0, 0.05), (0.06, 0.5), (0.14, 0.9), (0.2, 1), (0.3, 0.88), (0.44, 0.7), (0.6, 0.56), (0.74, 0.44), (0.86, 0.29), (0.94, 0.15), (1, 0.04));
}
