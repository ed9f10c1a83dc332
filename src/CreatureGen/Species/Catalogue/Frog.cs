using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Frogs.</summary>
internal static class Frog
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Amphibian.Profile.Tamed() with
    {
        Body = "frog",
        Table = new BodyTable(
            2.2,
            2.5,
            (0, 10, 90, 30, 30),       // nose
            (30, 10, 135, 50, 50),     // muzzle, front
            (50, 10, 170, 72, 64),     // muzzle
            (60, 10, 195, 92, 78),     // stop
            (60, 12, 208, 118, 88),    // brow
            (70, 14, 212, 122, 102),   // cranium
            (70, 18, 206, 120, 118),   // nape
            (70, 22, 200, 124, 134),   // neck
            (80, 24, 206, 134, 154),   // neck base
            (90, 26, 222, 148, 176),   // shoulders
            (140, 26, 244, 155, 202),  // ribs
            (150, 24, 240, 152, 200),  // belly
            (130, 20, 205, 138, 170),  // loin
            (110, 16, 160, 120, 132),  // pelvis
            (60, 10, 100, 84, 84),     // tail base
            (40, 5, 56, 50, 46),       // tail, first third
            (30, 0, 34, 30, 30),       // tail, second third
            (20, 0, 12, 12, 12)),      // tail tip
        TorsoLength = (0.04, 0.13),
        Frequency = (0.36, 0, 0),
        Dominance = (0.93, 0.98),
        LatticeSpread = 0.16,
        Eye = (9.5, 4.0), EyeSize = 0.34,
        HeadOrnament = (0, 0),
        MouthOpenings = new[] { new Weighted<double>(0, 1), new Weighted<double>(0.1, 0.4) },
        WalkingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Sprawling, 1) },
        Legs = new LegPreset
        {
            Sites = new[]
            {
                new LegSite(LimbArchetype.FrogFore) { Ring = 26, Segment = 10.4, Reach = 0.95, Thickness = 0.75 },
                new LegSite(LimbArchetype.FrogHind) { Ring = 40, Segment = 9.8, Reach = 1.15 },
            },
            Reach = (0.25, 0.29), Height = (0.13, 0.19), Thickness = 0.10, Claw = 0,
        },
        Parts = System.Array.Empty<PartSlot>(),
        Colourings = new[]
        {
            new Colouring(new Tint(0.66, 0.17, 130)) { Pattern = new Tint(0.42, 0.12, 135), Kind = PatternKind.Spots },
            new Colouring(new Tint(0.60, 0.20, 32)) { Pattern = new Tint(0.22, 0.03, 260), Kind = PatternKind.Spots, Limb = new Tint(0.5, 0.16, 255) },
            new Colouring(new Tint(0.58, 0.16, 250)) { Pattern = new Tint(0.2, 0.03, 260), Kind = PatternKind.Spots },
            new Colouring(new Tint(0.82, 0.16, 92)) { Pattern = new Tint(0.2, 0.02, 60), Kind = PatternKind.Patches },
            new Colouring(new Tint(0.50, 0.07, 85)) { Pattern = new Tint(0.32, 0.05, 70), Kind = PatternKind.Mottle },
            new Colouring(new Tint(0.78, 0.14, 95)) { Pattern = new Tint(0.25, 0.03, 80), Kind = PatternKind.Turing, Limb = new Tint(0.45, 0.05, 210) },
        },
        Feet = Weights.Of((FootStyle.Web, 0.5), (FootStyle.Sucker, 0.5)),
    };
}
