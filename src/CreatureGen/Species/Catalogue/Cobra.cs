using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Cobras.</summary>
internal static class Cobra
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Serpent.Profile.Tamed() with
    {
        Body = "cobra",
        Table = new BodyTable(
            2.0,
            2.4,
            (0, -16, 34, 24, 20),      // nose
            (30, -16, 62, 42, 34),     // muzzle, front
            (60, -14, 78, 54, 40),     // muzzle
            (70, -12, 98, 68, 45),     // stop
            (60, -8, 114, 84, 55),     // brow
            (80, 4, 118, 78, 60),      // cranium
            (150, 60, 165, 60, 58),    // nape
            (210, 86, 262, 58, 58),    // neck
            (200, 84, 185, 72, 72),    // neck base
            (230, 50, 122, 100, 95),   // shoulders
            (350, 12, 120, 115, 110),  // ribs
            (350, 0, 124, 120, 115),   // belly
            (350, 0, 120, 115, 110),   // loin
            (320, 0, 108, 105, 100),   // pelvis
            (300, 0, 92, 90, 85),      // tail base
            (350, 0, 72, 70, 65),      // tail, first third
            (350, 0, 46, 45, 42),      // tail, second third
            (300, 0, 12, 12, 12)),     // tail tip
        TorsoLength = (0.7, 1.6),
        Frequency = (0.17, 0, 0),
        LatticeSpread = 0.16,
        Eye = (9.6, 5.4), EyeSize = 0.30,
        HeadOrnament = (0, 0),
        WalkingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Legless, 1) },
        Parts = System.Array.Empty<PartSlot>(),
        Colourings = new[]
        {
            new Colouring(new Tint(0.55, 0.07, 75)) { Pattern = new Tint(0.32, 0.05, 60), Kind = PatternKind.Bands },
            new Colouring(new Tint(0.36, 0.03, 60)) { Pattern = new Tint(0.7, 0.09, 85), Kind = PatternKind.Bands },
            new Colouring(new Tint(0.60, 0.13, 130)) { Kind = PatternKind.Plain },
        },
    };
}
