namespace CreatureGen.Anatomy.Wings;

/// <summary>Falcons: pointed and swept back. After: Pennycuick, Modelling the Flying Bird (2008).</summary>
internal static class FalconWing
{
    /// <summary>Its outline.</summary>
    public static readonly WingForm Form = new()
    {
        Stations = new[] { 0, 0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 0.95, 1 },
        Lead = new[] { 0, 0.03, 0.1, 0.17, 0.15, 0.06, -0.07, -0.17, -0.24 },
        Trail = new[] { -0.19, -0.19, -0.18, -0.15, -0.14, -0.16, -0.2, -0.23, -0.25 },
        Feathers = 13, Slots = 0.1, Depth = 0.32, Span = 1.02,
    };
}
