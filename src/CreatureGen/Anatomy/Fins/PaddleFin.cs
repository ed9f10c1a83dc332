namespace CreatureGen.Anatomy.Fins;

/// <summary>Turtles, plesiosaurs and sea lions: a flipper that bends back and runs out in a rounded tip.</summary>
internal static class PaddleFin
{
    /// <summary>Its outline on the flank.</summary>
    public static readonly FlankFin Flank = new(
        new[] { -0.16, -0.17, -0.17, -0.13, -0.02, 0.1, 0.22, 0.33 },
        new[] { 0.2, 0.29, 0.34, 0.37, 0.385, 0.39, 0.385, 0.36 });
}
