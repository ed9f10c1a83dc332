namespace CreatureGen.Anatomy.Wings;

/// <summary>Flying fish: a long sheet over many rays that spread from the shoulder, each of which ends in a small point. After: Fish, Journal of Zoology 221 (1990).</summary>
internal static class FlyingFishWing
{
    /// <summary>Its outline.</summary>
    public static readonly WingForm Form = new()
    {
        Stations = new[] { 0, 0.15, 0.35, 0.6, 0.8, 0.92, 1 },
        Lead = new[] { 0, 0.03, 0.06, 0.05, 0, -0.05, -0.12 },
        Digits = new[]
        {
            new WingPoint[] { new(0.08, 0), new(0.35, 0.05), new(0.6, 0.04), new(0.8, -0.01), new(1, -0.13) },
            new WingPoint[] { new(0.08, -0.02), new(0.55, -0.02), new(0.93, -0.19) },
            new WingPoint[] { new(0.08, -0.04), new(0.5, -0.08), new(0.83, -0.26) },
            new WingPoint[] { new(0.08, -0.06), new(0.42, -0.13), new(0.7, -0.32) },
            new WingPoint[] { new(0.08, -0.09), new(0.35, -0.18), new(0.55, -0.36) },
            new WingPoint[] { new(0.08, -0.12), new(0.26, -0.22), new(0.4, -0.38) },
            new WingPoint[] { new(0.08, -0.16), new(0.18, -0.27), new(0.25, -0.37) },
        },
        Tips = new WingPoint[] { new(0, -0.3), new(0.04, -0.3), new(0.25, -0.37), new(0.4, -0.38), new(0.55, -0.36), new(0.7, -0.32), new(0.83, -0.26), new(0.93, -0.19), new(1, -0.13) },
        Scallops = new[] { 0, 0.02, 0.025, 0.025, 0.025, 0.02, 0.015, 0.01 },
        Depth = 0.43, Span = 1.15,
    };
}
