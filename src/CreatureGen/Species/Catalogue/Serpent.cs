using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Snakes and their kin. A family: species start from it.</summary>
internal static class Serpent
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = new SpeciesProfile("serpent")
    {
        Table = new BodyTable(
            2.0,
            2.4,
            (0, -6, 32, 24, 20),       // nose
            (30, -6, 56, 40, 34),      // muzzle, front
            (60, -6, 70, 50, 40),      // muzzle
            (70, -8, 90, 62, 45),      // stop
            (60, -8, 106, 78, 55),     // brow
            (80, -2, 114, 75, 60),     // cranium
            (100, 14, 90, 70, 65),     // nape
            (180, 45, 80, 80, 80),     // neck
            (220, 48, 86, 90, 90),     // neck base
            (250, 25, 100, 100, 100),  // shoulders
            (350, 5, 115, 115, 110),   // ribs
            (350, 0, 120, 120, 115),   // belly
            (350, 0, 115, 115, 110),   // loin
            (320, 0, 105, 105, 100),   // pelvis
            (300, 0, 90, 90, 85),      // tail base
            (350, 2, 70, 70, 65),      // tail, first third
            (350, 2, 45, 45, 42),      // tail, second third
            (300, -4, 12, 12, 12)),    // tail tip
        Class = AnimalClass.Reptile, Cover = SkinCover.Scales, CoverSize = 0.034f, EyeRim = EyeRim.Still,
        BackRow = 0.5, Plated = true, SwimmingNeckDrop = 20,
        TorsoLength = (0.6, 1.8),
        Frequency = (0.38, 0.22, 0.2),
        Partners = new[] { "reptile", "fish", "feline", "amphibian" },
        WalkingPlans = Weights.Of((BodyPlan.ManyLegged, 0.42), (BodyPlan.Legless, 0.34), (BodyPlan.Sprawling, 0.24)),
        SwimmingPlans = Weights.Of((BodyPlan.Eel, 0.75), (BodyPlan.Fish, 0.25)),
        Eye = (9.6, 5.6), EyeSize = 0.3125, EyeSink = 0.56, EyeForward = 0.4, LidDegrees = (56, 72), SlitPupils = 0.75, Bone = 0.6,
        Swelling = (0.12, 0.12), Tongue = TongueStyle.Forked, TongueTints = Weights.Of((new Tint(0.40, 0.07, 300), 0.7), (new Tint(0.56, 0.17, 20), 1)), MouthCorner = 9, Nostril = 0.15, Mood = 0.55,
        HeadOrnament = (0, 0.35), Dentition = FangTeeth.Teeth, Teeth = 0.9, ToothLength = 0.4,
        Patterns = Weights.Of((PatternKind.Bands, 1.4), (PatternKind.Spots, 0.6), (PatternKind.Stripes, 0.6), (PatternKind.Mottle, 0.5)),
    };
}
