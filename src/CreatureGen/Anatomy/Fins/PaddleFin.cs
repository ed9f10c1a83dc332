namespace CreatureGen.Anatomy.Fins;

/// <summary>Turtles, plesiosaurs and sea lions: a flipper that bends back and runs out in a rounded tip.</summary>
internal static class PaddleFin
{
    /// <summary>Its outline on the flank.</summary>
    public static readonly FlankFin Flank = new(
        new[] { -0.16, -0.17, -0.165, -0.12, -0.02, 0.09, 0.19, 0.28 },
        new[] { 0.2, 0.29, 0.34, 0.365, 0.36, 0.34, 0.32, 0.3 });
}
