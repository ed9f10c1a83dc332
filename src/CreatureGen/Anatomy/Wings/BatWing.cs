namespace CreatureGen.Anatomy.Wings;

/// <summary>Bats: four fingers in a membrane that comes down along the flank. After: Norberg and Rayner, Phil. Trans. B 316 (1987).</summary>
internal static class BatWing
{
    /// <summary>Its outline.</summary>
    public static readonly WingForm Form = new()
    {
        Stations = new[] { 0, 0.2, 0.38, 0.62, 0.8, 0.9, 1 },
        Lead = new[] { 0, -0.03, 0.13, 0.155, 0.07, -0.01, -0.13 },
        Digits = new[]
        {
            new WingPoint[] { new(0.38, 0.13), new(0.66, 0.13), new(0.88, -0.01), new(1, -0.14) },
            new WingPoint[] { new(0.38, 0.13), new(0.58, -0.05), new(0.78, -0.33) },
            new WingPoint[] { new(0.38, 0.13), new(0.46, -0.14), new(0.5, -0.4) },
        },
        Tips = new WingPoint[] { new(0, -0.46), new(0.07, -0.46), new(0.5, -0.4), new(0.78, -0.33), new(1, -0.14) },
        Scallops = new[] { 0, 0.15, 0.09, 0.1 },
        Depth = 0.46,
    };
}
