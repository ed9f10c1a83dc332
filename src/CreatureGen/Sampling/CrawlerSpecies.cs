using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>Frogs and snakes.</summary>
internal static class CrawlerSpecies
{
    /// <summary>All of them, in a fixed order.</summary>
    public static readonly SpeciesProfile[] All =
    {
        SwimmerSpecies.Tamed(FamilyProfiles.Find("amphibian")) with
        {
            Body = "frog",
            Frequency = (0.36, 0, 0),
            Dominance = (0.93, 0.98),
            LatticeSpread = 0.16,
            Eye = (9.5, 4.0), EyeSize = 0.34,
            HeadOrnament = (0, 0),
            MouthOpenings = new[] { new Weighted<double>(0, 1), new Weighted<double>(0.1, 0.4) },
            WalkingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Sprawling, 1) },
            Legs = new LegKit
            {
                Sites = new[] { new LegSite(LimbArchetype.FrogFore, 26, 10.4, 0, 0.95, 0.75), new LegSite(LimbArchetype.FrogHind, 40, 9.8, 0, 1.15, 1) },
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
        },
        SwimmerSpecies.Tamed(FamilyProfiles.Find("serpent")) with
        {
            Body = "cobra",
            Frequency = (0.17, 0, 0),
            LatticeSpread = 0.16,
            Eye = (9.6, 5.4), EyeSize = 0.30,
            HeadOrnament = (0, 0),
            WalkingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Legless, 1) },
            Parts = System.Array.Empty<PartSlot>(),
            Colourings = new[]
            {
                new Colouring(new Tint(0.55, 0.07, 75)) { Pattern = new Tint(0.32, 0.05, 60), Kind = PatternKind.Bands },
                new Colouring(new Tint(0.36, 0.03, 60)) { Pattern = new Tint(0.7, 0.09, 85), Kind = PatternKind.Bands },
                new Colouring(new Tint(0.60, 0.13, 130)) { Kind = PatternKind.Plain },
            },
        },
    };
}
