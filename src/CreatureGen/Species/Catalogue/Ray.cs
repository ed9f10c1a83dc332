using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Rays.</summary>
internal static class Ray
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Fish.Profile.Tamed() with
    {
        Body = "ray",
        Table = new BodyTable(
            0.86,
            1.0,
            (0, 0, 60, 28, 22),      // nose
            (40, 0, 110, 44, 34),    // muzzle, front
            (50, 0, 150, 60, 44),    // muzzle
            (60, 0, 190, 76, 54),    // stop
            (60, 0, 260, 90, 62),    // brow
            (70, 0, 370, 102, 68),   // cranium
            (80, 0, 490, 108, 72),   // nape
            (90, 0, 610, 108, 74),   // neck
            (100, 0, 680, 106, 74),  // neck base
            (120, 0, 660, 102, 70),  // shoulders
            (130, 0, 545, 92, 64),   // ribs
            (120, 0, 405, 78, 55),   // belly
            (100, 0, 272, 62, 45),   // loin
            (80, 0, 150, 46, 36),    // pelvis
            (80, 0, 72, 36, 30),     // tail base
            (300, 0, 24, 22, 22),    // tail, first third
            (400, 0, 14, 14, 14),    // tail, second third
            (350, 0, 5, 5, 5)),      // tail tip
        Cover = SkinCover.Wrinkles, CoverSize = 0.022f,
        TorsoLength = (0.4, 1.5),
        Frequency = (0, 0, 0.38),
        Dominance = (0.93, 0.98),
        Kinship = 0,
        HeadSize = (1, 0.2),
        Signatures = new[] { Signature.None, Signature.BigEyes },
        Disc = (0.42, -0.28, 0.38),
        Eye = (6.4, 3.0), EyeSize = 0.20, EyeSink = 0.4,
        Skull = new SkullShape { Jowl = 0, Muzzle = new[] { new HeadBump(6.6, 3.2, 1.7, 1.5, 0.55) } },
        MouthCorner = 2, MouthOpenings = Weights.Of<double>((0.04, 1), (0.12, 1), (0, 1)), Teeth = 0, Nostril = 0, Bone = 0, Swelling = (0, 0),
        SwimmingPlans = Weights.Of((BodyPlan.Whale, 1)),
        Fins = new FinPreset
        {
            Fins = new[] { new FinSitePreset(FinPlace.Pectoral, FinStyle.Ray, 43, 10, 4, (0.10, 0.13), (0.9, 1), 0.05, 0.9) },
            Tail = TailStyle.Plain,
        },
        Parts = new[]
        {
            new PartSlot(
                new PartChoice(1, new PartPreset(new FeatureBlueprint(FeatureKind.Scute, Ring: 1.5, Segment: 8, Length: 0.24, Radius: 0.055, Outward: 0, Upward: -0.1, Forward: 1, Sideward: 0.05, BendUp: -0.15, BendForward: 0, BendSide: -0.2, Flatness: 0.4, Taper: 0.55), 0.8, 1.15)),
                new PartChoice(0.8)),
            new PartSlot(new PartChoice(1, new PartPreset(new FeatureBlueprint(FeatureKind.Spike, Ring: 48, Segment: 0, Length: 0.24, Radius: 0.02, Outward: 0.1, Upward: 0.03, Forward: -1, Sideward: 0, BendUp: 0, BendForward: -0.2, BendSide: 0, Flatness: 1, Taper: 1), 0.8, 1.2)), new PartChoice(1)),
        },
        Patterns = Weights.Of((PatternKind.Spots, 1), (PatternKind.Mottle, 1), (PatternKind.Plain, 0.6)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.32, 0.03, 250)) { Pattern = new Tint(0.8, 0.02, 90), Kind = PatternKind.Spots, Belly = new Tint(0.88, 0.01, 240) },
            new Colouring(new Tint(0.55, 0.06, 75)) { Pattern = new Tint(0.38, 0.05, 65), Kind = PatternKind.Mottle, Belly = new Tint(0.88, 0.02, 80) },
            new Colouring(new Tint(0.42, 0.09, 255)) { Pattern = new Tint(0.72, 0.11, 230), Kind = PatternKind.Spots, Belly = new Tint(0.9, 0.02, 240) },
            new Colouring(new Tint(0.66, 0.11, 85)) { Pattern = new Tint(0.44, 0.12, 255), Kind = PatternKind.Spots, Scale = 1.3, Belly = new Tint(0.92, 0.02, 90) },
            new Colouring(new Tint(0.24, 0.015, 270)) { Kind = PatternKind.Plain, Belly = new Tint(0.93, 0.01, 240) },
        },
    };
}
