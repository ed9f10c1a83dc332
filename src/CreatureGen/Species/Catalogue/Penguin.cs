using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Penguins.</summary>
internal static class Penguin
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = BirdParts.Common with
    {
        Body = "penguin",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -10, 14, 14, 12),      // nose
            (46, -10, 26, 28, 22),     // muzzle, front
            (50, -12, 42, 48, 38),     // muzzle
            (46, -16, 74, 78, 58),     // stop
            (46, -16, 102, 104, 78),   // brow
            (66, 0, 112, 110, 90),     // cranium
            (66, 46, 108, 102, 100),   // nape
            (66, 72, 120, 112, 120),   // neck
            (90, 76, 150, 132, 150),   // neck base
            (140, 74, 192, 158, 196),  // shoulders
            (210, 70, 214, 168, 222),  // ribs
            (210, 68, 214, 164, 220),  // belly
            (180, 66, 182, 150, 180),  // loin
            (150, 58, 130, 126, 134),  // pelvis
            (90, 40, 86, 80, 76),      // tail base
            (70, 34, 70, 50, 46),      // tail, first third
            (60, 30, 56, 30, 30),      // tail, second third
            (50, 28, 30, 12, 12)),     // tail tip
        Beaks = Weights.Of((BeakStyle.Conical, 0.5), (BeakStyle.Hooked, 0.5)),
        Motion = new MotionTraits { StandingPitch = 62, Waddles = true, BobsHead = true },
        TorsoLength = (0.3, 0.65),
        Frequency = (0.16, 0, 0),
        Dominance = (0.93, 0.98),
        Eye = (9.8, 6.0), EyeSize = 0.26,
        Bird = new BirdPreset { HipHeight = (0.2, 0.27), Thigh = (0.6, 0.7), Foot = 1.2, Claw = 0.5, FoldRing = 41, Fan = 0.08 },
        Parts = new[] { new PartSlot(new PartChoice(1, BirdParts.Brows()), new PartChoice(2)) },
        Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1), new Weighted<PatternKind>(PatternKind.Saddle, 0.5) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.25, 0.02, 260)) { Kind = PatternKind.Plain, Belly = new Tint(0.95, 0.01, 90), Limb = new Tint(0.3, 0.02, 60), Accent = new Tint(0.80, 0.15, 80), Muzzle = new Tint(0.62, 0.17, 50) },
            new Colouring(new Tint(0.46, 0.05, 250)) { Kind = PatternKind.Plain, Belly = new Tint(0.94, 0.01, 220), Limb = new Tint(0.72, 0.08, 30), Accent = new Tint(0.36, 0.05, 250), Muzzle = new Tint(0.3, 0.02, 260) },
            new Colouring(new Tint(0.40, 0.015, 250)) { Kind = PatternKind.Plain, Belly = new Tint(0.93, 0.01, 90), Limb = new Tint(0.66, 0.15, 55), Accent = new Tint(0.84, 0.16, 92), Muzzle = new Tint(0.55, 0.15, 40) },
        },
        Feet = Weights.Of((FootStyle.Web, 1)),
    };
}
