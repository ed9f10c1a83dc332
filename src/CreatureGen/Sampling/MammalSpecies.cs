using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>Mammals with hair of their own: manes, bristles and humps.</summary>
internal static class MammalSpecies
{
    /// <summary>All of them, in a fixed order.</summary>
    public static readonly SpeciesProfile[] All =
    {
        Own("feline", "lion", 0.25) with
        {
            Partners = new[] { "feline", "feline", "canine", "feline" },
            Carriage = (0, 0.5),
            WalkingPlans = Only(BodyPlan.Digitigrade),
            HeadSize = (1.16, 0.7),
            EyeSize = 0.33, SlitPupils = 0, EarShape = "round",
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
            Carriage = (0.1, 0.7),
            WalkingPlans = Only(BodyPlan.Digitigrade),
            HeadSize = (1.14, 0.7),
            EarShape = "round", Teeth = 0.7,
            Parts = new[] { new PartSlot(new PartChoice(1) { Mane = NeckKits.Bristles }) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.62, 0.05, 75)) { Pattern = new Tint(0.28, 0.03, 60), Kind = PatternKind.Spots, Limb = new Tint(0.36, 0.035, 60), Accent = new Tint(0.36, 0.04, 60) },
                new Colouring(new Tint(0.68, 0.04, 80)) { Pattern = new Tint(0.24, 0.02, 60), Kind = PatternKind.Stripes, Accent = new Tint(0.24, 0.02, 60) },
                new Colouring(new Tint(0.40, 0.05, 55)) { Kind = PatternKind.Plain, Accent = new Tint(0.60, 0.07, 70) },
            },
        },
        Own("canine", "boar", 0.2) with
        {
            Partners = new[] { "bovine", "canine", "bovine", "canine" },
            Carriage = (0, 0.12),
            WalkingPlans = Only(BodyPlan.Unguligrade),
            HeadSize = (1.08, 0.6), SwimmingPlans = System.Array.Empty<Weighted<BodyPlan>>(),
            EyeSize = 0.24, EarShape = "pointed", Teeth = 0, MouthOpenings = new[] { new Weighted<double>(0, 1), new Weighted<double>(0.08, 0.5) },
            Parts = new[]
            {
                new PartSlot(new PartChoice(1) { Mane = NeckKits.Bristles }),
                new PartSlot(new PartChoice(1, new PartKit(new FeatureBlueprint(FeatureKind.Tusk, 3.6, 10.4, 0.12, 0.02, 0.35, 0.35, 0.4, 0.5, 0.55, 0, -0.1, 1, 0.9), 0.7, 1.4))),
            },
            Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1), new Weighted<PatternKind>(PatternKind.Mottle, 0.6), new Weighted<PatternKind>(PatternKind.Patches, 0.5) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.38, 0.03, 60)) { Kind = PatternKind.Mottle, Accent = new Tint(0.25, 0.02, 55) },
                new Colouring(new Tint(0.52, 0.06, 60)) { Kind = PatternKind.Plain, Accent = new Tint(0.32, 0.04, 55) },
                new Colouring(new Tint(0.76, 0.06, 30)) { Pattern = new Tint(0.3, 0.02, 40), Kind = PatternKind.Patches, Accent = new Tint(0.55, 0.06, 45) },
            },
        },
        Own("bovine", "horse", 0.25) with
        {
            Partners = new[] { "bovine", "bovine", "canine", "bovine" },
            Carriage = (0.4, 1),
            WalkingPlans = Only(BodyPlan.Unguligrade),
            HeadSize = (1.0, 0.6),
            EyeSize = 0.33, BarPupils = 0.8, EarShape = "pointed",
            Parts = new[] { new PartSlot(new PartChoice(1) { Mane = NeckKits.Falling }) },
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
            Carriage = (0, 0.2),
            WalkingPlans = Only(BodyPlan.Unguligrade),
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
            Carriage = (0.5, 1),
            WalkingPlans = Only(BodyPlan.Unguligrade),
            HeadSize = (1.0, 0.6),
            EyeSize = 0.36, BarPupils = 0.8, EarShape = "pointed",
            Parts = new[] { new PartSlot(new PartChoice(1) { Mane = NeckKits.Beard }) },
            Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.68, 0.075, 72)) { Kind = PatternKind.Plain, Accent = new Tint(0.48, 0.07, 60) },
                new Colouring(new Tint(0.50, 0.065, 60)) { Kind = PatternKind.Plain, Accent = new Tint(0.32, 0.045, 52) },
                new Colouring(new Tint(0.86, 0.03, 85)) { Kind = PatternKind.Plain, Accent = new Tint(0.74, 0.05, 78) },
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

    private static Weighted<BodyPlan>[] Only(BodyPlan plan) => new[] { new Weighted<BodyPlan>(plan, 1) };
}
