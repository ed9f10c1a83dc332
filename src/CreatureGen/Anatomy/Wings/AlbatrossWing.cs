namespace CreatureGen.Anatomy.Wings;

/// <summary>Albatrosses: long and narrow. After: Pennycuick, Modelling the Flying Bird (2008).</summary>
internal static class AlbatrossWing
{
    /// <summary>Its outline.</summary>
    public static readonly WingForm Form = new()
    {
        Stations = new[] { 0, 0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 0.95, 1 },
        Lead = new[] { 0, 0.02, 0.06, 0.12, 0.13, 0.09, 0.04, -0.02, -0.07 },
        Trail = new[] { -0.15, -0.14, -0.1, -0.04, -0.02, -0.05, -0.08, -0.1, -0.1 },
        Feathers = 15, Slots = 0.08, Depth = 0.17, Span = 1.25,
    };
}
