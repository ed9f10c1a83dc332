using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Bears.</summary>
internal static class Bear
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Canine.Profile.Tamed() with
    {
        Body = "bear",
        Table = new BodyTable(
            2.1,
            2.3,
            (0, -18, 54, 44, 46),      // nose
            (28, -18, 82, 66, 68),     // muzzle, front
            (46, -18, 92, 72, 74),     // muzzle
            (46, -28, 122, 96, 92),    // stop
            (50, -36, 176, 156, 112),  // brow
            (85, -22, 206, 178, 134),  // cranium
            (95, 2, 165, 150, 140),    // nape
            (110, 34, 175, 170, 185),  // neck
            (120, 32, 200, 236, 200),  // neck base
            (150, 12, 250, 262, 303),  // shoulders
            (260, 2, 256, 236, 293),   // ribs
            (250, -3, 267, 205, 312),  // belly
            (230, 2, 239, 232, 225),   // loin
            (210, 14, 239, 188, 160),  // pelvis
            (90, 28, 95, 74, 74),      // tail base
            (50, 52, 55, 58, 58),      // tail, first third
            (50, 52, 38, 42, 42),      // tail, second third
            (40, 52, 14, 14, 14)),     // tail tip
        TailHair = TailHair.Scut,
        TorsoLength = (0.85, 1.4),
        Frequency = (0.26, 0, 0),
        Kinship = 0,
        HipHeight = (0.50, 0.62), LegGirth = 1.2,
        Eye = (9.0, 5.2), EyeSize = 0.19,
        HeadOrnament = (1, 0), Ears = Weights.Of((EarShape.Round, 1)), EarSize = 0.62,
        WalkingPlans = Weights.Of((BodyPlan.Plantigrade, 1)),
        Parts = System.Array.Empty<PartSlot>(),
        Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Saddle, 0.5)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.40, 0.06, 55)) { Kind = PatternKind.Plain, Muzzle = new Tint(0.56, 0.06, 65) },
            new Colouring(new Tint(0.24, 0.015, 60)) { Kind = PatternKind.Plain, Muzzle = new Tint(0.5, 0.06, 65) },
            new Colouring(new Tint(0.92, 0.02, 90)) { Kind = PatternKind.Plain },
            new Colouring(new Tint(0.92, 0.01, 90)) { Pattern = new Tint(0.22, 0.01, 60), Kind = PatternKind.Saddle, Limb = new Tint(0.22, 0.01, 60) },
        },
    };
}
