using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Cocks of the farmyard.</summary>
internal static class Rooster
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = BirdParts.Common with
    {
        Body = "rooster",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -26, 12, 14, 12),      // nose
            (34, -24, 30, 32, 24),     // muzzle, front
            (44, -14, 42, 48, 38),     // muzzle
            (44, -12, 62, 70, 54),     // stop
            (48, -10, 80, 92, 70),     // brow
            (58, 0, 86, 94, 80),       // cranium
            (70, 34, 84, 84, 86),      // nape
            (120, 66, 98, 98, 108),    // neck
            (130, 62, 132, 130, 152),  // neck base
            (130, 38, 176, 160, 210),  // shoulders
            (190, 10, 206, 172, 244),  // ribs
            (190, -4, 206, 166, 226),  // belly
            (160, -16, 182, 152, 178), // loin
            (140, -28, 146, 132, 134), // pelvis
            (100, -42, 100, 96, 84),   // tail base
            (130, -52, 78, 56, 50),    // tail, first third
            (130, -56, 58, 34, 30),    // tail, second third
            (90, -58, 30, 12, 12)),    // tail tip
        Beaks = Weights.Of((BeakStyle.Conical, 1.0)),
        Motion = new MotionTraits { StandingPitch = 16, BobsHead = true },
        TorsoLength = (0.2, 0.27),
        Frequency = (0.14, 0.1, 0),
        OnlyByName = true,
        Dominance = (0.93, 0.98),
        Kinship = 0,
        Eye = (10.2, 6.4), EyeSize = 0.3,
        Bird = new BirdPreset { HipHeight = (0.56, 0.64), Thigh = (0.50, 0.60), Foot = 1, FoldRing = 45, Fan = 0.12 },
        Parts = new[] { new PartSlot(new PartChoice(1, Flesh())) },
        WingStyles = Weights.Of((WingStyle.Feathered, 1)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.46, 0.12, 45)) { Kind = PatternKind.Plain, Belly = new Tint(0.24, 0.03, 160), Limb = new Tint(0.70, 0.12, 85), Accent = new Tint(0.26, 0.05, 165), Muzzle = new Tint(0.72, 0.12, 80) },
            new Colouring(new Tint(0.92, 0.02, 90)) { Kind = PatternKind.Plain, Limb = new Tint(0.74, 0.14, 80), Accent = new Tint(0.90, 0.02, 90), Muzzle = new Tint(0.76, 0.13, 82) },
            new Colouring(new Tint(0.24, 0.02, 260)) { Kind = PatternKind.Plain, Limb = new Tint(0.34, 0.03, 250), Accent = new Tint(0.28, 0.06, 165), Muzzle = new Tint(0.40, 0.05, 70) },
            new Colouring(new Tint(0.70, 0.04, 80)) { Pattern = new Tint(0.28, 0.02, 260), Kind = PatternKind.Bands, Limb = new Tint(0.74, 0.14, 80), Accent = new Tint(0.30, 0.02, 260), Muzzle = new Tint(0.74, 0.12, 80) },
        },
    };

    /// <summary>A comb over the crown and a wattle on either side of the throat.</summary>
    private static PartPreset[] Flesh() => new[]
    {
        new PartPreset(new FeatureBlueprint(FeatureKind.Comb, Ring: 11.4, Segment: 0, Length: 0.13, Radius: 0.036, Outward: 0.9, Upward: 0.2, Forward: -0.15, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 0.34, Taper: 1), 0.85, 1.3),
        new PartPreset(new FeatureBlueprint(FeatureKind.Comb, Ring: 7.4, Segment: 12.6, Length: 0.1, Radius: 0.026, Outward: 0.25, Upward: -1, Forward: -0.1, Sideward: 0.1, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 0.5, Taper: 1), 0.85, 1.3),
    };
}
