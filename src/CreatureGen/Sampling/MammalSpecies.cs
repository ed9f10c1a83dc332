using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>Mammals on land: what decides is neck and muzzle, the line of the back, hair, ears and horns.</summary>
internal static class MammalSpecies
{
    private static readonly SpeciesProfile canine = SwimmerSpecies.Tamed(FamilyProfiles.Find("canine")) with { Kinship = 0 };
    private static readonly SpeciesProfile bovine = SwimmerSpecies.Tamed(FamilyProfiles.Find("bovine")) with { Kinship = 0 };

    /// <summary>All of them, in a fixed order.</summary>
    public static readonly SpeciesProfile[] All =
    {
        Own("feline", "lion", 0.25) with
        {
            Partners = new[] { "feline", "feline", "canine", "feline" },
            HipHeight = (0.62, 0.77),
            WalkingPlans = Weights.Of((BodyPlan.Digitigrade, 1)),
            HeadSize = (1.16, 0.7),
            EyeSize = 0.33, SlitPupils = 0, Ears = Weights.Of((EarShape.Round, 1)),
            Parts = new[] { new PartSlot(new PartChoice(1) { Mane = NeckKits.Ruff }) },
            Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.70, 0.085, 75)) { Kind = PatternKind.Plain, Accent = new Tint(0.42, 0.085, 52) },
                new Colouring(new Tint(0.66, 0.075, 72)) { Kind = PatternKind.Plain, Accent = new Tint(0.26, 0.03, 50) },
                new Colouring(new Tint(0.84, 0.03, 85)) { Kind = PatternKind.Plain, Accent = new Tint(0.70, 0.06, 75) },
            },
        },
        Own("canine", "hyena", 0.18) with
        {
            Partners = new[] { "canine", "feline", "canine", "canine" },
            HipHeight = (0.65, 0.83),
            WalkingPlans = Weights.Of((BodyPlan.Digitigrade, 1)),
            HeadSize = (1.14, 0.7),
            Ears = Weights.Of((EarShape.Round, 1)), Teeth = 0.7,
            Parts = new[] { new PartSlot(new PartChoice(1) { Mane = NeckKits.Bristles }) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.62, 0.05, 75)) { Pattern = new Tint(0.28, 0.03, 60), Kind = PatternKind.Spots, Limb = new Tint(0.36, 0.035, 60), Accent = new Tint(0.36, 0.04, 60) },
                new Colouring(new Tint(0.68, 0.04, 80)) { Pattern = new Tint(0.24, 0.02, 60), Kind = PatternKind.Stripes, Accent = new Tint(0.24, 0.02, 60) },
                new Colouring(new Tint(0.40, 0.05, 55)) { Kind = PatternKind.Plain, Accent = new Tint(0.60, 0.07, 70) },
            },
        },
        bovine with
        {
            Body = "boar",
            Frequency = (0.24, 0, 0),
            HipHeight = (0.52, 0.66), LegGirth = 1.15,
            Eye = (9.6, 5.2), EyeSize = 0.2,
            HeadOrnament = (1, 0), EarSize = 0.8, Ears = Weights.Of((EarShape.Pointed, 1), (EarShape.Drooping, 0.4)),
            WalkingPlans = Weights.Of((BodyPlan.Unguligrade, 1)),
            Parts = new[]
            {
                new PartSlot(
                    new PartChoice(1, new PartKit(new FeatureBlueprint(FeatureKind.Tusk, 3.4, 10.4, 0.13, 0.022, 0.2, -0.1, 0.5, 0.7, 0.55, 0, 0, 1, 0.9), 0.7, 1.6)),
                    new PartChoice(0.4)),
                new PartSlot(new PartChoice(1) { Mane = NeckKits.Bristles }),
            },
            Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Patches, 0.6), (PatternKind.Mottle, 0.5)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.34, 0.03, 55)) { Kind = PatternKind.Plain, Accent = new Tint(0.22, 0.02, 50) },
                new Colouring(new Tint(0.78, 0.06, 25)) { Pattern = new Tint(0.28, 0.02, 50), Kind = PatternKind.Patches, Muzzle = new Tint(0.72, 0.09, 20) },
                new Colouring(new Tint(0.52, 0.09, 48)) { Kind = PatternKind.Mottle, Accent = new Tint(0.88, 0.03, 80) },
            },
        },
        Own("bovine", "horse", 0.25) with
        {
            Partners = new[] { "bovine", "bovine", "canine", "bovine" },
            HipHeight = (0.88, 1.12),
            WalkingPlans = Weights.Of((BodyPlan.Unguligrade, 1)),
            HeadSize = (1.0, 0.6),
            EyeSize = 0.33, BarPupils = 0.8, Ears = Weights.Of((EarShape.Pointed, 1)),
            Parts = new[] { new PartSlot(new PartChoice(1) { Mane = NeckKits.Falling }), new PartSlot(new PartChoice(0.15, NoseHorn(10.6, 0.42, 0.028)), new PartChoice(1)) },
            Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1), new Weighted<PatternKind>(PatternKind.Patches, 0.7), new Weighted<PatternKind>(PatternKind.Stripes, 0.6) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.46, 0.085, 48)) { Kind = PatternKind.Plain, Limb = new Tint(0.22, 0.02, 50), Accent = new Tint(0.19, 0.015, 50) },
                new Colouring(new Tint(0.58, 0.09, 58)) { Kind = PatternKind.Plain, Accent = new Tint(0.86, 0.05, 85) },
                new Colouring(new Tint(0.90, 0.012, 85)) { Pattern = new Tint(0.20, 0.01, 60), Kind = PatternKind.Stripes, Accent = new Tint(0.24, 0.01, 60) },
                new Colouring(new Tint(0.86, 0.02, 85)) { Pattern = new Tint(0.42, 0.07, 50), Kind = PatternKind.Patches, Accent = new Tint(0.88, 0.02, 85) },
                new Colouring(new Tint(0.62, 0.012, 260)) { Kind = PatternKind.Mottle, Accent = new Tint(0.82, 0.01, 260) },
            },
        },
        Own("bovine", "bison", 0.15) with
        {
            Partners = new[] { "bovine", "bovine", "canine", "bovine" },
            HipHeight = (0.72, 0.80),
            WalkingPlans = Weights.Of((BodyPlan.Unguligrade, 1)),
            HeadSize = (1.06, 0.6),
            EyeSize = 0.26,
            Parts = new[]
            {
                new PartSlot(new PartChoice(1) { Mane = NeckKits.Shag }),
                new PartSlot(new PartChoice(1, new PartKit(new FeatureBlueprint(FeatureKind.Horn, 12.4, 3.6, 0.26, 0.05, 0.5, 0.15, 0, 0.8, 0.75, 0.1, -0.3, 1, 1), 0.8, 1.3))),
            },
            Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1), new Weighted<PatternKind>(PatternKind.Saddle, 0.6) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.42, 0.06, 58)) { Kind = PatternKind.Plain, Accent = new Tint(0.24, 0.03, 50) },
                new Colouring(new Tint(0.34, 0.045, 50)) { Kind = PatternKind.Plain, Accent = new Tint(0.44, 0.07, 58) },
                new Colouring(new Tint(0.80, 0.03, 85)) { Kind = PatternKind.Plain, Accent = new Tint(0.66, 0.05, 75) },
            },
        },
        Own("bovine", "camel", 0.15) with
        {
            Partners = new[] { "bovine", "bovine", "canine", "bovine" },
            HipHeight = (0.92, 1.12),
            WalkingPlans = Weights.Of((BodyPlan.Unguligrade, 1)),
            HeadSize = (1.0, 0.6),
            EyeSize = 0.36, BarPupils = 0.8, Ears = Weights.Of((EarShape.Pointed, 1)),
            Parts = new[] { new PartSlot(new PartChoice(1) { Mane = NeckKits.Beard }) },
            Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.68, 0.075, 72)) { Kind = PatternKind.Plain, Accent = new Tint(0.48, 0.07, 60) },
                new Colouring(new Tint(0.50, 0.065, 60)) { Kind = PatternKind.Plain, Accent = new Tint(0.32, 0.045, 52) },
                new Colouring(new Tint(0.86, 0.03, 85)) { Kind = PatternKind.Plain, Accent = new Tint(0.74, 0.05, 78) },
            },
        },
        canine with
        {
            Body = "bear",
            Frequency = (0.26, 0, 0),
            HipHeight = (0.50, 0.62), LegGirth = 1.2,
            Eye = (9.0, 5.2), EyeSize = 0.19,
            HeadOrnament = (1, 0), Ears = Weights.Of((EarShape.Round, 1)), EarSize = 0.62,
            WalkingPlans = Weights.Of((BodyPlan.Plantigrade, 1)),
            Parts = System.Array.Empty<PartSlot>(),
            Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Saddle, 0.5)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.40, 0.06, 55)) { Kind = PatternKind.Plain, Muzzle = new Tint(0.56, 0.06, 65) },
                new Colouring(new Tint(0.24, 0.015, 60)) { Kind = PatternKind.Plain, Muzzle = new Tint(0.5, 0.06, 65) },
                new Colouring(new Tint(0.92, 0.02, 90)) { Kind = PatternKind.Plain },
                new Colouring(new Tint(0.92, 0.01, 90)) { Pattern = new Tint(0.22, 0.01, 60), Kind = PatternKind.Saddle, Limb = new Tint(0.22, 0.01, 60) },
            },
        },
        bovine with
        {
            Body = "rhino",
            Frequency = (0.22, 0, 0),
            HipHeight = (0.58, 0.70), LegGirth = 0.84,
            Eye = (8.8, 6.2), EyeSize = 0.24,
            HeadOrnament = (1, 0), EarSize = 0.8, Ears = Weights.Of((EarShape.Pointed, 1)),
            WalkingPlans = Weights.Of((BodyPlan.Columnar, 1)),
            Parts = new[]
            {
                new PartSlot(
                    new PartChoice(1, NoseHorn(2.2, 0.28, 0.062), NoseHorn(5.4, 0.13, 0.05)),
                    new PartChoice(0.6, NoseHorn(2.6, 0.34, 0.062))),
            },
            Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Mottle, 0.8)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.52, 0.015, 70)) { Kind = PatternKind.Plain },
                new Colouring(new Tint(0.44, 0.03, 45)) { Kind = PatternKind.Mottle },
                new Colouring(new Tint(0.60, 0.02, 230)) { Kind = PatternKind.Plain },
            },
        },
        canine with
        {
            Body = "rabbit",
            Frequency = (0.22, 0, 0),
            HeadSize = (1.2, 0.6),
            HipHeight = (0.40, 0.48), LegGirth = 0.9,
            Eye = (9.6, 6.4), EyeSize = 0.34,
            HeadOrnament = (1, 0), Ears = Weights.Of((EarShape.Long, 1), (EarShape.Drooping, 0.2)),
            Teeth = 0, MouthOpenings = new[] { new Weighted<double>(0, 1) },
            WalkingPlans = Weights.Of((BodyPlan.Plantigrade, 1)),
            Parts = new[] { new PartSlot(new PartChoice(0.12, new PartKit(new FeatureBlueprint(FeatureKind.Antler, 12, 2.0, 0.26, 0.02, 0, 0.80, -0.1, 0.5, 0.2, 0.1, 0.15, 1, 1), 0.8, 1.2)), new PartChoice(1)) },
            Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Patches, 0.6), (PatternKind.Saddle, 0.4)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.56, 0.05, 65)) { Kind = PatternKind.Mottle, Belly = new Tint(0.92, 0.01, 90), Accent = new Tint(0.92, 0.01, 90) },
                new Colouring(new Tint(0.94, 0.01, 90)) { Kind = PatternKind.Plain },
                new Colouring(new Tint(0.36, 0.02, 60)) { Pattern = new Tint(0.92, 0.01, 90), Kind = PatternKind.Patches },
                new Colouring(new Tint(0.68, 0.09, 62)) { Kind = PatternKind.Plain, Belly = new Tint(0.92, 0.02, 85) },
            },
        },
    };

    private static SpeciesProfile Own(string family, string body, double frequency) => SwimmerSpecies.Tamed(FamilyProfiles.Find(family)) with
    {
        Body = body,
        Frequency = (frequency, 0, 0),
        Dominance = (0.93, 0.98),
        Kinship = 0,
    };

    private static PartKit NoseHorn(double ring, double length, double radius) =>
        new(new FeatureBlueprint(FeatureKind.Horn, ring, 0, length, radius, 0.75, 0.55, 0.35, 0, 0.1, -0.3, 0, 1, 1), 0.8, 1.3);
}
