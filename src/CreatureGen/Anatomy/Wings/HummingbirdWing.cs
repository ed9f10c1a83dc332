namespace CreatureGen.Anatomy.Wings;

/// <summary>Hummingbirds: a blade that is all hand. After: Pennycuick, Modelling the Flying Bird (2008).</summary>
internal static class HummingbirdWing
{
    /// <summary>Its outline.</summary>
    public static readonly WingForm Form = new()
    {
        Stations = new[] { 0, 0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 0.95, 1 },
        Lead = new[] { 0, 0.03, 0.08, 0.12, 0.12, 0.07, -0.01, -0.09, -0.15 },
        Trail = new[] { -0.2, -0.2, -0.19, -0.16, -0.15, -0.18, -0.21, -0.22, -0.2 },
        Feathers = 10, Slots = 0.16, Depth = 0.29, Span = 0.85,
    };
}
