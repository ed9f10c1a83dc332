using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Owls.</summary>
internal static class Owl
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = BirdParts.Common with
    {
        Body = "owl",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -95, 10, 12, 12),      // nose
            (18, -88, 20, 24, 18),     // muzzle, front
            (22, -66, 34, 44, 30),     // muzzle
            (26, -34, 110, 96, 88),    // stop
            (40, -8, 176, 142, 134),   // brow
            (70, 8, 182, 146, 142),    // cranium
            (60, 40, 164, 132, 138),   // nape
            (60, 62, 150, 126, 132),   // neck
            (80, 70, 158, 136, 154),   // neck base
            (130, 66, 184, 158, 188),  // shoulders
            (180, 62, 196, 166, 200),  // ribs
            (180, 56, 180, 154, 180),  // belly
            (150, 48, 145, 130, 144),  // loin
            (120, 34, 104, 98, 102),   // pelvis
            (100, 30, 84, 70, 70),     // tail base
            (110, 28, 76, 40, 40),     // tail, first third
            (110, 26, 72, 24, 24),     // tail, second third
            (80, 24, 40, 10, 10)),     // tail tip
        Beaks = Weights.Of((BeakStyle.Hooked, 1.0)),
        Motion = new MotionTraits { StandingPitch = 48, BobsHead = true },
        TorsoLength = (0.12, 0.28),
        Frequency = (0.17, 0.2, 0),
        Eye = (8.6, 4.6), EyeSize = 0.40, EyeForward = 2, Bone = 1.15, Mood = 0.4, LidDegrees = (54, 72),
        Bird = new BirdPreset { HipHeight = (0.34, 0.44), Thigh = (0.50, 0.62), Foot = 0.9, Claw = 1.5, FoldRing = 47, Fan = 0.11, FlightPitch = (-40, -26) },
        Parts = new[] { new PartSlot(new PartChoice(1.3, new PartPreset(new FeatureBlueprint(FeatureKind.Tuft, Ring: 11.5, Segment: 3.2, Length: 0.17, Radius: 0.045, Outward: 0.5, Upward: 0.8, Forward: 0, Sideward: 0.3, BendUp: 0, BendForward: -0.2, BendSide: 0, Flatness: 0.5, Taper: 0.7), 0.8, 1.3)), new PartChoice(1)) },
        WingStyles = Weights.Of((WingStyle.Owl, 1)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.55, 0.06, 62)) { Pattern = new Tint(0.32, 0.04, 55), Kind = PatternKind.Mottle, Limb = new Tint(0.6, 0.05, 70), Muzzle = new Tint(0.3, 0.02, 60) },
            new Colouring(new Tint(0.88, 0.02, 85)) { Pattern = new Tint(0.4, 0.03, 60), Kind = PatternKind.Spots, Muzzle = new Tint(0.3, 0.02, 60) },
            new Colouring(new Tint(0.42, 0.04, 50)) { Pattern = new Tint(0.7, 0.05, 75), Kind = PatternKind.Spots, Muzzle = new Tint(0.75, 0.1, 85) },
            new Colouring(new Tint(0.66, 0.09, 65)) { Pattern = new Tint(0.46, 0.06, 55), Kind = PatternKind.Mottle, Belly = new Tint(0.93, 0.02, 85), Muzzle = new Tint(0.78, 0.08, 60) },
        },
    };
}
