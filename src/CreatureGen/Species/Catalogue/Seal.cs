using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Seals.</summary>
internal static class Seal
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Canine.Profile.Tamed() with
    {
        Body = "seal",
        Table = new BodyTable(
            2.1,
            2.3,
            (0, -14, 52, 40, 40),      // nose
            (28, -14, 82, 56, 56),     // muzzle, front
            (36, -14, 94, 62, 62),     // muzzle
            (45, -18, 104, 78, 72),    // stop
            (50, -18, 126, 108, 88),   // brow
            (70, -8, 136, 118, 104),   // cranium
            (80, 12, 128, 116, 116),   // nape
            (110, 32, 142, 136, 146),  // neck
            (130, 30, 178, 170, 190),  // neck base
            (150, 16, 218, 200, 232),  // shoulders
            (220, 4, 242, 210, 242),   // ribs
            (220, 0, 236, 200, 222),   // belly
            (200, -2, 202, 172, 182),  // loin
            (180, -3, 152, 132, 132),  // pelvis
            (130, -3, 96, 86, 86),     // tail base
            (120, 0, 60, 50, 50),      // tail, first third
            (100, 0, 42, 35, 35),      // tail, second third
            (100, 0, 22, 15, 15)),     // tail tip
        TailHair = null,
        TorsoLength = (0.8, 1.4),
        Frequency = (0, 0, 0.3),
        Eye = (8.8, 5.6), EyeSize = 0.30,
        HeadOrnament = (0, 0), 
        MouthOpenings = Weights.Of<double>((0, 1), (0.1, 0.4)),
        SwimmingPlans = Weights.Of((BodyPlan.Whale, 1)),
        Fins = new FinPreset
        {
            Fins = new[] { new FinSitePreset(FinPlace.Pectoral, FinStyle.Paddle, 27, 10.6, 4, (0.42, 0.55), (0.5, 0.6), 0.75, 0.6) },
            Tail = TailStyle.Fluke, TailSize = (0.19, 0.23), TailFork = (0.8, 1.1),
        },
        Parts = new[]
        {
            new PartSlot(new PartChoice(2.2), new PartChoice(1, new PartPreset(new FeatureBlueprint(FeatureKind.Tusk, Ring: 3, Segment: 10.8, Length: 0.24, Radius: 0.026, Outward: 0, Upward: -1, Forward: 0.3, Sideward: 0.08, BendUp: 0, BendForward: -0.25, BendSide: 0, Flatness: 1, Taper: 0.8), 0.8, 1.3))),
        },
        Colourings = new[]
        {
            new Colouring(new Tint(0.52, 0.02, 70)) { Pattern = new Tint(0.3, 0.02, 60), Kind = PatternKind.Spots },
            new Colouring(new Tint(0.36, 0.02, 60)) { Kind = PatternKind.Plain },
            new Colouring(new Tint(0.78, 0.02, 85)) { Pattern = new Tint(0.45, 0.02, 60), Kind = PatternKind.Mottle },
        },
        Feet = Weights.Of((FootStyle.Web, 1)),
    };
}
