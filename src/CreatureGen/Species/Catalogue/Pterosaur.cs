using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Pterosaurs.</summary>
internal static class Pterosaur
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Reptile.Profile.Tamed() with
    {
        Body = "pterosaur",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -12, 8, 10, 9),        // nose
            (110, -12, 20, 24, 20),    // muzzle, front
            (120, -12, 32, 36, 30),    // muzzle
            (100, -13, 46, 52, 44),    // stop
            (70, -14, 70, 72, 56),     // brow
            (70, -6, 74, 74, 60),      // cranium
            (70, 26, 58, 58, 56),      // nape
            (140, 66, 56, 58, 60),     // neck
            (140, 62, 72, 74, 86),     // neck base
            (130, 38, 120, 120, 150),  // shoulders
            (180, 16, 140, 130, 160),  // ribs
            (170, 10, 128, 118, 142),  // belly
            (150, 8, 104, 98, 112),    // loin
            (130, 6, 76, 76, 78),      // pelvis
            (60, 6, 42, 42, 42),       // tail base
            (60, 4, 26, 26, 26),       // tail, first third
            (50, 2, 16, 16, 16),       // tail, second third
            (40, 0, 8, 8, 8)),         // tail tip
        Cover = SkinCover.Wrinkles, CoverSize = 0.05f,
        Motion = new MotionTraits { StandingPitch = 30 },
        TorsoLength = (0.3, 0.9),
        Frequency = (0, 0.42, 0),
        Dominance = (0.92, 0.97),
        Kinship = 0,
        Eye = (10, 5.6), EyeSize = 0.44,
        Dentition = NeedleTeeth.Teeth, ToothLength = 0.2, HeadOrnament = (0, 0),
        FlyingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Flapping, 1) },
        WingMembrane = 1, FlierLegPairs = Weights.Of((1, 1)), LegGirth = 0.66,
        Parts = new[]
        {
            new PartSlot(
                new PartChoice(1.4, new PartPreset(new FeatureBlueprint(FeatureKind.Plate, Ring: 12, Segment: 0, Length: 0.34, Radius: 0.11, Outward: 0.5, Upward: 0.25, Forward: -1, Sideward: 0, BendUp: 0.1, BendForward: 0, BendSide: 0, Flatness: 0.2, Taper: 0.7), 0.8, 1.3)),
                new PartChoice(0.8, new PartPreset(new FeatureBlueprint(FeatureKind.Plate, Ring: 5, Segment: 0, Length: 0.2, Radius: 0.12, Outward: 0.9, Upward: 0.2, Forward: -0.3, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 0.2, Taper: 0.6), 0.8, 1.3)),
                new PartChoice(0.8)),
        },
        Patterns = Weights.Of((PatternKind.Saddle, 1), (PatternKind.Bands, 0.6), (PatternKind.Mottle, 0.6), (PatternKind.Plain, 0.6)),
        WingStyles = Weights.Of((WingStyle.Pterosaur, 1)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.50, 0.06, 60)) { Pattern = new Tint(0.34, 0.05, 50), Kind = PatternKind.Saddle, Accent = new Tint(0.58, 0.17, 35) },
            new Colouring(new Tint(0.44, 0.04, 240)) { Kind = PatternKind.Plain, Belly = new Tint(0.88, 0.02, 90), Accent = new Tint(0.74, 0.15, 75) },
            new Colouring(new Tint(0.72, 0.06, 85)) { Pattern = new Tint(0.48, 0.08, 40), Kind = PatternKind.Bands, Accent = new Tint(0.5, 0.12, 20) },
        },
    };
}
