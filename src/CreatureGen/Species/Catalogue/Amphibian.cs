using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Toads, newts and their kin. A family: species start from it.</summary>
internal static class Amphibian
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = new SpeciesProfile("amphibian")
    {
        Table = new BodyTable(
            2.2,
            2.6,
            (0, 2, 85, 30, 30),        // nose
            (30, 2, 125, 50, 50),      // muzzle, front
            (60, 2, 160, 70, 65),      // muzzle
            (70, 2, 185, 90, 80),      // stop
            (70, 2, 200, 115, 90),     // brow
            (80, 4, 205, 120, 105),    // cranium
            (80, 8, 200, 120, 120),    // nape
            (70, 12, 195, 125, 135),   // neck
            (80, 14, 200, 135, 155),   // neck base
            (100, 16, 215, 150, 175),  // shoulders
            (180, 14, 240, 155, 200),  // ribs
            (180, 10, 235, 155, 200),  // belly
            (160, 4, 200, 140, 170),   // loin
            (150, 0, 160, 125, 130),   // pelvis
            (100, -4, 90, 80, 80),     // tail base
            (120, 0, 55, 50, 45),      // tail, first third
            (120, 0, 34, 30, 30),      // tail, second third
            (80, 0, 12, 12, 12)),      // tail tip
        Class = AnimalClass.Amphibian, Cover = SkinCover.Wrinkles, CoverSize = 0.05f,
        BackRow = 0.5, Plated = true, Shelled = true, ArmedTail = true,
        TorsoLength = (0.06, 0.16),
        Frequency = (0.4, 0, 0.15),
        Partners = new[] { "reptile", "fish", "bovine", "feline" },
        WalkingPlans = Weights.Of((BodyPlan.Sprawling, 0.86), (BodyPlan.Plantigrade, 0.14)),
        SwimmingPlans = Weights.Of((BodyPlan.Flipper, 0.45), (BodyPlan.Whale, 0.3), (BodyPlan.Fish, 0.25)),
        Eye = (9.5, 4.2), EyeSize = 0.375, EyeSink = 0.36, EyeForward = 0.45, LidDegrees = (66, 72), SlitPupils = 0.35, BarPupils = 0.5, Bone = 0,
        Swelling = (0.16, 0.06), MouthCorner = 9, Nostril = 0.12,
        HeadOrnament = (0, 0.12),
        Patterns = Weights.Of((PatternKind.Spots, 1), (PatternKind.Mottle, 0.9), (PatternKind.Patches, 0.6), (PatternKind.Bands, 0.4), (PatternKind.Turing, 0.9)),
    };
}
