using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Ducks.</summary>
internal static class Duck
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = BirdParts.Common with
    {
        Body = "duck",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -8, 58, 12, 12),        // nose
            (50, -8, 74, 18, 16),       // muzzle, front
            (60, -10, 64, 28, 22),      // muzzle
            (50, -14, 60, 56, 42),      // stop
            (50, -12, 86, 102, 70),     // brow
            (70, -6, 96, 112, 85),      // cranium
            (70, 24, 80, 85, 82),       // nape
            (100, 76, 74, 76, 78),      // neck
            (120, 66, 102, 100, 120),   // neck base
            (140, 30, 175, 150, 190),   // shoulders
            (220, 8, 240, 172, 232),    // ribs
            (240, 0, 245, 172, 222),    // belly
            (200, -4, 205, 152, 182),   // loin
            (160, -10, 152, 122, 130),  // pelvis
            (100, -18, 104, 82, 85),    // tail base
            (100, -24, 88, 45, 50),     // tail, first third
            (100, -26, 74, 25, 30),     // tail, second third
            (60, -28, 30, 10, 10)),     // tail tip
        Beaks = Weights.Of((BeakStyle.Flat, 1.0)),
        Motion = new MotionTraits { StandingPitch = 20, BobsHead = true },
        TorsoLength = (0.2, 0.3),
        Frequency = (0.19, 0.25, 0),
        Eye = (10.2, 6.2), EyeSize = 0.30,
        Bird = new BirdPreset { HipHeight = (0.46, 0.55), Thigh = (0.46, 0.58), Foot = 1.15, Claw = 0.3, HipSegment = 9.6, FoldRing = 46.5, Fan = 0.10 },
        Parts = new[] { new PartSlot(new PartChoice(1, BirdParts.Crest(0.6)), new PartChoice(3)) },
        WingStyles = Weights.Of((WingStyle.Falcon, 0.5), (WingStyle.Feathered, 0.5)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.80, 0.02, 90)) { Kind = PatternKind.Plain, Limb = new Tint(0.66, 0.14, 55), Muzzle = new Tint(0.72, 0.15, 62) },
            new Colouring(new Tint(0.56, 0.05, 70)) { Pattern = new Tint(0.38, 0.05, 60), Kind = PatternKind.Mottle, Limb = new Tint(0.62, 0.15, 50), Accent = new Tint(0.45, 0.11, 160), Muzzle = new Tint(0.74, 0.14, 85) },
            new Colouring(new Tint(0.86, 0.10, 95)) { Kind = PatternKind.Plain, Limb = new Tint(0.66, 0.15, 55), Muzzle = new Tint(0.70, 0.16, 58) },
            new Colouring(new Tint(0.30, 0.04, 250)) { Kind = PatternKind.Plain, Belly = new Tint(0.90, 0.01, 90), Limb = new Tint(0.60, 0.14, 50), Accent = new Tint(0.90, 0.01, 90), Muzzle = new Tint(0.55, 0.10, 240) },
            new Colouring(new Tint(0.50, 0.11, 40)) { Kind = PatternKind.Plain, Belly = new Tint(0.62, 0.10, 60), Limb = new Tint(0.32, 0.03, 60), Accent = new Tint(0.34, 0.08, 160), Muzzle = new Tint(0.24, 0.02, 60) },
        },
        Feet = Weights.Of((FootStyle.Web, 1)),
    };
}
