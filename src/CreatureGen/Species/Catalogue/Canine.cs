using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Dogs and their kin. A family: species start from it.</summary>
internal static class Canine
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = new SpeciesProfile("canine")
    {
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -16, 42, 36, 36),      // nose
            (30, -16, 64, 56, 54),     // muzzle, front
            (65, -16, 70, 58, 60),     // muzzle
            (65, -20, 86, 70, 70),     // stop
            (50, -24, 118, 122, 80),   // brow
            (80, -15, 142, 132, 100),  // cranium
            (100, 12, 105, 100, 105),  // nape
            (130, 60, 108, 110, 120),  // neck
            (140, 50, 125, 176, 214),  // neck base
            (140, 10, 175, 141, 325),  // shoulders
            (250, 2, 165, 113, 305),   // ribs
            (250, -3, 138, 96, 235),   // belly
            (220, 0, 101, 122, 98),    // loin
            (200, 9, 147, 93, 80),     // pelvis
            (140, 24, 60, 47, 47),     // tail base
            (160, 30, 50, 55, 55),     // tail, first third
            (180, 15, 45, 50, 50),     // tail, second third
            (160, -5, 16, 16, 16)),    // tail tip
        Class = AnimalClass.Mammal, Cover = SkinCover.Fur, CoverSize = 0.022f, Snout = SnoutKind.Leather,
        Skull = new SkullShape { Lips = 0.14, Muzzle = new[]
            {
                new HeadBump(Ring: 2.6, Segment: 7.2, RingSpread: 2.0, SegmentSpread: 2.0, Amount: 0.12),
                new HeadBump(Ring: 5.6, Segment: 7.0, RingSpread: 1.3, SegmentSpread: 2.6, Amount: -0.10),
                new HeadBump(Ring: 6.6, Segment: 0.5, RingSpread: 1.1, SegmentSpread: 2.5, Amount: -0.10),
                new HeadBump(Ring: 0.6, Segment: 2.0, RingSpread: 1.0, SegmentSpread: 3.0, Amount: 0.10),
            } },
        Antlered = true, Tusked = true, Hair = (0.22, 0.15), BackRow = 0.1, FlierLegPairs = Weights.Of((2, 1)), SwimmingHead = 4,
        TailHair = TailHair.Brush,
        TorsoLength = (0.45, 0.85),
        Frequency = (0.62, 0.4, 0.16),
        Partners = new[] { "feline", "bovine", "reptile", "avian" },
        WalkingPlans = Weights.Of((BodyPlan.Digitigrade, 0.8), (BodyPlan.Upright, 0.15), (BodyPlan.Centaur, 0.05)),
        SwimmingPlans = Weights.Of((BodyPlan.Whale, 1)),
        Eye = (9.6, 5.2), EyeSize = 0.325, EyeSink = 0.66, EyeForward = 0.65, LidDegrees = (54, 64), Bone = 1,
        Swelling = (0.10, 0.10), MouthCorner = 8, MuzzleSquareness = 2.9, Nostril = 0.19,
        HeadOrnament = (1, 0.15), Ears = Weights.Of((EarShape.Pointed, 0.6), (EarShape.Drooping, 0.25), (EarShape.Big, 0.15)), Dentition = CarnivoreTeeth.Teeth, Teeth = 1, ToothLength = 0.28,
        Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Saddle, 1.2), (PatternKind.Patches, 0.8), (PatternKind.Spots, 0.5), (PatternKind.Rosettes, 0.1)),
        Relief = TorsoRelief.Mammal,
    };
}
