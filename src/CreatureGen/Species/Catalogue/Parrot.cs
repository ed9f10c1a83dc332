using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Parrots.</summary>
internal static class Parrot
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = BirdParts.Common with
    {
        Body = "parrot",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -100, 12, 13, 13),     // nose
            (30, -84, 32, 36, 26),     // muzzle, front
            (40, -58, 48, 60, 42),     // muzzle
            (50, -32, 68, 90, 60),     // stop
            (50, -14, 112, 118, 90),   // brow
            (70, 0, 122, 120, 100),    // cranium
            (70, 22, 108, 102, 100),   // nape
            (80, 52, 112, 106, 115),   // neck
            (90, 54, 138, 126, 150),   // neck base
            (130, 50, 172, 152, 182),  // shoulders
            (180, 46, 182, 156, 188),  // ribs
            (180, 44, 168, 146, 168),  // belly
            (160, 42, 138, 126, 132),  // loin
            (140, 42, 108, 100, 96),   // pelvis
            (120, 44, 82, 70, 70),     // tail base
            (220, 46, 62, 42, 42),     // tail, first third
            (260, 48, 52, 26, 26),     // tail, second third
            (200, 50, 30, 10, 10)),    // tail tip
        Beaks = Weights.Of((BeakStyle.Parrot, 1.0)),
        Motion = new MotionTraits { StandingPitch = 40, BobsHead = true },
        TorsoLength = (0.1, 0.28),
        Frequency = (0.15, 0.25, 0),
        Eye = (10.4, 6.4), EyeSize = 0.275,
        Bird = new BirdPreset { HipHeight = (0.44, 0.52), Thigh = (0.48, 0.60), Foot = 0.9, FoldRing = 47.5, Fan = 0.11, FlightPitch = (-34, -40) },
        Parts = new[] { new PartSlot(new PartChoice(1.2, BirdParts.Crest(1)), new PartChoice(1)) },
        Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1), new Weighted<PatternKind>(PatternKind.Saddle, 0.7), new Weighted<PatternKind>(PatternKind.Patches, 0.4) },
        WingStyles = Weights.Of((WingStyle.Feathered, 0.6), (WingStyle.Falcon, 0.4)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.58, 0.20, 28)) { Kind = PatternKind.Plain, Accent = new Tint(0.55, 0.16, 255), Muzzle = new Tint(0.25, 0.02, 60) },
            new Colouring(new Tint(0.66, 0.18, 138)) { Kind = PatternKind.Plain, Accent = new Tint(0.60, 0.20, 30), Muzzle = new Tint(0.75, 0.12, 75) },
            new Colouring(new Tint(0.58, 0.15, 245)) { Kind = PatternKind.Plain, Belly = new Tint(0.82, 0.16, 92), Accent = new Tint(0.82, 0.16, 92), Muzzle = new Tint(0.25, 0.02, 60) },
            new Colouring(new Tint(0.88, 0.04, 95)) { Kind = PatternKind.Plain, Accent = new Tint(0.85, 0.16, 95), Muzzle = new Tint(0.35, 0.02, 60) },
            new Colouring(new Tint(0.62, 0.02, 250)) { Kind = PatternKind.Plain, Belly = new Tint(0.76, 0.02, 250), Accent = new Tint(0.52, 0.20, 25), Muzzle = new Tint(0.24, 0.02, 60) },
            new Colouring(new Tint(0.80, 0.16, 95)) { Kind = PatternKind.Plain, Belly = new Tint(0.86, 0.13, 98), Accent = new Tint(0.62, 0.16, 140), Muzzle = new Tint(0.78, 0.06, 60) },
            new Colouring(new Tint(0.48, 0.14, 300)) { Kind = PatternKind.Plain, Accent = new Tint(0.72, 0.16, 60), Muzzle = new Tint(0.25, 0.02, 60) },
        },
    };
}
