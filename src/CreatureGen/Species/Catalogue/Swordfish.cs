using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Swordfish.</summary>
internal static class Swordfish
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Fish.Profile.Tamed() with
    {
        Body = "swordfish",
        Table = new BodyTable(
            2.0,
            2.0,
            (0, 0, 7, 8, 7),          // nose
            (190, 0, 14, 14, 12),     // muzzle, front
            (150, 0, 24, 24, 20),     // muzzle
            (90, 0, 52, 60, 52),      // stop
            (60, 0, 80, 96, 84),      // brow
            (70, 0, 98, 122, 112),    // cranium
            (80, 0, 108, 140, 130),   // nape
            (80, 0, 112, 148, 142),   // neck
            (100, 0, 116, 152, 148),  // neck base
            (120, 0, 118, 152, 150),  // shoulders
            (170, 0, 112, 146, 142),  // ribs
            (170, 0, 98, 130, 124),   // belly
            (160, 0, 76, 104, 98),    // loin
            (150, 0, 52, 74, 70),     // pelvis
            (120, 0, 34, 50, 48),     // tail base
            (120, 0, 22, 32, 30),     // tail, first third
            (100, 0, 18, 26, 25),     // tail, second third
            (100, 0, 8, 18, 18)),     // tail tip
        TorsoLength = (1, 1.9),
        Frequency = (0, 0, 0.22),
        Dominance = (0.93, 0.98),
        Eye = (10, 6.8), EyeSize = 0.26,
        MouthCorner = 7, Teeth = 0,
        MouthOpenings = Weights.Of<double>((0, 1)),
        SwimmingPlans = Weights.Of((BodyPlan.Fish, 1)),
        Fins = new FinPreset
        {
            Fins = new[]
            {
                new FinSitePreset(FinPlace.Dorsal, FinStyle.Shark, 22, 0, 8, (0.22, 0.34), (0, 0), 0, 0.8),
                new FinSitePreset(FinPlace.Ventral, FinStyle.Shark, 40, 0, 4, (0.09, 0.13), (0, 0), 0, 0.9),
                new FinSitePreset(FinPlace.Pectoral, FinStyle.Tuna, 23, 11, 4, (0.3, 0.4), (0.34, 0.42), 0.6, 0.7),
            },
            Tail = TailStyle.Lunate, TailSize = (0.28, 0.34),
        },
        WingStyles = Weights.Of((WingStyle.FlyingFish, 1)),
        Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Bands, 0.6)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.36, 0.07, 255)) { Kind = PatternKind.Plain, Belly = new Tint(0.9, 0.01, 230), Accent = new Tint(0.3, 0.08, 262) },
            new Colouring(new Tint(0.48, 0.08, 250)) { Pattern = new Tint(0.34, 0.10, 262), Kind = PatternKind.Bands, Belly = new Tint(0.9, 0.01, 230), Accent = new Tint(0.4, 0.15, 262) },
            new Colouring(new Tint(0.44, 0.03, 60)) { Kind = PatternKind.Plain, Belly = new Tint(0.86, 0.02, 80) },
            new Colouring(new Tint(0.58, 0.09, 205)) { Pattern = new Tint(0.40, 0.09, 240), Kind = PatternKind.Saddle, Belly = new Tint(0.93, 0.02, 200), Accent = new Tint(0.78, 0.14, 95) },
        },
    };
}
