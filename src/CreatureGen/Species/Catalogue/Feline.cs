using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Cats and their kin. A family: species start from it.</summary>
internal static class Feline
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = new SpeciesProfile("feline")
    {
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -10, 45, 34, 36),      // nose
            (25, -10, 72, 52, 56),     // muzzle, front
            (40, -10, 86, 60, 68),     // muzzle
            (45, -16, 104, 80, 80),    // stop
            (45, -22, 136, 128, 90),   // brow
            (80, -15, 152, 138, 102),  // cranium
            (100, 10, 108, 100, 100),  // nape
            (110, 56, 100, 105, 110),  // neck
            (130, 44, 122, 160, 184),  // neck base
            (130, 8, 159, 137, 244),   // shoulders
            (260, -2, 152, 105, 248),  // ribs
            (270, -4, 136, 95, 224),   // belly
            (240, 2, 106, 119, 138),   // loin
            (220, 10, 148, 106, 110),  // pelvis
            (130, 22, 57, 45, 45),     // tail base
            (280, 35, 42, 42, 42),     // tail, first third
            (300, 5, 40, 40, 40),      // tail, second third
            (260, -45, 28, 28, 28)),   // tail tip
        Class = AnimalClass.Mammal, Cover = SkinCover.Fur, CoverSize = 0.022f, Snout = SnoutKind.Leather,
        Motion = new MotionTraits { IsSupple = true },
        Skull = new SkullShape { Lips = 0.14, Muzzle = new[]
            {
                new HeadBump(Ring: 2.6, Segment: 7.2, RingSpread: 2.0, SegmentSpread: 2.0, Amount: 0.12),
                new HeadBump(Ring: 5.6, Segment: 7.0, RingSpread: 1.3, SegmentSpread: 2.6, Amount: -0.10),
                new HeadBump(Ring: 6.6, Segment: 0.5, RingSpread: 1.1, SegmentSpread: 2.5, Amount: -0.10),
                new HeadBump(Ring: 0.6, Segment: 2.0, RingSpread: 1.0, SegmentSpread: 3.0, Amount: 0.10),
            } },
        Hair = (0.22, 0.4), BackRow = 0.1, FlierLegPairs = Weights.Of((2, 1)),
        TorsoLength = (0.32, 0.75),
        Frequency = (0.75, 0.5, 0),
        Partners = new[] { "canine", "reptile", "avian", "serpent" },
        WalkingPlans = Weights.Of((BodyPlan.Digitigrade, 0.58), (BodyPlan.Plantigrade, 0.22), (BodyPlan.Upright, 0.17), (BodyPlan.Centaur, 0.03)),
        SwimmingPlans = Weights.Of((BodyPlan.Whale, 1)),
        Eye = (9.6, 5.0), EyeSize = 0.375, EyeSink = 0.60, EyeForward = 0.75, LidDegrees = (56, 66), SlitPupils = 0.75, Bone = 0.9,
        Swelling = (0.08, 0.13), MouthCorner = 7, MuzzleSquareness = 2.9, Nostril = 0.19,
        HeadOrnament = (1, 0.12), Ears = Weights.Of((EarShape.Pointed, 0.6), (EarShape.Round, 0.4)), Dentition = CarnivoreTeeth.Teeth, Teeth = 1, ToothLength = 0.3,
        Patterns = Weights.Of((PatternKind.Stripes, 1), (PatternKind.Spots, 0.8), (PatternKind.Plain, 0.6), (PatternKind.Saddle, 0.3), (PatternKind.Rosettes, 1.3), (PatternKind.Giraffe, 0.3)),
        Relief = TorsoRelief.Mammal,
    };
}
