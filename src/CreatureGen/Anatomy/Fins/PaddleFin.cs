namespace CreatureGen.Anatomy.Fins;

/// <summary>Turtles, plesiosaurs and sea lions: a flipper that bends back and runs out in a rounded tip.</summary>
internal static class PaddleFin
{
    /// <summary>Its outline on the flank.</summary>
    public static readonly FlankFin Flank = new(
        new[] { -0.16, -0.17, -0.165, -0.12, -0.03, 0.06, 0.14, 0.2 },
        new[] { 0.2, 0.29, 0.345, 0.37, 0.35, 0.31, 0.27, 0.23 });
}
