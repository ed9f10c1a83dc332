namespace CreatureGen.Anatomy.Fins;

/// <summary>Turtles, plesiosaurs and sea lions: a flipper that bends back and runs out in a rounded tip.</summary>
internal static class PaddleFin
{
    /// <summary>Its outline on the flank.</summary>
    public static readonly FlankFin Flank = new(
        new[] { -0.18, -0.18, -0.165, -0.11, -0.02, 0.09, 0.19, 0.28 },
        new[] { 0.25, 0.34, 0.37, 0.365, 0.345, 0.325, 0.31, 0.3 });
}
