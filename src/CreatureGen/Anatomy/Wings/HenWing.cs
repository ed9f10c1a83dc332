namespace CreatureGen.Anatomy.Wings;

/// <summary>Most birds: broad and rounded.</summary>
internal static class HenWing
{
    /// <summary>Its outline.</summary>
    public static readonly WingForm Form = new()
    {
        Stations = new[] { 0, 0.1, 0.3, 0.52, 0.74, 0.88, 0.96, 1 },
        Lead = new[] { 0, 0.01, 0.03, 0.15, 0.125, 0.07, 0.015, -0.03 },
        Trail = new[] { -0.26, -0.25, -0.265, -0.175, -0.185, -0.17, -0.12, -0.055 },
        Feathers = 11, Slots = 0.28, Depth = 0.34,
    };
}
