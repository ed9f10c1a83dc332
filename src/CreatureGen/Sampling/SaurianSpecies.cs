using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>Reptiles with a collar: horned dinosaurs and frilled lizards.</summary>
internal static class SaurianSpecies
{
    private static readonly PartKit[] noseHorn = { Horn(2.6, 0, 0.13, 0.045, 0.2) };
    private static readonly PartKit[] browHorns = { Horn(9.2, 3.2, 0.30, 0.042, 0.5), Horn(2.6, 0, 0.07, 0.04, 0.2) };

    /// <summary>All of them, in a fixed order.</summary>
    public static readonly SpeciesProfile[] All =
    {
        SwimmerSpecies.Tamed(FamilyProfiles.Find("reptile")) with
        {
            Body = "ceratops",
            Frequency = (0.16, 0, 0),
            Dominance = (0.93, 0.98),
            Kinship = 0,
            HipHeight = (0.58, 0.69), LegGirth = 0.84,
            HeadSize = (1.1, 0.6),
            WalkingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Columnar, 1) },
            Eye = (9.6, 6.0), EyeSize = 0.22, SlitPupils = 0.3,
            MouthCorner = 7, Teeth = 0, MouthOpenings = new[] { new Weighted<double>(0, 1), new Weighted<double>(0.12, 0.5) },
            HeadOrnament = (0, 0),
            Parts = new[]
            {
                new PartSlot(new PartChoice(1) { Frill = NeckKits.Shield }),
                new PartSlot(new PartChoice(1, browHorns), new PartChoice(0.6, noseHorn)),
            },
            Colourings = new[]
            {
                new Colouring(new Tint(0.52, 0.05, 95)) { Kind = PatternKind.Mottle, Accent = new Tint(0.58, 0.14, 40), Muzzle = new Tint(0.34, 0.03, 80) },
                new Colouring(new Tint(0.50, 0.045, 240)) { Kind = PatternKind.Bands, Accent = new Tint(0.66, 0.13, 70), Muzzle = new Tint(0.3, 0.02, 240) },
                new Colouring(new Tint(0.50, 0.07, 50)) { Kind = PatternKind.Saddle, Accent = new Tint(0.50, 0.10, 195), Muzzle = new Tint(0.3, 0.02, 60) },
            },
        },
        SwimmerSpecies.Tamed(FamilyProfiles.Find("reptile")) with
        {
            Body = "lizard",
            Frequency = (0.14, 0, 0),
            Dominance = (0.93, 0.98),
            Kinship = 0,
            HeadSize = (1.12, 0.6),
            WalkingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Sprawling, 1) },
            Eye = (9.6, 5.2), EyeSize = 0.34, SlitPupils = 0.2,
            MouthCorner = 8, MouthOpenings = new[] { new Weighted<double>(0.32, 1), new Weighted<double>(0.1, 0.5), new Weighted<double>(0, 0.5) },
            HeadOrnament = (0, 0),
            Parts = new[] { new PartSlot(new PartChoice(1) { Frill = NeckKits.Fan }) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.56, 0.06, 75)) { Kind = PatternKind.Mottle, Accent = new Tint(0.62, 0.16, 45) },
                new Colouring(new Tint(0.60, 0.10, 130)) { Kind = PatternKind.Bands, Accent = new Tint(0.72, 0.15, 85) },
                new Colouring(new Tint(0.48, 0.03, 250)) { Kind = PatternKind.Bands, Accent = new Tint(0.58, 0.17, 25) },
            },
        },
    };

    private static PartKit Horn(double ring, double segment, double length, double radius, double forward) =>
        new(new FeatureBlueprint(FeatureKind.Horn, ring, segment, length, radius, 0.5, 0.6, forward, 0.15, 0.1, 0.25, -0.05, 1, 1), 0.8, 1.3);
}
