namespace CreatureGen.Anatomy.Fins;

/// <summary>Sharks: a swept triangle.</summary>
internal static class SharkFin
{
    /// <summary>Its outline on the flank.</summary>
    public static readonly FlankFin Flank = new(
        new[] { -0.2, -0.11, -0.01, 0.12, 0.25, 0.36, 0.46, 0.54 },
        new[] { 0.36, 0.34, 0.33, 0.35, 0.42, 0.5, 0.57, 0.6 });
}
