namespace CreatureGen.Anatomy.Fins;

/// <summary>Rays and eels: on the flank a broad fin, rounded ahead and behind; on the back a ribbon.</summary>
internal static class RayFin
{
    /// <summary>Its outline on the flank.</summary>
    public static readonly FlankFin Flank = new(
        new[] { -0.26, -0.29, -0.27, -0.18, -0.04, 0.08, 0.19, 0.28 },
        new[] { 0.3, 0.4, 0.45, 0.47, 0.45, 0.41, 0.36, 0.31 });

    /// <summary>Its outline on the midline.</summary>
    public static readonly MidlineFin Midline = new(
        (0, 0.03), (0.1, 0.42), (0.22, 0.78), (0.36, 0.98), (0.48, 1), (0.62, 0.94), (0.76, 0.76), (0.88, 0.46), (1, 0.03));
}
