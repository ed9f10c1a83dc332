using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>Mammals on land: what decides is neck and muzzle, the line of the back, ears and horns.</summary>
internal static class MammalSpecies
{
    private static readonly SpeciesProfile canine = SwimmerSpecies.Tamed(FamilyProfiles.Find("canine")) with { Kinship = 0 };
    private static readonly SpeciesProfile bovine = SwimmerSpecies.Tamed(FamilyProfiles.Find("bovine")) with { Kinship = 0 };

    /// <summary>All of them, in a fixed order.</summary>
    public static readonly SpeciesProfile[] All =
    {
        canine with
        {
            Body = "bear",
            Frequency = (0.26, 0, 0),
            HipHeight = (0.50, 0.62), LegGirth = 1.2,
            Eye = (9.0, 5.2), EyeSize = 0.19,
            HeadOrnament = (1, 0), Ears = Ears((EarShape.Round, 1)), EarSize = 0.62,
            WalkingPlans = Only(BodyPlan.Plantigrade),
            Parts = System.Array.Empty<PartSlot>(),
            Patterns = Patterns((PatternKind.Plain, 1), (PatternKind.Saddle, 0.5)),
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
            Body = "boar",
            Frequency = (0.24, 0, 0),
            HipHeight = (0.52, 0.66), LegGirth = 1.15,
            Eye = (9.6, 5.2), EyeSize = 0.2,
            HeadOrnament = (1, 0), EarSize = 0.8, Ears = Ears((EarShape.Pointed, 1), (EarShape.Drooping, 0.4)),
            WalkingPlans = Only(BodyPlan.Unguligrade),
            Parts = new[]
            {
                new PartSlot(
                    new PartChoice(1, new PartKit(new FeatureBlueprint(FeatureKind.Tusk, 3.4, 10.4, 0.13, 0.022, 0.2, -0.1, 0.5, 0.7, 0.55, 0, 0, 1, 0.9), 0.7, 1.6)),
                    new PartChoice(0.4)),
                new PartSlot(new PartChoice(1, Bristles()), new PartChoice(0.7)),
            },
            Patterns = Patterns((PatternKind.Plain, 1), (PatternKind.Patches, 0.6), (PatternKind.Mottle, 0.5)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.34, 0.03, 55)) { Kind = PatternKind.Plain, Accent = new Tint(0.22, 0.02, 50) },
                new Colouring(new Tint(0.78, 0.06, 25)) { Pattern = new Tint(0.28, 0.02, 50), Kind = PatternKind.Patches, Muzzle = new Tint(0.72, 0.09, 20) },
                new Colouring(new Tint(0.52, 0.09, 48)) { Kind = PatternKind.Mottle, Accent = new Tint(0.88, 0.03, 80) },
            },
        },
        bovine with
        {
            Body = "rhino",
            Frequency = (0.22, 0, 0),
            HipHeight = (0.54, 0.68),
            Eye = (8.8, 6.2), EyeSize = 0.24,
            HeadOrnament = (1, 0), EarSize = 0.8, Ears = Ears((EarShape.Pointed, 1)),
            WalkingPlans = Only(BodyPlan.Columnar),
            Parts = new[]
            {
                new PartSlot(
                    new PartChoice(1, NoseHorn(2.2, 0.28, 0.062), NoseHorn(5.4, 0.13, 0.05)),
                    new PartChoice(0.6, NoseHorn(2.6, 0.34, 0.062))),
            },
            Patterns = Patterns((PatternKind.Plain, 1), (PatternKind.Mottle, 0.8)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.52, 0.015, 70)) { Kind = PatternKind.Plain },
                new Colouring(new Tint(0.44, 0.03, 45)) { Kind = PatternKind.Mottle },
                new Colouring(new Tint(0.60, 0.02, 230)) { Kind = PatternKind.Plain },
            },
        },
        bovine with
        {
            Body = "horse",
            Frequency = (0.28, 0, 0),
            Signatures = new[] { Signature.None },
            Eye = (9.4, 6.0), EyeSize = 0.30,
            HeadOrnament = (1, 0), Ears = Ears((EarShape.Pointed, 1)),
            WalkingPlans = Only(BodyPlan.Unguligrade),
            Parts = new[] { new PartSlot(new PartChoice(0.2, NoseHorn(10.6, 0.42, 0.028)), new PartChoice(1)) },
            Patterns = Patterns((PatternKind.Plain, 1), (PatternKind.Patches, 0.6), (PatternKind.Stripes, 0.6)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.42, 0.08, 48)) { Kind = PatternKind.Plain, Limb = new Tint(0.25, 0.03, 50), Accent = new Tint(0.2, 0.02, 50) },
                new Colouring(new Tint(0.90, 0.01, 90)) { Pattern = new Tint(0.2, 0.01, 60), Kind = PatternKind.Stripes, Limb = new Tint(0.86, 0.01, 90), Accent = new Tint(0.2, 0.01, 60) },
                new Colouring(new Tint(0.90, 0.02, 85)) { Pattern = new Tint(0.46, 0.09, 50), Kind = PatternKind.Patches, Accent = new Tint(0.9, 0.02, 85) },
                new Colouring(new Tint(0.70, 0.08, 72)) { Kind = PatternKind.Plain, Accent = new Tint(0.92, 0.03, 90) },
                new Colouring(new Tint(0.60, 0.01, 250)) { Pattern = new Tint(0.84, 0.01, 250), Kind = PatternKind.Spots, Accent = new Tint(0.4, 0.01, 250) },
            },
        },
        canine with
        {
            Body = "rabbit",
            Frequency = (0.22, 0, 0),
            HeadSize = (1.2, 0.6),
            HipHeight = (0.40, 0.48), LegGirth = 0.9,
            Eye = (9.6, 6.4), EyeSize = 0.34,
            HeadOrnament = (1, 0), Ears = Ears((EarShape.Long, 1), (EarShape.Drooping, 0.2)),
            Teeth = 0, MouthOpenings = new[] { new Weighted<double>(0, 1) },
            WalkingPlans = Only(BodyPlan.Plantigrade),
            Parts = new[] { new PartSlot(new PartChoice(0.12, new PartKit(new FeatureBlueprint(FeatureKind.Antler, 12, 2.0, 0.26, 0.02, 0, 0.80, -0.1, 0.5, 0.2, 0.1, 0.15, 1, 1), 0.8, 1.2)), new PartChoice(1)) },
            Patterns = Patterns((PatternKind.Plain, 1), (PatternKind.Patches, 0.6), (PatternKind.Saddle, 0.4)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.56, 0.05, 65)) { Kind = PatternKind.Mottle, Belly = new Tint(0.92, 0.01, 90), Accent = new Tint(0.92, 0.01, 90) },
                new Colouring(new Tint(0.94, 0.01, 90)) { Kind = PatternKind.Plain },
                new Colouring(new Tint(0.36, 0.02, 60)) { Pattern = new Tint(0.92, 0.01, 90), Kind = PatternKind.Patches },
                new Colouring(new Tint(0.68, 0.09, 62)) { Kind = PatternKind.Plain, Belly = new Tint(0.92, 0.02, 85) },
            },
        },
    };

    private static PartKit NoseHorn(double ring, double length, double radius) =>
        new(new FeatureBlueprint(FeatureKind.Horn, ring, 0, length, radius, 0.75, 0.55, 0.35, 0, 0.1, -0.3, 0, 1, 1), 0.8, 1.3);

    /// <summary>A comb of stiff hair from the crown to the withers.</summary>
    private static PartKit[] Bristles()
    {
        var comb = new PartKit[9];
        for (int q = 0; q < comb.Length; q++)
        {
            double length = 0.13 * (1 - (0.9 * (((q / 8.0) - 0.45) * ((q / 8.0) - 0.45))));
            comb[q] = new PartKit(new FeatureBlueprint(FeatureKind.Tuft, 13.5 + (1.5 * q), 0, length, 0.034, 0.7, 0, -0.7, 0, 0, -0.3, 0, 0.5, 0.7), 0.7, 1.3);
        }

        return comb;
    }

    private static Weighted<BodyPlan>[] Only(BodyPlan plan) => new[] { new Weighted<BodyPlan>(plan, 1) };

    private static Weighted<EarShape>[] Ears(params (EarShape Shape, double Weight)[] ears) => System.Array.ConvertAll(ears, e => new Weighted<EarShape>(e.Shape, e.Weight));

    private static Weighted<PatternKind>[] Patterns(params (PatternKind Pattern, double Weight)[] patterns) =>
        System.Array.ConvertAll(patterns, p => new Weighted<PatternKind>(p.Pattern, p.Weight));
}
