using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Rabbits.</summary>
internal static class Rabbit
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Canine.Profile.Tamed() with
    {
        Body = "rabbit",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -24, 34, 32, 32),      // nose
            (24, -24, 62, 54, 54),     // muzzle, front
            (42, -24, 78, 66, 66),     // muzzle
            (45, -28, 100, 92, 82),    // stop
            (42, -30, 122, 118, 92),   // brow
            (60, -16, 128, 122, 98),   // cranium
            (70, 18, 104, 104, 100),   // nape
            (70, 50, 102, 106, 112),   // neck
            (80, 44, 120, 126, 140),   // neck base
            (110, 16, 150, 152, 178),  // shoulders
            (190, -8, 178, 178, 205),  // ribs
            (190, -2, 200, 196, 215),  // belly
            (170, 16, 206, 202, 205),  // loin
            (150, 34, 172, 168, 165),  // pelvis
            (60, -20, 75, 78, 78),     // tail base
            (50, -40, 62, 64, 64),     // tail, first third
            (40, -40, 44, 46, 46),     // tail, second third
            (30, -40, 14, 14, 14)),    // tail tip
        TailHair = TailHair.Scut,
        TorsoLength = (0.2, 0.34),
        Frequency = (0.22, 0, 0),
        Kinship = 0,
        HeadSize = (1.2, 0.6),
        HipHeight = (0.40, 0.48), LegGirth = 0.9,
        Eye = (9.6, 6.4), EyeSize = 0.34,
        HeadOrnament = (1, 0), Ears = Weights.Of((EarShape.Long, 1), (EarShape.Drooping, 0.2)),
        Dentition = GnawerTeeth.Teeth, ToothLength = 0.3, MouthOpenings = new[] { new Weighted<double>(0, 1) },
        WalkingPlans = Weights.Of((BodyPlan.Plantigrade, 1)),
        Parts = new[] { new PartSlot(new PartChoice(0.12, new PartPreset(new FeatureBlueprint(FeatureKind.Antler, Ring: 12, Segment: 2.0, Length: 0.26, Radius: 0.02, Outward: 0, Upward: 0.80, Forward: -0.1, Sideward: 0.5, BendUp: 0.2, BendForward: 0.1, BendSide: 0.15, Flatness: 1, Taper: 1), 0.8, 1.2)), new PartChoice(1)) },
        Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Patches, 0.6), (PatternKind.Saddle, 0.4)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.56, 0.05, 65)) { Kind = PatternKind.Mottle, Belly = new Tint(0.92, 0.01, 90), Accent = new Tint(0.92, 0.01, 90) },
            new Colouring(new Tint(0.94, 0.01, 90)) { Kind = PatternKind.Plain },
            new Colouring(new Tint(0.36, 0.02, 60)) { Pattern = new Tint(0.92, 0.01, 90), Kind = PatternKind.Patches },
            new Colouring(new Tint(0.68, 0.09, 62)) { Kind = PatternKind.Plain, Belly = new Tint(0.92, 0.02, 85) },
        },
    };
}
