using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Toucans.</summary>
internal static class Toucan
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = BirdParts.Common with
    {
        Body = "toucan",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -40, 12, 16, 14),      // nose
            (60, -26, 34, 52, 40),     // muzzle, front
            (90, -12, 46, 74, 56),     // muzzle
            (80, -10, 62, 84, 60),     // stop
            (55, -10, 104, 104, 80),   // brow
            (66, 0, 114, 110, 94),     // cranium
            (70, 24, 96, 92, 92),      // nape
            (80, 52, 102, 98, 106),    // neck
            (90, 52, 130, 120, 142),   // neck base
            (130, 46, 164, 144, 174),  // shoulders
            (180, 42, 174, 148, 180),  // ribs
            (180, 40, 160, 138, 160),  // belly
            (160, 38, 132, 120, 126),  // loin
            (140, 38, 104, 96, 92),    // pelvis
            (120, 40, 80, 68, 68),     // tail base
            (200, 42, 62, 42, 42),     // tail, first third
            (220, 44, 52, 26, 26),     // tail, second third
            (160, 46, 30, 10, 10)),    // tail tip
        Beaks = Weights.Of((BeakStyle.Large, 1.0)),
        Motion = new MotionTraits { StandingPitch = 40, BobsHead = true },
        TorsoLength = (0.15, 0.24),
        Frequency = (0.14, 0.22, 0),
        Dominance = (0.92, 0.97),
        Eye = (10.6, 6.2), EyeSize = 0.28,
        Bird = new BirdPreset { HipHeight = (0.44, 0.52), Thigh = (0.48, 0.60), Foot = 0.9, FoldRing = 47, Fan = 0.11, FlightPitch = (-34, -34) },
        Parts = System.Array.Empty<PartSlot>(),
        WingStyles = Weights.Of((WingStyle.Feathered, 1)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.24, 0.015, 270)) { Kind = PatternKind.Plain, Belly = new Tint(0.93, 0.03, 95), Limb = new Tint(0.45, 0.06, 240), Accent = new Tint(0.36, 0.06, 270), Muzzle = new Tint(0.74, 0.17, 65) },
            new Colouring(new Tint(0.26, 0.02, 150)) { Kind = PatternKind.Plain, Belly = new Tint(0.86, 0.15, 100), Limb = new Tint(0.45, 0.06, 240), Accent = new Tint(0.56, 0.19, 28), Muzzle = new Tint(0.72, 0.16, 130) },
            new Colouring(new Tint(0.34, 0.05, 30)) { Kind = PatternKind.Plain, Belly = new Tint(0.62, 0.17, 30), Limb = new Tint(0.4, 0.04, 60), Accent = new Tint(0.84, 0.15, 92), Muzzle = new Tint(0.24, 0.02, 60) },
            new Colouring(new Tint(0.92, 0.02, 90)) { Pattern = new Tint(0.24, 0.02, 260), Kind = PatternKind.Saddle, Limb = new Tint(0.55, 0.13, 40), Accent = new Tint(0.24, 0.02, 260), Muzzle = new Tint(0.66, 0.18, 45) },
            new Colouring(new Tint(0.44, 0.10, 150)) { Kind = PatternKind.Plain, Belly = new Tint(0.66, 0.13, 150), Limb = new Tint(0.4, 0.05, 150), Accent = new Tint(0.6, 0.17, 35), Muzzle = new Tint(0.84, 0.14, 95) },
        },
    };
}
