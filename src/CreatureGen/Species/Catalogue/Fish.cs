using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Fish. A family: species start from it.</summary>
internal static class Fish
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = new SpeciesProfile("fish")
    {
        Table = new BodyTable(
            1.9,
            1.9,
            (0, 0, 30, 30, 30),       // nose
            (40, 0, 60, 60, 60),      // muzzle, front
            (60, 0, 85, 90, 85),      // muzzle
            (60, 0, 100, 120, 110),   // stop
            (60, 0, 115, 145, 135),   // brow
            (70, 0, 130, 175, 165),   // cranium
            (80, 0, 140, 200, 190),   // nape
            (80, 0, 145, 220, 210),   // neck
            (100, 0, 150, 235, 225),  // neck base
            (120, 0, 150, 245, 240),  // shoulders
            (170, 0, 150, 250, 250),  // ribs
            (170, 0, 135, 235, 235),  // belly
            (160, 0, 110, 195, 190),  // loin
            (150, 0, 80, 145, 140),   // pelvis
            (120, 0, 55, 95, 90),     // tail base
            (120, 0, 30, 52, 50),     // tail, first third
            (100, 0, 22, 45, 43),     // tail, second third
            (140, 0, 8, 30, 30)),     // tail tip
        Class = AnimalClass.Fish, Cover = SkinCover.Scales, CoverSize = 0.045f, EyeRim = EyeRim.Still,
        Skull = new SkullShape { Jowl = 0 }, WidestMouth = 0.12, BackRow = 0, FlierLegPairs = Weights.Of((0, 0.66), (1, 0.28), (2, 0.06)),
        TorsoLength = (0.18, 0.6),
        Frequency = (0.2, 0.15, 1.5),
        Partners = new[] { "serpent", "amphibian", "reptile", "avian" },
        WalkingPlans = Weights.Of((BodyPlan.Theropod, 0.4), (BodyPlan.Sprawling, 0.6)),
        SwimmingPlans = Weights.Of((BodyPlan.Fish, 0.82), (BodyPlan.Whale, 0.18)),
        Eye = (10, 7.0), EyeSize = 0.3, EyeSink = 0.62, EyeForward = 0.3, LidDegrees = (70, 80), Bone = 0,
        Swelling = (0.03, 0.02), TongueTints = Weights.Of((new Tint(0.66, 0.06, 25), 1)), MouthCorner = 5, Nostril = 0.12,
        Dentition = NeedleTeeth.Teeth, Teeth = 0.6, ToothLength = 0.16,
        Patterns = Weights.Of((PatternKind.Bands, 1), (PatternKind.Stripes, 0.6), (PatternKind.Spots, 0.8), (PatternKind.Mottle, 0.5), (PatternKind.Saddle, 0.9), (PatternKind.Turing, 0.8)),
    };
}
