using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Sharks.</summary>
internal static class Shark
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Fish.Profile.Tamed() with
    {
        Body = "shark",
        Table = new BodyTable(
            2.1,
            2.1,
            (0, 0, 16, 16, 12),       // nose
            (60, 0, 56, 40, 28),      // muzzle, front
            (70, 0, 86, 62, 48),      // muzzle
            (70, 0, 112, 88, 72),     // stop
            (70, 0, 132, 112, 98),    // brow
            (80, 0, 148, 132, 118),   // cranium
            (90, 0, 158, 152, 138),   // nape
            (100, 0, 166, 168, 152),  // neck
            (110, 0, 172, 178, 162),  // neck base
            (130, 0, 172, 183, 166),  // shoulders
            (170, 0, 166, 176, 160),  // ribs
            (180, 0, 150, 158, 146),  // belly
            (180, 0, 120, 128, 118),  // loin
            (170, 0, 85, 92, 84),     // pelvis
            (130, 0, 56, 58, 54),     // tail base
            (120, 0, 38, 35, 35),     // tail, first third
            (90, 0, 28, 30, 28),      // tail, second third
            (100, 0, 8, 30, 30)),     // tail tip
        Cover = SkinCover.Wrinkles, CoverSize = 0.022f,
        TorsoLength = (1, 2.6),
        Frequency = (0, 0, 0.42),
        Eye = (8.4, 7.2), EyeSize = 0.17,
        MouthCorner = 6, Dentition = SawTeeth.Teeth, Teeth = 1, ToothLength = 0.19,
        MouthOpenings = Weights.Of<double>((0.10, 1), (0.18, 1), (0.0, 0.6)),
        SwimmingPlans = Weights.Of((BodyPlan.Fish, 1)),
        Fins = new FinPreset
        {
            Fins = new[]
            {
                new FinSitePreset(FinPlace.Dorsal, FinStyle.Shark, 27, 0, 8, (0.24, 0.32), (0, 0), 0, 0.9),
                new FinSitePreset(FinPlace.Dorsal, FinStyle.Shark, 41, 0, 4, (0.07, 0.09), (0, 0), 0, 0.9),
                new FinSitePreset(FinPlace.Pectoral, FinStyle.Shark, 24, 10, 4, (0.38, 0.50), (0.40, 0.50), 0.38, 0.6),
                new FinSitePreset(FinPlace.Pectoral, FinStyle.Shark, 38, 11, 4, (0.15, 0.18), (0.5, 0.5), 0.4, 0.6),
            },
            Tail = TailStyle.Heterocercal, TailSize = (0.26, 0.32),
        },
        Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Stripes, 0.5), (PatternKind.Spots, 0.4)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.56, 0.03, 240)) { Kind = PatternKind.Plain, Belly = new Tint(0.9, 0.01, 230), Accent = new Tint(0.40, 0.03, 240) },
            new Colouring(new Tint(0.50, 0.05, 225)) { Pattern = new Tint(0.34, 0.04, 235), Kind = PatternKind.Stripes, Belly = new Tint(0.88, 0.01, 200), Accent = new Tint(0.36, 0.04, 235) },
            new Colouring(new Tint(0.60, 0.04, 80)) { Pattern = new Tint(0.4, 0.04, 70), Kind = PatternKind.Spots, Accent = new Tint(0.42, 0.04, 75) },
            new Colouring(new Tint(0.44, 0.07, 262)) { Kind = PatternKind.Plain, Belly = new Tint(0.92, 0.01, 240), Accent = new Tint(0.34, 0.07, 262) },
            new Colouring(new Tint(0.66, 0.06, 62)) { Pattern = new Tint(0.44, 0.05, 55), Kind = PatternKind.Bands, Belly = new Tint(0.9, 0.02, 80) },
            new Colouring(new Tint(0.36, 0.02, 60)) { Pattern = new Tint(0.86, 0.02, 90), Kind = PatternKind.Spots, Scale = 1.6, Belly = new Tint(0.86, 0.02, 90) },
        },
    };
}
