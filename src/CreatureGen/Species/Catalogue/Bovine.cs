using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Cattle and their kin: hoofed mammals. A family: species start from it.</summary>
internal static class Bovine
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = new SpeciesProfile("bovine")
    {
        Table = new BodyTable(
            2.3,
            2.4,
            (0, -38, 70, 55, 55),      // nose
            (45, -36, 108, 80, 76),    // muzzle, front
            (65, -36, 98, 80, 76),     // muzzle
            (75, -38, 100, 98, 85),    // stop
            (80, -38, 128, 115, 95),   // brow
            (80, -30, 135, 120, 110),  // cranium
            (100, 0, 125, 120, 130),   // nape
            (130, 42, 140, 160, 180),  // neck
            (140, 34, 165, 236, 328),  // neck base
            (150, 6, 212, 187, 415),   // shoulders
            (260, 1, 241, 144, 395),   // ribs
            (260, -1, 287, 120, 430),  // belly
            (240, 0, 247, 170, 352),   // loin
            (220, 4, 229, 150, 231),   // pelvis
            (140, 24, 69, 78, 78),     // tail base
            (130, 70, 28, 30, 30),     // tail, first third
            (160, 80, 22, 24, 24),     // tail, second third
            (160, 82, 26, 30, 30)),    // tail tip
        Class = AnimalClass.Mammal, Cover = SkinCover.Fur, CoverSize = 0.016f, Snout = SnoutKind.Leather,
        Skull = new SkullShape { Lips = 0.14, Muzzle = new[]
            {
                new HeadBump(Ring: 1.4, Segment: 6.5, RingSpread: 1.6, SegmentSpread: 3.0, Amount: 0.10),
                new HeadBump(Ring: 5.5, Segment: 6.0, RingSpread: 1.8, SegmentSpread: 2.5, Amount: -0.08),
            } }, WidestMouth = 0, Dentition = GrazerTeeth.Teeth, Teeth = 1, ToothLength = 0.18,
        IsHoofed = true, HornsBesideEars = true, Antlered = true, Tusked = true, FallingMane = 0.3, Shelled = true, FlierLegPairs = Weights.Of((2, 1)),
        TailHair = TailHair.Tuft,
        TorsoLength = (1, 1.7),
        Frequency = (0.45, 0, 0),
        Partners = new[] { "canine", "amphibian", "reptile", "feline" },
        Motion = new MotionTraits { RisesHindFirst = true },
        WalkingPlans = Weights.Of((BodyPlan.Unguligrade, 0.56), (BodyPlan.Columnar, 0.4), (BodyPlan.Centaur, 0.04)),
        SwimmingPlans = Weights.Of((BodyPlan.Whale, 1)),
        Eye = (9.6, 6.0), EyeSize = 0.35, EyeSink = 0.64, EyeForward = 0.4, LidDegrees = (50, 64), Bone = 0.8,
        Swelling = (0.10, 0.08), BarPupils = 0.55, TongueTints = Weights.Of((new Tint(0.60, 0.10, 14), 1), (new Tint(0.30, 0.045, 285), 0.35)), MouthCorner = 7, MuzzleSquareness = 2.9, Nostril = 0.19,
        HeadOrnament = (1, 0.85), Ears = Weights.Of((EarShape.Sideways, 1)),
        Patterns = Weights.Of((PatternKind.Patches, 1.2), (PatternKind.Plain, 0.9), (PatternKind.Stripes, 0.7), (PatternKind.Saddle, 0.8), (PatternKind.Giraffe, 1), (PatternKind.Rosettes, 0.15)),
        IsCloven = true,
        Relief = TorsoRelief.Mammal,
    };
}
