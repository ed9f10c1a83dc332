using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Lizards, dinosaurs and their kin. A family: species start from it.</summary>
internal static class Reptile
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = new SpeciesProfile("reptile")
    {
        Table = new BodyTable(
            2.2,
            2.8,
            (0, -4, 40, 24, 26),       // nose
            (50, -4, 60, 35, 36),      // muzzle, front
            (110, -4, 68, 40, 40),     // muzzle
            (120, -4, 92, 56, 50),     // stop
            (80, -5, 122, 90, 60),     // brow
            (90, -3, 140, 88, 75),     // cranium
            (100, 4, 128, 80, 85),     // nape
            (90, 12, 120, 85, 90),     // neck
            (100, 14, 128, 81, 124),   // neck base
            (120, 8, 162, 88, 169),    // shoulders
            (260, 0, 214, 120, 195),   // ribs
            (260, 0, 237, 124, 203),   // belly
            (250, 1, 174, 111, 143),   // loin
            (220, 2, 168, 91, 108),    // pelvis
            (160, 6, 110, 80, 80),     // tail base
            (300, 6, 78, 75, 70),      // tail, first third
            (340, 0, 45, 50, 40),      // tail, second third
            (300, -6, 12, 14, 14)),    // tail tip
        Class = AnimalClass.Reptile, Cover = SkinCover.Scales, CoverSize = 0.04f,
        Tusked = true, Collar = 0.14, BackRow = 0.5, Plated = true, Shelled = true, ArmedTail = true,
        TorsoLength = (0.25, 0.7),
        Frequency = (0.45, 0.65, 0.3),
        Partners = new[] { "amphibian", "serpent", "canine", "avian" },
        WalkingPlans = Weights.Of((BodyPlan.Sprawling, 0.45), (BodyPlan.Theropod, 0.33), (BodyPlan.Plantigrade, 0.22)),
        SwimmingPlans = Weights.Of((BodyPlan.Flipper, 0.65), (BodyPlan.Fish, 0.2), (BodyPlan.Whale, 0.15)),
        Eye = (9.6, 4.8), EyeSize = 0.3125, EyeSink = 0.56, EyeForward = 0.4, LidDegrees = (56, 72), SlitPupils = 0.75, Bone = 0.8,
        Swelling = (0.16, 0.08), MouthCorner = 9, Nostril = 0.15, Mood = 0.55, TongueTints = Weights.Of((new Tint(0.60, 0.115, 14), 1), (new Tint(0.50, 0.13, 255), 0.25), (new Tint(0.30, 0.05, 350), 0.3)),
        HeadOrnament = (0.04, 0.4), Teeth = 0.8, ToothLength = 0.2,
        Patterns = Weights.Of((PatternKind.Bands, 1), (PatternKind.Mottle, 1), (PatternKind.Stripes, 0.8), (PatternKind.Patches, 0.4), (PatternKind.Saddle, 0.3), (PatternKind.Rosettes, 0.12), (PatternKind.Giraffe, 0.15)),
        Relief = TorsoRelief.Reptile,
    };
}
