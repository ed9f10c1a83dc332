using CreatureGen.Blueprints;

namespace CreatureGen.Species;

/// <summary>Muscle and bone under the skin of a torso: shoulder blades, haunches and flanks, as swellings and hollows.</summary>
internal static class TorsoRelief
{
    /// <summary>Of mammals.</summary>
    public static readonly HeadBump[] Mammal =
    {
        new(25.2, 4.6, 1.7, 1.7, 0.075),   // shoulder blade
        new(28.4, 5.0, 1.5, 2.4, -0.05),   // behind it
        new(40.6, 5.6, 2.2, 2.2, 0.06),    // haunch
        new(37.2, 8.6, 2.0, 2.2, -0.06),   // flank
    };

    /// <summary>Of lizards and dinosaurs.</summary>
    public static readonly HeadBump[] Reptile =
    {
        new(25.0, 5.2, 1.7, 2.0, 0.05),
        new(40.6, 5.8, 2.0, 2.2, 0.05),
        new(37.0, 8.0, 2.2, 2.4, -0.04),
    };
}
