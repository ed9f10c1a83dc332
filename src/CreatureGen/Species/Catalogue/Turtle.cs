using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Turtles.</summary>
internal static class Turtle
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Reptile.Profile.Tamed() with
    {
        Body = "turtle",
        Table = new BodyTable(
            2.1,
            3.0,
            (0, -30, 20, 20, 18),      // nose
            (34, -24, 52, 46, 35),     // muzzle, front
            (42, -16, 72, 62, 45),     // muzzle
            (48, -12, 88, 80, 55),     // stop
            (50, -10, 100, 92, 62),    // brow
            (60, 0, 98, 90, 70),       // cranium
            (70, 10, 82, 74, 74),      // nape
            (80, 14, 86, 76, 82),      // neck
            (90, 12, 116, 86, 96),     // neck base
            (100, 6, 225, 115, 105),   // shoulders
            (150, 2, 338, 168, 110),   // ribs
            (170, 0, 368, 188, 110),   // belly
            (170, -3, 342, 172, 105),  // loin
            (150, -6, 252, 126, 95),   // pelvis
            (110, -8, 132, 76, 70),    // tail base
            (70, 0, 56, 45, 45),       // tail, first third
            (60, 0, 36, 30, 30),       // tail, second third
            (50, 0, 8, 8, 8)),         // tail tip
        TorsoLength = (0.25, 1),
        Frequency = (0.28, 0, 0.36),
        Dominance = (0.93, 0.98),
        Signatures = new[] { Signature.None, Signature.BigHead, Signature.BigEyes },
        Shell = new ShellBlueprint(ShellStyle.Carapace, Ring: 24, Rows: 21, Columns: 7, Rise: 0.10),
        Eye = (9.0, 5.6), EyeSize = 0.30,
        MouthCorner = 7, Teeth = 0, HeadOrnament = (0, 0), Mood = 0.1,
        MouthOpenings = Weights.Of<double>((0, 1), (0.08, 0.6)),
        WalkingPlans = Weights.Of((BodyPlan.Sprawling, 1)),
        SwimmingPlans = Weights.Of((BodyPlan.Flipper, 1)),
        Fins = new FinPreset
        {
            Fins = new[]
            {
                new FinSitePreset(FinPlace.Pectoral, FinStyle.Paddle, 26, 9.6, 4, (0.62, 0.75), (0.30, 0.38), 0.35, 0.6),
                new FinSitePreset(FinPlace.Pectoral, FinStyle.Paddle, 41, 10, 4, (0.28, 0.34), (0.6, 0.6), 0.4, 0.6),
            },
            Tail = TailStyle.Plain,
        },
        Parts = System.Array.Empty<PartSlot>(),
        Patterns = Weights.Of((PatternKind.Patches, 1), (PatternKind.Spots, 0.6), (PatternKind.Mottle, 0.4)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.55, 0.07, 125)) { Pattern = new Tint(0.34, 0.05, 120), Kind = PatternKind.Patches },
            new Colouring(new Tint(0.50, 0.07, 90)) { Pattern = new Tint(0.3, 0.04, 70), Kind = PatternKind.Patches },
            new Colouring(new Tint(0.52, 0.06, 210)) { Pattern = new Tint(0.34, 0.05, 220), Kind = PatternKind.Spots },
            new Colouring(new Tint(0.36, 0.03, 60)) { Pattern = new Tint(0.76, 0.14, 85), Kind = PatternKind.Turing, Accent = new Tint(0.62, 0.18, 40) },
        },
        Feet = Weights.Of((FootStyle.Web, 1)),
        Relief = System.Array.Empty<HeadBump>(),
    };
}
