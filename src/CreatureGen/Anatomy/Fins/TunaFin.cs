namespace CreatureGen.Anatomy.Fins;

/// <summary>Tunas: a narrow sickle on the flank; on the back a high fin, a gap and a second one.</summary>
internal static class TunaFin
{
    /// <summary>Its outline on the flank.</summary>
    public static readonly FlankFin Flank = new(
        new[] { -0.12, -0.09, -0.04, 0.05, 0.19, 0.29, 0.37, 0.42 },
        new[] { 0.17, 0.22, 0.26, 0.32, 0.38, 0.42, 0.44, 0.45 });

    /// <summary>Its outline on the midline.</summary>
    public static readonly MidlineFin Midline = new(
        (0, 0.1), (0.1, 0.5), (0.17, 0.66), (0.26, 0.3), (0.4, 0.16), (0.54, 0.14), (0.62, 0.45), (0.74, 1), (0.82, 0.4), (0.9, 0.22), (1, 0.04));
}
