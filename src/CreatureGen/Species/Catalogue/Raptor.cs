using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Birds of prey.</summary>
internal static class Raptor
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = BirdParts.Common with
    {
        Body = "raptor",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -88, 10, 12, 10),      // nose
            (32, -74, 24, 28, 18),     // muzzle, front
            (42, -46, 38, 48, 30),     // muzzle
            (50, -24, 60, 72, 50),     // stop
            (55, -14, 112, 100, 80),   // brow
            (70, -4, 116, 106, 90),    // cranium
            (70, 20, 98, 92, 95),      // nape
            (80, 50, 104, 100, 105),   // neck
            (100, 48, 140, 126, 150),  // neck base
            (140, 36, 205, 166, 218),  // shoulders
            (200, 24, 230, 176, 238),  // ribs
            (200, 18, 204, 166, 212),  // belly
            (180, 12, 168, 146, 162),  // loin
            (160, 8, 128, 120, 120),   // pelvis
            (120, 6, 92, 86, 80),      // tail base
            (160, 4, 78, 45, 45),      // tail, first third
            (180, 2, 84, 28, 28),      // tail, second third
            (140, 0, 56, 10, 10)),     // tail tip
        Beaks = Weights.Of((BeakStyle.Hooked, 1.0)),
        Motion = new MotionTraits { StandingPitch = 38, BobsHead = true },
        TorsoLength = (0.2, 0.38),
        Frequency = (0.15, 0.32, 0),
        Eye = (9.8, 5.6), EyeSize = 0.36, Bone = 1.15, Mood = 0.55, LidDegrees = (50, 72),
        Bird = new BirdPreset { HipHeight = (0.57, 0.72), Thigh = (0.68, 0.80), Foot = 1.15, Claw = 1.8, FoldRing = 48, Fan = 0.17, FlightPitch = (-16, -4) },
        Parts = new[] { new PartSlot(new PartChoice(1, BirdParts.Crest(0.7)), new PartChoice(2.2)) },
        WingStyles = Weights.Of((WingStyle.Falcon, 0.6), (WingStyle.Owl, 0.4)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.42, 0.05, 58)) { Pattern = new Tint(0.26, 0.03, 50), Kind = PatternKind.Mottle, Limb = new Tint(0.80, 0.13, 90), Muzzle = new Tint(0.78, 0.15, 85) },
            new Colouring(new Tint(0.55, 0.06, 60)) { Pattern = new Tint(0.32, 0.05, 50), Kind = PatternKind.Bands, Limb = new Tint(0.78, 0.13, 88), Muzzle = new Tint(0.32, 0.02, 60) },
            new Colouring(new Tint(0.50, 0.02, 250)) { Pattern = new Tint(0.34, 0.02, 250), Kind = PatternKind.Bands, Limb = new Tint(0.78, 0.13, 88), Muzzle = new Tint(0.34, 0.02, 250) },
            new Colouring(new Tint(0.28, 0.02, 60)) { Kind = PatternKind.Plain, Belly = new Tint(0.34, 0.03, 50), Limb = new Tint(0.78, 0.14, 90), Accent = new Tint(0.92, 0.02, 90), Muzzle = new Tint(0.80, 0.15, 88) },
            new Colouring(new Tint(0.56, 0.12, 46)) { Pattern = new Tint(0.30, 0.04, 40), Kind = PatternKind.Spots, Belly = new Tint(0.86, 0.06, 75), Limb = new Tint(0.78, 0.13, 88), Muzzle = new Tint(0.4, 0.03, 240) },
        },
    };
}
