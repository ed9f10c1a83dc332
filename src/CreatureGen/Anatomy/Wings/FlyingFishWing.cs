namespace CreatureGen.Anatomy.Wings;

/// <summary>Flying fish: a long sheet over many rays that spread from the shoulder, each of which ends in a small point. After: Fish, Journal of Zoology 221 (1990).</summary>
internal static class FlyingFishWing
{
    /// <summary>Its outline.</summary>
    public static readonly WingForm Form = new()
    {
        Stations = new[] { 0, 0.15, 0.35, 0.6, 0.8, 0.92, 1 },
        Lead = new[] { 0, 0, 0.09, 0.145, 0.08, 0.01, -0.09 },
        Digits = new[]
        {
            new WingPoint[] { new(0.08, -0.01), new(0.35, 0.08), new(0.6, 0.135), new(0.8, 0.07), new(1, -0.1) },
            new WingPoint[] { new(0.08, -0.03), new(0.55, 0.03), new(0.93, -0.16) },
            new WingPoint[] { new(0.08, -0.05), new(0.5, -0.04), new(0.83, -0.24) },
            new WingPoint[] { new(0.08, -0.07), new(0.42, -0.1), new(0.7, -0.31) },
            new WingPoint[] { new(0.08, -0.09), new(0.35, -0.18), new(0.55, -0.36) },
            new WingPoint[] { new(0.08, -0.12), new(0.26, -0.22), new(0.4, -0.38) },
            new WingPoint[] { new(0.08, -0.16), new(0.18, -0.27), new(0.25, -0.37) },
        },
        Tips = new WingPoint[] { new(0, -0.3), new(0.04, -0.3), new(0.25, -0.37), new(0.4, -0.38), new(0.55, -0.36), new(0.7, -0.31), new(0.83, -0.24), new(0.93, -0.16), new(1, -0.1) },
        Scallops = new[] { 0, 0.02, 0.025, 0.025, 0.025, 0.02, 0.015, 0.01 },
        Depth = 0.5, Span = 1.15,
    };
}
