using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Rhinos.</summary>
internal static class Rhino
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Bovine.Profile.Tamed() with
    {
        Body = "rhino",
        Table = new BodyTable(
            2.3,
            2.4,
            (0, -40, 78, 66, 62),      // nose
            (40, -40, 104, 86, 86),    // muzzle, front
            (80, -40, 104, 88, 90),    // muzzle
            (90, -38, 112, 92, 96),    // stop
            (90, -36, 138, 118, 108),  // brow
            (95, -28, 150, 136, 126),  // cranium
            (100, -6, 155, 150, 160),  // nape
            (110, 20, 185, 195, 215),  // neck
            (120, 24, 225, 260, 300),  // neck base
            (150, 8, 272, 268, 360),   // shoulders
            (270, 0, 300, 226, 352),   // ribs
            (270, 0, 306, 206, 356),   // belly
            (240, 1, 276, 236, 312),   // loin
            (220, 10, 262, 214, 232),  // pelvis
            (110, 36, 84, 88, 88),     // tail base
            (100, 78, 32, 36, 36),     // tail, first third
            (110, 82, 22, 24, 24),     // tail, second third
            (100, 84, 24, 28, 28)),    // tail tip
        Cover = SkinCover.Wrinkles, CoverSize = 0.05f,
        TorsoLength = (1.7, 2.3),
        Frequency = (0.22, 0, 0),
        Kinship = 0,
        HipHeight = (0.58, 0.70), LegGirth = 0.84,
        Eye = (8.8, 6.2), EyeSize = 0.24,
        HeadOrnament = (1, 0), EarSize = 0.8, Ears = Weights.Of((EarShape.Pointed, 1)),
        WalkingPlans = Weights.Of((BodyPlan.Columnar, 1)),
        Parts = new[]
        {
            new PartSlot(
                new PartChoice(1, MammalParts.NoseHorn(2.2, 0.28, 0.062), MammalParts.NoseHorn(5.4, 0.13, 0.05)),
                new PartChoice(0.6, MammalParts.NoseHorn(2.6, 0.34, 0.062))),
        },
        Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Mottle, 0.8)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.52, 0.015, 70)) { Kind = PatternKind.Plain },
            new Colouring(new Tint(0.44, 0.03, 45)) { Kind = PatternKind.Mottle },
            new Colouring(new Tint(0.60, 0.02, 230)) { Kind = PatternKind.Plain },
        },
        Feet = Weights.Of((FootStyle.Stump, 1)),
    };
}
