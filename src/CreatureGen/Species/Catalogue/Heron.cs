using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Herons.</summary>
internal static class Heron
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = BirdParts.Common with
    {
        Body = "heron",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -6, 6, 8, 8),          // nose
            (100, -6, 20, 20, 18),     // muzzle, front
            (100, -6, 32, 33, 28),     // muzzle
            (70, -8, 47, 52, 42),      // stop
            (60, -10, 64, 68, 50),     // brow
            (70, -4, 66, 70, 55),      // cranium
            (80, 34, 50, 53, 50),      // nape
            (220, 92, 43, 44, 44),     // neck
            (240, 60, 56, 58, 66),     // neck base
            (180, 28, 118, 120, 152),  // shoulders
            (220, 22, 160, 146, 182),  // ribs
            (220, 18, 158, 146, 172),  // belly
            (200, 14, 132, 126, 142),  // loin
            (160, 12, 102, 100, 102),  // pelvis
            (100, 10, 76, 66, 66),     // tail base
            (120, 8, 72, 45, 45),      // tail, first third
            (120, 6, 62, 28, 30),      // tail, second third
            (80, 5, 20, 10, 10)),      // tail tip
        Beaks = Weights.Of((BeakStyle.Probe, 1.0)),
        Motion = new MotionTraits { StandingPitch = 32, BobsHead = true },
        TorsoLength = (0.24, 0.38),
        Frequency = (0.19, 0.22, 0),
        Eye = (9.8, 6.2), EyeSize = 0.375,
        Bird = new BirdPreset { HipHeight = (1.0, 1.33), HipSegment = 12, Thigh = (0.36, 0.46), Foot = 1.5, FoldRing = 47, Fan = 0, FlightPitch = (-14, -6) },
        Parts = new[] { new PartSlot(new PartChoice(1.5, BirdParts.Plumes()), new PartChoice(1)) },
        WingStyles = Weights.Of((WingStyle.Albatross, 0.4), (WingStyle.Owl, 0.6)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.68, 0.02, 245)) { Pattern = new Tint(0.3, 0.02, 250), Kind = PatternKind.Saddle, Limb = new Tint(0.55, 0.06, 90), Muzzle = new Tint(0.72, 0.13, 75) },
            new Colouring(new Tint(0.90, 0.01, 90)) { Kind = PatternKind.Plain, Limb = new Tint(0.28, 0.02, 60), Muzzle = new Tint(0.74, 0.14, 80) },
            new Colouring(new Tint(0.80, 0.09, 20)) { Kind = PatternKind.Plain, Limb = new Tint(0.70, 0.12, 20), Muzzle = new Tint(0.4, 0.05, 20) },
            new Colouring(new Tint(0.36, 0.06, 270)) { Pattern = new Tint(0.50, 0.06, 30), Kind = PatternKind.Saddle, Limb = new Tint(0.72, 0.14, 90), Muzzle = new Tint(0.3, 0.02, 260) },
        },
        Feet = Weights.Of((FootStyle.Talon, 1)),
    };
}
