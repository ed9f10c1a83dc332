using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Frilled lizards.</summary>
internal static class Lizard
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Reptile.Profile.Tamed() with
    {
        Body = "lizard",
        Table = new BodyTable(
            2.2,
            2.7,
            (0, -6, 36, 24, 24),      // nose
            (35, -6, 60, 42, 38),     // muzzle, front
            (50, -6, 80, 56, 50),     // muzzle
            (60, -8, 102, 72, 60),    // stop
            (60, -8, 122, 98, 70),    // brow
            (80, -4, 126, 98, 82),    // cranium
            (90, 8, 102, 84, 86),     // nape
            (90, 20, 94, 82, 90),     // neck
            (110, 20, 112, 95, 105),  // neck base
            (120, 8, 142, 116, 130),  // shoulders
            (220, 0, 166, 126, 150),  // ribs
            (210, 0, 168, 128, 152),  // belly
            (200, 0, 146, 116, 130),  // loin
            (180, 2, 120, 100, 108),  // pelvis
            (160, 6, 82, 78, 76),     // tail base
            (340, 8, 52, 52, 50),     // tail, first third
            (420, 4, 28, 28, 28),     // tail, second third
            (400, -2, 9, 9, 9)),      // tail tip
        TorsoLength = (0.06, 0.2),
        Frequency = (0.14, 0, 0),
        Dominance = (0.93, 0.98),
        Kinship = 0,
        HeadSize = (1.12, 0.6),
        WalkingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Sprawling, 1) },
        Eye = (9.6, 5.2), EyeSize = 0.34, SlitPupils = 0.2,
        MouthCorner = 8, MouthOpenings = new[] { new Weighted<double>(0.32, 1), new Weighted<double>(0.1, 0.5), new Weighted<double>(0, 0.5) },
        HeadOrnament = (0, 0),
        Parts = new[] { new PartSlot(new PartChoice(1) { Frill = NeckPresets.Fan }) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.56, 0.06, 75)) { Kind = PatternKind.Mottle, Accent = new Tint(0.62, 0.16, 45) },
            new Colouring(new Tint(0.60, 0.10, 130)) { Kind = PatternKind.Bands, Accent = new Tint(0.72, 0.15, 85) },
            new Colouring(new Tint(0.48, 0.03, 250)) { Kind = PatternKind.Bands, Accent = new Tint(0.58, 0.17, 25) },
        },
        WingStyles = Weights.Of((WingStyle.GlidingLizard, 0.6), (WingStyle.Dragon, 0.4)),
        Tails = Weights.Of((TailStyle.Whip, 0.35), (TailStyle.Prehensile, 0.15)),
    };
}
