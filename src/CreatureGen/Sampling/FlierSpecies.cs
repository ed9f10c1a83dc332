using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>Fliers that are neither birds nor insects.</summary>
internal static class FlierSpecies
{
    private static readonly SpeciesProfile canine = SwimmerSpecies.Tamed(FamilyProfiles.Find("canine"));
    private static readonly SpeciesProfile reptile = SwimmerSpecies.Tamed(FamilyProfiles.Find("reptile"));

    /// <summary>All of them, in a fixed order.</summary>
    public static readonly SpeciesProfile[] All =
    {
        canine with
        {
            Body = "bat",
            Frequency = (0, 0.42, 0),
            Dominance = (0.92, 0.97),
            Kinship = 0,
            Eye = (9.4, 5.4), EyeSize = 0.24,
            HeadOrnament = (1, 0), Ears = Weights.Of((EarShape.Big, 1), (EarShape.Pointed, 0.4)),
            FlyingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Flapping, 1) },
            WingMembrane = 1, FlierLegPairs = 1, LegGirth = 0.62,
            Variety = 0.25,
            Signatures = new[] { Signature.None, Signature.BigHead, Signature.BigEyes },
            Parts = System.Array.Empty<PartSlot>(),
            Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1), new Weighted<PatternKind>(PatternKind.Saddle, 0.4) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.40, 0.05, 55)) { Kind = PatternKind.Plain, Accent = new Tint(0.3, 0.04, 40) },
                new Colouring(new Tint(0.54, 0.10, 52)) { Kind = PatternKind.Plain, Accent = new Tint(0.26, 0.03, 40) },
                new Colouring(new Tint(0.32, 0.015, 280)) { Kind = PatternKind.Plain, Accent = new Tint(0.42, 0.08, 20) },
                new Colouring(new Tint(0.86, 0.02, 90)) { Kind = PatternKind.Plain, Accent = new Tint(0.74, 0.11, 80) },
            },
        },
        reptile with
        {
            Body = "pterosaur",
            Frequency = (0, 0.42, 0),
            Dominance = (0.92, 0.97),
            Kinship = 0,
            Eye = (10, 5.6), EyeSize = 0.44,
            HeadOrnament = (0, 0),
            FlyingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Flapping, 1) },
            WingMembrane = 1, FlierLegPairs = 1, LegGirth = 0.66,
            Parts = new[]
            {
                new PartSlot(
                    new PartChoice(1.4, new PartKit(new FeatureBlueprint(FeatureKind.Plate, 12, 0, 0.34, 0.11, 0.5, 0.25, -1, 0, 0.1, 0, 0, 0.2, 0.7), 0.8, 1.3)),
                    new PartChoice(0.8, new PartKit(new FeatureBlueprint(FeatureKind.Plate, 5, 0, 0.2, 0.12, 0.9, 0.2, -0.3, 0, 0, 0, 0, 0.2, 0.6), 0.8, 1.3)),
                    new PartChoice(0.8)),
            },
            Patterns = Weights.Of((PatternKind.Saddle, 1), (PatternKind.Bands, 0.6), (PatternKind.Mottle, 0.6), (PatternKind.Plain, 0.6)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.50, 0.06, 60)) { Pattern = new Tint(0.34, 0.05, 50), Kind = PatternKind.Saddle, Accent = new Tint(0.58, 0.17, 35) },
                new Colouring(new Tint(0.44, 0.04, 240)) { Kind = PatternKind.Plain, Belly = new Tint(0.88, 0.02, 90), Accent = new Tint(0.74, 0.15, 75) },
                new Colouring(new Tint(0.72, 0.06, 85)) { Pattern = new Tint(0.48, 0.08, 40), Kind = PatternKind.Bands, Accent = new Tint(0.5, 0.12, 20) },
            },
        },
    };
}
