using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Insects and their kin. A family: species start from it.</summary>
internal static class Insect
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = new SpeciesProfile("insect")
    {
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -35, 40, 40, 40),      // nose
            (30, -35, 75, 70, 70),     // muzzle, front
            (40, -35, 100, 92, 90),    // muzzle
            (50, -30, 120, 110, 100),  // stop
            (50, -25, 130, 130, 110),  // brow
            (60, -15, 122, 122, 110),  // cranium
            (70, 0, 82, 85, 80),       // nape
            (50, 5, 58, 60, 60),       // neck
            (60, 5, 100, 100, 100),    // neck base
            (120, 5, 155, 155, 150),   // shoulders
            (150, 2, 165, 165, 155),   // ribs
            (120, 0, 105, 105, 100),   // belly
            (120, -2, 135, 135, 130),  // loin
            (200, 0, 195, 175, 180),   // pelvis
            (220, 8, 185, 165, 170),   // tail base
            (180, 16, 135, 125, 120),  // tail, first third
            (140, 24, 78, 72, 70),     // tail, second third
            (100, 30, 16, 16, 16)),    // tail tip
        Class = AnimalClass.Arthropod, Cover = SkinCover.Plates, CoverSize = 0.09f, EyeRim = EyeRim.Bare,
        Skull = new SkullShape { Jowl = 0, Stop = 0, Chin = 0 }, LargestEye = 0.85, CompoundEyes = 0.85,
        FlierLegPairs = Weights.Of((3, 0.78), (2, 0.06), (4, 0.07), (5, 0.03), (6, 0.02), (8, 0.02), (0, 0.02)),
        TorsoLength = (0.012, 0.035),
        Annuli = new AnnuliBlueprint(41, 0.07),
        Frequency = (0.06, 0.08, 0),
        Partners = new[] { "amphibian", "reptile", "avian", "fish" },
        WalkingPlans = Weights.Of((BodyPlan.Hexapod, 1)),
        FlyingPlans = Weights.Of((BodyPlan.Buzzing, 1)),
        SwimmingPlans = Weights.Of((BodyPlan.Fish, 1)),
        Eye = (9, 6.8), EyeSize = 0.55, EyeSink = 0.45, EyeForward = 0.4, LidDegrees = (70, 80), Bone = 0,
        Nostril = 0,
        Patterns = Weights.Of((PatternKind.Bands, 1.2), (PatternKind.Plain, 0.8), (PatternKind.Spots, 0.6), (PatternKind.Saddle, 0.5)),
    };
}
