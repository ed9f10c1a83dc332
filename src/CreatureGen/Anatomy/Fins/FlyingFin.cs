namespace CreatureGen.Anatomy.Fins;

/// <summary>Flying fish: a wing of rays.</summary>
internal static class FlyingFin
{
    /// <summary>Its outline on the flank.</summary>
    public static readonly FlankFin Flank = new(
        new[] { -0.14, -0.12, -0.08, -0.03, 0.02, 0.08, 0.14, 0.2 },
        new[] { 0.2, 0.32, 0.4, 0.44, 0.44, 0.41, 0.36, 0.28 });
}
