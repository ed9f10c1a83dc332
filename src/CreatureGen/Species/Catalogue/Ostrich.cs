using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Ostriches.</summary>
internal static class Ostrich
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = BirdParts.Common with
    {
        Body = "ostrich",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -12, 24, 12, 10),       // nose
            (40, -12, 42, 22, 18),      // muzzle, front
            (50, -12, 52, 36, 30),      // muzzle
            (50, -12, 62, 58, 46),      // stop
            (50, -10, 74, 76, 56),      // brow
            (60, 0, 72, 73, 60),        // cranium
            (70, 40, 54, 56, 56),       // nape
            (300, 80, 48, 50, 50),      // neck
            (340, 78, 60, 62, 70),      // neck base
            (180, 50, 160, 165, 205),   // shoulders
            (220, 14, 270, 228, 290),   // ribs
            (260, 2, 300, 240, 295),    // belly
            (220, -6, 262, 230, 235),   // loin
            (180, -14, 185, 185, 165),  // pelvis
            (100, -18, 125, 105, 92),   // tail base
            (100, -15, 112, 62, 62),    // tail, first third
            (90, -10, 92, 36, 40),      // tail, second third
            (60, -5, 30, 12, 12)),      // tail tip
        Beaks = Weights.Of((BeakStyle.Flat, 1.0)),
        Motion = new MotionTraits { StandingPitch = 15, BobsHead = true },
        TorsoLength = (0.7, 0.95),
        Frequency = (0.19, 0, 0),
        Eye = (10.0, 6.0), EyeSize = 0.44,
        Bird = new BirdPreset { HipHeight = (1.07, 1.3), HipSegment = 11.8, Thigh = (0.56, 0.66), Toes = 2, FoldRing = 43, Fan = 0.12 },
        Parts = new[] { new PartSlot(new PartChoice(1, BirdParts.Crest(0.8)), new PartChoice(2)) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.28, 0.015, 60)) { Kind = PatternKind.Plain, Limb = new Tint(0.68, 0.05, 40), Accent = new Tint(0.85, 0.02, 80), Muzzle = new Tint(0.62, 0.08, 45) },
            new Colouring(new Tint(0.52, 0.04, 70)) { Kind = PatternKind.Mottle, Limb = new Tint(0.62, 0.06, 50), Muzzle = new Tint(0.6, 0.06, 60) },
            new Colouring(new Tint(0.24, 0.02, 270)) { Kind = PatternKind.Plain, Limb = new Tint(0.5, 0.03, 70), Accent = new Tint(0.50, 0.16, 250), Muzzle = new Tint(0.50, 0.15, 250) },
        },
        Feet = Weights.Of((FootStyle.Plain, 1)),
    };
}
