namespace CreatureGen.Anatomy.Wings;

/// <summary>Dragons: a bat's hand that ends in hooks, and a deep root.</summary>
internal static class DragonWing
{
    /// <summary>Its outline.</summary>
    public static readonly WingForm Form = new()
    {
        Stations = new[] { 0, 0.18, 0.36, 0.66, 0.8, 0.9, 1 },
        Lead = new[] { 0, 0, 0.15, 0.16, 0.09, 0.02, -0.09 },
        Digits = new[]
        {
            new WingPoint[] { new(0.36, 0.17), new(0.66, 0.15), new(0.9, 0.02), new(1, -0.1) },
            new WingPoint[] { new(0.36, 0.17), new(0.62, 0.02), new(0.86, -0.32) },
            new WingPoint[] { new(0.36, 0.17), new(0.54, -0.1), new(0.64, -0.48) },
            new WingPoint[] { new(0.36, 0.17), new(0.42, -0.15), new(0.36, -0.52) },
        },
        Tips = new WingPoint[] { new(0, -0.42), new(0.03, -0.42), new(0.36, -0.52), new(0.64, -0.48), new(0.86, -0.32), new(1, -0.1) },
        Scallops = new[] { 0, 0.13, 0.14, 0.13, 0.11 },
        Depth = 0.53, Span = 1,
    };
}
