namespace CreatureGen.Anatomy.Wings;

/// <summary>Gliding lizards: a round sheet over long ribs that spread from the flank, without a hand. After: McGuire and Dudley, Integrative and Comparative Biology 51 (2011).</summary>
internal static class GlidingLizardWing
{
    /// <summary>Its outline.</summary>
    public static readonly WingForm Form = new()
    {
        Stations = new[] { 0, 0.15, 0.35, 0.6, 0.8, 0.92, 1 },
        Lead = new[] { 0, 0, 0.09, 0.145, 0.06, -0.05, -0.19 },
        Digits = new[]
        {
            new WingPoint[] { new(0.06, -0.01), new(0.35, 0.08), new(0.6, 0.135), new(0.8, 0.05), new(0.92, -0.06), new(1, -0.2) },
            new WingPoint[] { new(0.06, -0.05), new(0.5, -0.04), new(0.9, -0.31) },
            new WingPoint[] { new(0.06, -0.1), new(0.4, -0.18), new(0.73, -0.44) },
            new WingPoint[] { new(0.06, -0.17), new(0.3, -0.3), new(0.52, -0.5) },
            new WingPoint[] { new(0.06, -0.25), new(0.2, -0.38), new(0.29, -0.51) },
        },
        Tips = new WingPoint[] { new(0, -0.43), new(0.04, -0.43), new(0.29, -0.51), new(0.52, -0.5), new(0.73, -0.44), new(0.9, -0.31), new(1, -0.205) },
        Scallops = new[] { 0, 0.02, 0.025, 0.025, 0.025, 0.015 },
        Depth = 0.61, Span = 0.9,
    };
}
