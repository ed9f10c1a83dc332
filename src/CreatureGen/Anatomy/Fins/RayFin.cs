namespace CreatureGen.Anatomy.Fins;

/// <summary>Rays and eels: a triangle with a rounded rear that runs along the flank; on the back an even ribbon.</summary>
internal static class RayFin
{
    /// <summary>Its outline on the flank.</summary>
    public static readonly FlankFin Flank = new(
        new[] { -0.75, -0.58, -0.42, -0.22, -0.03, 0.1, 0.2, 0.28 },
        new[] { 0.3, 0.48, 0.57, 0.56, 0.48, 0.41, 0.36, 0.31 });

    /// <summary>Its outline on the midline.</summary>
    public static readonly MidlineFin Midline = new(
        (0, 0.05), (0.06, 0.6), (0.14, 0.9), (0.25, 1), (0.75, 1), (0.86, 0.9), (0.94, 0.6), (1, 0.05));
}
