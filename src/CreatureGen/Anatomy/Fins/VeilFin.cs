namespace CreatureGen.Anatomy.Fins;

/// <summary>Fighting fish: long veils that hang over their base.</summary>
internal static class VeilFin
{
    /// <summary>Its outline on the flank.</summary>
    public static readonly FlankFin Flank = new(
        new[] { -0.07, -0.09, -0.09, -0.06, 0.02, 0.13, 0.24, 0.34 },
        new[] { 0.08, 0.17, 0.27, 0.4, 0.52, 0.58, 0.57, 0.46 });

    /// <summary>Its outline on the midline.</summary>
    public static readonly MidlineFin Midline = new((0, 0.55), (0.15, 0.82), (0.35, 1), (0.55, 0.98), (0.75, 0.82), (0.9, 0.6), (1, 0.38)) { Overhang = (0.42, 0.34) };
}
