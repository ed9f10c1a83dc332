namespace CreatureGen.Anatomy.Wings;

/// <summary>Owls and eagles: broad, with fingers of feathers at the tip. After: Pennycuick, Modelling the Flying Bird (2008).</summary>
internal static class OwlWing
{
    /// <summary>Its outline.</summary>
    public static readonly WingForm Form = new()
    {
        Stations = new[] { 0, 0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 0.95, 1 },
        Lead = new[] { 0, 0.03, 0.09, 0.15, 0.16, 0.125, 0.05, -0.03, -0.1 },
        Trail = new[] { -0.26, -0.27, -0.26, -0.23, -0.22, -0.23, -0.235, -0.19, -0.125 },
        Feathers = 11, Slots = 0.36, Depth = 0.38, Span = 0.98,
    };
}
