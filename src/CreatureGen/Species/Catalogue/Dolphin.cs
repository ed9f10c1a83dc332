using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Dolphins.</summary>
internal static class Dolphin
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Fish.Profile.Tamed() with
    {
        Body = "dolphin",
        Table = new BodyTable(
            2.1,
            2.1,
            (0, -4, 26, 22, 20),       // nose
            (40, -4, 36, 30, 28),      // muzzle, front
            (70, -4, 44, 38, 36),      // muzzle
            (60, -18, 70, 66, 56),     // stop
            (50, -28, 104, 112, 80),   // brow
            (80, -14, 130, 138, 108),  // cranium
            (100, 0, 148, 150, 132),   // nape
            (110, 2, 162, 162, 150),   // neck
            (120, 2, 174, 170, 164),   // neck base
            (150, 1, 180, 174, 172),   // shoulders
            (200, 0, 176, 168, 170),   // ribs
            (200, -1, 156, 150, 152),  // belly
            (190, -2, 124, 124, 124),  // loin
            (180, -2, 90, 98, 96),     // pelvis
            (130, -2, 58, 70, 68),     // tail base
            (140, -1, 36, 48, 46),     // tail, first third
            (130, 0, 24, 32, 30),      // tail, second third
            (60, 0, 14, 16, 16)),      // tail tip
        Cover = SkinCover.Wrinkles, CoverSize = 0.022f,
        TorsoLength = (1, 1.8),
        Frequency = (0, 0, 0.34),
        Dominance = (0.93, 0.98),
        Eye = (8.6, 8.2), EyeSize = 0.17,
        MouthCorner = 8, Dentition = NeedleTeeth.Teeth, Teeth = 1, ToothLength = 0.12, Nostril = 0,
        MouthOpenings = Weights.Of<double>((0, 1), (0.12, 0.6)),
        SwimmingPlans = Weights.Of((BodyPlan.Whale, 1)),
        Fins = new FinPreset
        {
            Fins = new[]
            {
                new FinSitePreset(FinPlace.Dorsal, FinStyle.Shark, 29, 0, 8, (0.19, 0.3), (0, 0), 0, 0.9),
                new FinSitePreset(FinPlace.Pectoral, FinStyle.Shark, 24, 10.4, 4, (0.32, 0.42), (0.40, 0.48), 0.6, 0.6),
            },
            Tail = TailStyle.Fluke, TailSize = (0.24, 0.3), TailFork = (0.7, 1.0),
        },
        Parts = System.Array.Empty<PartSlot>(),
        Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Saddle, 0.6), (PatternKind.Spots, 0.3)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.56, 0.03, 240)) { Kind = PatternKind.Plain, Belly = new Tint(0.9, 0.01, 230), Accent = new Tint(0.44, 0.03, 240) },
            new Colouring(new Tint(0.22, 0.015, 260)) { Pattern = new Tint(0.94, 0.01, 90), Kind = PatternKind.Patches, Scale = 0.6, Belly = new Tint(0.95, 0.01, 90), Accent = new Tint(0.2, 0.015, 260), Limb = new Tint(0.2, 0.015, 260) },
            new Colouring(new Tint(0.76, 0.07, 10)) { Kind = PatternKind.Plain, Belly = new Tint(0.9, 0.03, 20), Accent = new Tint(0.66, 0.09, 10) },
            new Colouring(new Tint(0.9, 0.01, 220)) { Kind = PatternKind.Plain },
        },
    };
}
