namespace CreatureGen.Anatomy.Fins;

/// <summary>Flying fish: a wing of rays.</summary>
internal static class FlyingFin
{
    /// <summary>Its outline on the flank.</summary>
    public static readonly FlankFin Flank = new(
        new[] { -0.1, -0.09, -0.07, -0.03, 0.02, 0.08, 0.14, 0.2 },
        new[] { 0.14, 0.24, 0.33, 0.42, 0.46, 0.44, 0.38, 0.27 });
}
