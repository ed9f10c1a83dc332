using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Plesiosaurs.</summary>
internal static class Plesiosaur
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Reptile.Profile.Tamed() with
    {
        Body = "plesiosaur",
        Table = new BodyTable(
            2.1,
            2.3,
            (0, -6, 30, 18, 16),       // nose
            (40, -6, 54, 30, 28),      // muzzle, front
            (50, -6, 66, 40, 34),      // muzzle
            (50, -6, 80, 54, 42),      // stop
            (50, -6, 94, 70, 50),      // brow
            (60, 0, 90, 66, 55),       // cranium
            (100, 16, 64, 56, 56),     // nape
            (340, 34, 60, 60, 60),     // neck
            (400, 32, 86, 85, 90),     // neck base
            (220, 14, 172, 142, 162),  // shoulders
            (260, 2, 252, 166, 192),   // ribs
            (270, 0, 268, 166, 192),   // belly
            (240, -2, 222, 152, 166),  // loin
            (200, -2, 152, 122, 122),  // pelvis
            (140, -2, 96, 86, 82),     // tail base
            (160, 0, 62, 56, 50),      // tail, first third
            (160, 0, 36, 36, 30),      // tail, second third
            (120, 0, 10, 10, 10)),     // tail tip
        TorsoLength = (1.1, 2.4),
        Frequency = (0, 0, 0.33),
        Eye = (9.4, 5.0), EyeSize = 0.30,
        Dentition = CrocodileTeeth.Teeth, ToothLength = 0.32, HeadOrnament = (0, 0.15),
        SwimmingPlans = Weights.Of((BodyPlan.Flipper, 1)),
        Fins = new FinPreset
        {
            Fins = new[]
            {
                new FinSitePreset(FinPlace.Pectoral, FinStyle.Paddle, 25, 10, 4, (0.55, 0.75), (0.36, 0.46), 0.4, 0.6),
                new FinSitePreset(FinPlace.Pectoral, FinStyle.Paddle, 41, 10, 4, (0.38, 0.55), (0.42, 0.42), 0.4, 0.6),
            },
            Tail = TailStyle.Plain,
        },
        Colourings = new[]
        {
            new Colouring(new Tint(0.50, 0.05, 215)) { Pattern = new Tint(0.34, 0.04, 225), Kind = PatternKind.Mottle },
            new Colouring(new Tint(0.48, 0.06, 120)) { Pattern = new Tint(0.3, 0.05, 110), Kind = PatternKind.Bands },
            new Colouring(new Tint(0.40, 0.06, 262)) { Kind = PatternKind.Plain, Belly = new Tint(0.88, 0.02, 240) },
            new Colouring(new Tint(0.62, 0.07, 68)) { Pattern = new Tint(0.40, 0.06, 45), Kind = PatternKind.Saddle, Belly = new Tint(0.9, 0.03, 85) },
            new Colouring(new Tint(0.30, 0.03, 190)) { Pattern = new Tint(0.70, 0.10, 180), Kind = PatternKind.Spots, Belly = new Tint(0.78, 0.05, 180) },
        },
    };
}
