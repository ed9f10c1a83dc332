using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Crocodiles.</summary>
internal static class Crocodile
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Reptile.Profile.Tamed() with
    {
        Body = "crocodile",
        Table = new BodyTable(
            2.4,
            2.8,
            (0, 0, 58, 26, 24),       // nose
            (60, 0, 80, 36, 30),      // muzzle, front
            (120, 0, 80, 37, 32),     // muzzle
            (120, 0, 102, 48, 42),    // stop
            (75, -4, 134, 92, 56),    // brow
            (90, -2, 146, 80, 72),    // cranium
            (100, 4, 138, 76, 82),    // nape
            (100, 6, 142, 86, 96),    // neck
            (110, 6, 162, 100, 116),  // neck base
            (130, 4, 192, 120, 140),  // shoulders
            (240, 0, 218, 130, 156),  // ribs
            (250, 0, 218, 130, 156),  // belly
            (230, 0, 188, 125, 140),  // loin
            (200, 0, 152, 116, 120),  // pelvis
            (160, 0, 106, 102, 90),   // tail base
            (300, 0, 70, 104, 75),    // tail, first third
            (320, 0, 44, 104, 60),    // tail, second third
            (300, 0, 7, 30, 20)),     // tail tip
        TorsoLength = (0.8, 1.8),
        Frequency = (0.25, 0, 0.3),
        Eye = (10.0, 3.4), EyeSize = 0.22, EyeSink = 0.35, Bone = 0.3,
        Dentition = CrocodileTeeth.Teeth, Teeth = 1, ToothLength = 0.32, HeadOrnament = (0, 0),
        WalkingPlans = Weights.Of((BodyPlan.Sprawling, 1)),
        SwimmingPlans = Weights.Of((BodyPlan.Eel, 1)),
        Paddles = SwimmerParts.Paddling(0.085, 0.6),
        Fins = new FinPreset { Tail = TailStyle.Plain },
        Parts = new[] { new PartSlot(new PartChoice(1, SwimmerParts.Scutes())) },
        Patterns = Weights.Of((PatternKind.Bands, 1), (PatternKind.Mottle, 1)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.46, 0.06, 110)) { Pattern = new Tint(0.30, 0.04, 105), Kind = PatternKind.Bands },
            new Colouring(new Tint(0.38, 0.04, 85)) { Kind = PatternKind.Mottle },
            new Colouring(new Tint(0.64, 0.07, 80)) { Pattern = new Tint(0.42, 0.05, 70), Kind = PatternKind.Bands, Belly = new Tint(0.88, 0.04, 90) },
        },
        Feet = Weights.Of((FootStyle.Web, 1)),
        Tails = Weights.Of((TailStyle.Paddle, 0.6)),
    };
}
