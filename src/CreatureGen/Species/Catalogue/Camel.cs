using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Camels.</summary>
internal static class Camel
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Bovine.Profile.Tamed() with
    {
        Body = "camel",
        Table = new BodyTable(
            2.0,
            2.3,
            (0, -24, 56, 42, 46),      // nose
            (45, -22, 80, 56, 60),     // muzzle, front
            (70, -22, 78, 58, 62),     // muzzle
            (75, -22, 86, 72, 74),     // stop
            (70, -20, 108, 96, 88),    // brow
            (80, -10, 108, 104, 100),  // cranium
            (110, 30, 80, 85, 90),     // nape
            (220, 62, 82, 92, 98),     // neck
            (220, 30, 100, 110, 140),  // neck base
            (170, -4, 164, 152, 275),  // shoulders
            (260, 0, 210, 215, 280),   // ribs
            (260, 0, 225, 385, 290),   // belly
            (240, -2, 190, 215, 205),  // loin
            (220, 8, 172, 140, 150),   // pelvis
            (120, 30, 54, 54, 54),     // tail base
            (130, 68, 26, 28, 28),     // tail, first third
            (150, 80, 20, 22, 22),     // tail, second third
            (130, 82, 18, 20, 20)),    // tail tip
        TorsoLength = (1.25, 1.65),
        Frequency = (0.15, 0, 0),
        Dominance = (0.93, 0.98),
        Kinship = 0,
        Partners = new[] { "bovine", "bovine", "canine", "bovine" },
        HipHeight = (0.92, 1.12),
        Motion = new MotionTraits { RisesHindFirst = true },
        WalkingPlans = Weights.Of((BodyPlan.Unguligrade, 1)),
        HeadSize = (1.0, 0.6),
        EyeSize = 0.36, BarPupils = 0.8, Ears = Weights.Of((EarShape.Pointed, 1)),
        Parts = new[] { new PartSlot(new PartChoice(1) { Mane = NeckPresets.Beard }) },
        Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.68, 0.075, 72)) { Kind = PatternKind.Plain, Accent = new Tint(0.48, 0.07, 60) },
            new Colouring(new Tint(0.50, 0.065, 60)) { Kind = PatternKind.Plain, Accent = new Tint(0.32, 0.045, 52) },
            new Colouring(new Tint(0.86, 0.03, 85)) { Kind = PatternKind.Plain, Accent = new Tint(0.74, 0.05, 78) },
        },
        IsCloven = true,
    };
}
