using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Newts.</summary>
internal static class Newt
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Amphibian.Profile.Tamed() with
    {
        Body = "newt",
        Table = new BodyTable(
            2.1,
            2.4,
            (0, -2, 62, 25, 25),      // nose
            (30, -2, 98, 42, 40),     // muzzle, front
            (48, -2, 124, 56, 50),    // muzzle
            (58, -2, 140, 72, 58),    // stop
            (60, -2, 150, 88, 62),    // brow
            (70, 0, 146, 88, 70),     // cranium
            (80, 4, 120, 80, 75),     // nape
            (90, 6, 116, 85, 85),     // neck
            (100, 6, 132, 95, 105),   // neck base
            (130, 4, 148, 105, 128),  // shoulders
            (220, 1, 148, 105, 132),  // ribs
            (240, 0, 146, 105, 132),  // belly
            (220, 0, 130, 100, 120),  // loin
            (180, 0, 110, 95, 105),   // pelvis
            (160, 0, 75, 95, 88),     // tail base
            (300, 0, 46, 118, 92),    // tail, first third
            (300, 0, 28, 92, 70),     // tail, second third
            (300, 0, 5, 12, 12)),     // tail tip
        TorsoLength = (0.04, 0.08),
        Frequency = (0.25, 0, 0.3),
        Eye = (9.4, 4.6), EyeSize = 0.24,
        WalkingPlans = Weights.Of((BodyPlan.Sprawling, 1)),
        SwimmingPlans = Weights.Of((BodyPlan.Eel, 1)),
        Paddles = SwimmerParts.Paddling(0.07, 0),
        Fins = new FinPreset
        {
            Fins = new[] { new FinSitePreset(FinPlace.Dorsal, FinStyle.Sail, 32, 0, 14, (0.07, 0.13), (0, 0), 0, 0.35) },
            Tail = TailStyle.Plain,
        },
        Parts = new[] { new PartSlot(new PartChoice(0.85, SwimmerParts.Gills()), new PartChoice(0.15)) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.34, 0.03, 50)) { Pattern = new Tint(0.68, 0.17, 50), Kind = PatternKind.Patches, Accent = new Tint(0.66, 0.18, 42) },
            new Colouring(new Tint(0.86, 0.05, 12)) { Kind = PatternKind.Plain, Limb = new Tint(0.8, 0.07, 12), Accent = new Tint(0.60, 0.17, 18) },
            new Colouring(new Tint(0.48, 0.08, 110)) { Pattern = new Tint(0.25, 0.03, 100), Kind = PatternKind.Spots },
            new Colouring(new Tint(0.64, 0.13, 132)) { Pattern = new Tint(0.26, 0.03, 120), Kind = PatternKind.Turing, Accent = new Tint(0.62, 0.15, 45) },
        },
        Feet = Weights.Of((FootStyle.Plain, 0.5), (FootStyle.Sucker, 0.5)),
        Tails = Weights.Of((TailStyle.Paddle, 0.5)),
    };
}
