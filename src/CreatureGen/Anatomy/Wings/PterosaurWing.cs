namespace CreatureGen.Anatomy.Wings;

/// <summary>Pterosaurs: one long finger and a narrow sail, drawn in between stiff fibres, or it would be a plain leaf. After: Witton and Habib, PLoS ONE 5 (2010).</summary>
internal static class PterosaurWing
{
    /// <summary>Its outline.</summary>
    public static readonly WingForm Form = new()
    {
        Stations = new[] { 0, 0.13, 0.27, 0.45, 0.66, 0.84, 1 },
        Lead = new[] { 0, -0.01, 0.03, 0.12, 0.06, -0.02, -0.11 },
        Digits = new[]
        {
            new WingPoint[] { new(0.27, 0.03), new(0.45, 0.12), new(0.66, 0.06), new(0.84, -0.02), new(1, -0.12) },
            new WingPoint[] { new(0.45, 0.12), new(0.6, 0), new(0.72, -0.17) },
            new WingPoint[] { new(0.45, 0.12), new(0.46, -0.03), new(0.4, -0.22) },
        },
        Tips = new WingPoint[] { new(0, -0.24), new(0.05, -0.24), new(0.4, -0.22), new(0.72, -0.17), new(1, -0.125) },
        Scallops = new[] { 0, 0.08, 0.07, 0.045 },
        Depth = 0.33, Span = 1.2,
    };
}
