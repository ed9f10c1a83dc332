using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>Insects and their kin: what decides is waist and abdomen, height of the knees, feelers and jaws, wings.</summary>
internal static class InsectSpecies
{
    private static readonly SpeciesProfile insect = FamilyProfiles.Find("insect") with
    {
        Dominance = (0.86, 0.96),
        Kinship = 0.6,
        Variety = 0.35,
        TiltVariety = 0.35,
        LatticeSpread = 0.16,
        HeadSize = (1.06, 0.7),
        Signatures = new[] { Signature.None, Signature.BigHead, Signature.BigEyes },
        EyeStyle = EyeStyle.Compound,
        EyeSink = 0.45,
    };

    /// <summary>All of them, in a fixed order.</summary>
    public static readonly SpeciesProfile[] All =
    {
        insect with
        {
            Body = "beetle",
            Frequency = (0.13, 0.2, 0),
            Eye = (8.5, 7.2), EyeSize = 0.42,
            Legs = new LegKit
            {
                Sites = Sixth(0.6, -0.05, -0.6),
                Reach = (0.24, 0.30), Height = (0.13, 0.20), Thickness = 0.055, KneeRise = 0.9,
            },
            Shell = new ShellBlueprint(ShellStyle.Elytra, 34, 19, 7, 0.07),
            Wings = new ThinWings { Spread = new[] { new ThinWing(32, 0.9, 0.24, -8, 26) } },
            Parts = new[]
            {
                new PartSlot(
                    new PartChoice(1, Part(Jaw(0.34, 0.038, 0.30, 0.25, -0.30), 0.8, 1.2)),
                    new PartChoice(1, Part(NoseHorn(0.36), 0.85, 1.2)),
                    new PartChoice(1, Part(Jaw(0.07, 0.022, 0, -0.1, -0.4), 0.8, 1.2))),
                new PartSlot(new PartChoice(1, Part(Feeler(6, 2.6, 0.3, 0.012, 0.7, 0.5, 0.7, 0.25, 0, 1.5), 0.85, 1.1))),
            },
            Colourings = new[]
            {
                new Colouring(new Tint(0.55, 0.19, 28)) { Pattern = new Tint(0.16, 0.02, 30), Kind = PatternKind.Spots, Limb = new Tint(0.2, 0.02, 30), Accent = new Tint(0.55, 0.2, 28) },
                new Colouring(new Tint(0.34, 0.07, 150)) { Kind = PatternKind.Plain, Accent = new Tint(0.55, 0.13, 150) },
                new Colouring(new Tint(0.27, 0.05, 270)) { Kind = PatternKind.Plain, Accent = new Tint(0.42, 0.10, 265) },
                new Colouring(new Tint(0.40, 0.08, 55)) { Kind = PatternKind.Plain, Accent = new Tint(0.5, 0.1, 55) },
                new Colouring(new Tint(0.60, 0.14, 80)) { Pattern = new Tint(0.2, 0.03, 60), Kind = PatternKind.Stripes, Limb = new Tint(0.25, 0.03, 60) },
            },
        },
        insect with
        {
            Body = "ant",
            Frequency = (0.13, 0, 0),
            Signatures = new[] { Signature.None, Signature.BigHead, Signature.BigEyes, Signature.BigTail },
            Eye = (9.4, 7.0), EyeSize = 0.34,
            Annuli = new AnnuliBlueprint(44, 0.06),
            Legs = new LegKit
            {
                Sites = Sixth(0.6, -0.05, -0.65),
                Reach = (0.30, 0.40), Height = (0.24, 0.36), Thickness = 0.036, KneeRise = 1.2,
            },
            Parts = new[]
            {
                new PartSlot(new PartChoice(1, Part(Jaw(0.17, 0.034, 0.1, 0, -0.5), 0.8, 1.2))),
                Elbowed(),
            },
            Colourings = new[]
            {
                new Colouring(new Tint(0.36, 0.09, 35)),
                new Colouring(new Tint(0.26, 0.02, 40)),
                new Colouring(new Tint(0.52, 0.13, 42)) { Pattern = new Tint(0.3, 0.08, 30), Kind = PatternKind.Saddle },
            },
        },
        insect with
        {
            Body = "wasp",
            Frequency = (0.13, 0.24, 0),
            Variety = 0.6, LatticeSpread = 0.2,
            Signatures = new[] { Signature.None, Signature.BigHead, Signature.BigEyes, Signature.BigTail },
            Eye = (8.6, 7.0), EyeSize = 0.70, EyeSink = 0.55,
            Annuli = new AnnuliBlueprint(41, 0.06),
            Legs = new LegKit
            {
                Sites = Sixth(0.45, -0.05, -0.6),
                Reach = (0.26, 0.34), Height = (0.20, 0.30), Thickness = 0.036,
            },
            Wings = new ThinWings
            {
                Spread = new[] { new ThinWing(26, 0.95, 0.20, -6, 36), new ThinWing(30, 0.66, 0.16, -36, 26) },
                Folded = new[] { new ThinWing(26, 0.68, 0.15, -66, 14), new ThinWing(29, 0.50, 0.12, -74, 10) },
            },
            Parts = new[] { SmallJaws(), Elbowed() },
            Colourings = new[]
            {
                new Colouring(new Tint(0.78, 0.15, 88)) { Pattern = new Tint(0.20, 0.02, 60), Kind = PatternKind.Bands, Scale = 1.5, Limb = new Tint(0.30, 0.05, 60) },
                new Colouring(new Tint(0.62, 0.16, 50)) { Pattern = new Tint(0.2, 0.02, 60), Kind = PatternKind.Bands, Scale = 1.4 },
                new Colouring(new Tint(0.22, 0.02, 270)) { Pattern = new Tint(0.92, 0.02, 90), Kind = PatternKind.Bands, Scale = 0.8, Limb = new Tint(0.2, 0.02, 270) },
                new Colouring(new Tint(0.46, 0.11, 200)) { Kind = PatternKind.Plain, Limb = new Tint(0.34, 0.10, 300), Accent = new Tint(0.46, 0.14, 320) },
                new Colouring(new Tint(0.24, 0.02, 40)) { Pattern = new Tint(0.50, 0.17, 30), Kind = PatternKind.Saddle, Limb = new Tint(0.5, 0.16, 32) },
            },
        },
        insect with
        {
            Body = "mantis",
            Frequency = (0.13, 0.12, 0),
            Dominance = (0.93, 0.98),
            Eye = (9.6, 7.4), EyeSize = 0.62, EyeSink = 0.55,
            Annuli = new AnnuliBlueprint(36, 0.05),
            Legs = new LegKit
            {
                Sites = new[] { new LegSite(LimbArchetype.Insect, 29, 9.7, 0.45, 1.05, 1), new LegSite(LimbArchetype.Insect, 33, 9.7, -0.5, 1.05, 1) },
                Arms = new[] { new LegSite(LimbArchetype.Raptorial, 24, 10, 0, 0.52, 1.9) },
                Reach = (0.34, 0.42), Height = (0.40, 0.55), Thickness = 0.032,
            },
            Wings = new ThinWings
            {
                Spread = new[] { new ThinWing(28, 0.85, 0.16, -18, 32), new ThinWing(31, 0.75, 0.22, -44, 24) },
                Folded = new[] { new ThinWing(30, 0.80, 0.13, -84, 3) },
            },
            Parts = new[] { SmallJaws(), Long(0.42) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.68, 0.15, 128)),
                new Colouring(new Tint(0.62, 0.07, 80)) { Kind = PatternKind.Mottle },
                new Colouring(new Tint(0.84, 0.05, 5)) { Accent = new Tint(0.7, 0.15, 350) },
                new Colouring(new Tint(0.38, 0.04, 65)) { Pattern = new Tint(0.58, 0.06, 75), Kind = PatternKind.Bands },
            },
        },
        insect with
        {
            Body = "hopper",
            Frequency = (0.13, 0, 0),
            Eye = (9.6, 6.0), EyeSize = 0.50,
            Annuli = new AnnuliBlueprint(36, 0.05),
            Legs = new LegKit
            {
                Sites = new[]
                {
                    new LegSite(LimbArchetype.Insect, 22, 9.7, 0.5, 1, 1), new LegSite(LimbArchetype.Insect, 26, 9.7, -0.05, 1, 1),
                    new LegSite(LimbArchetype.Jumper, 32, 9.0, 0, 1.68, 1.7),
                },
                Reach = (0.22, 0.28), Height = (0.20, 0.28), Thickness = 0.03,
            },
            Wings = new ThinWings { Spread = new[] { new ThinWing(28, 0.85, 0.13, -10, 30) }, Folded = new[] { new ThinWing(28, 0.95, 0.15, -85, 2) } },
            Parts = new[] { SmallJaws(), Long(0.6) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.68, 0.15, 125)) { Kind = PatternKind.Plain },
                new Colouring(new Tint(0.58, 0.08, 75)) { Kind = PatternKind.Mottle },
                new Colouring(new Tint(0.66, 0.14, 100)) { Pattern = new Tint(0.3, 0.05, 60), Kind = PatternKind.Bands },
                new Colouring(new Tint(0.36, 0.03, 60)) { Pattern = new Tint(0.64, 0.17, 60), Kind = PatternKind.Bands, Limb = new Tint(0.58, 0.17, 32) },
            },
        },
        insect with
        {
            Body = "spider",
            Frequency = (0.14, 0, 0),
            Dominance = (0.93, 0.98),
            HeadSize = (1, 0.3),
            Signatures = new[] { Signature.None, Signature.BigEyes, Signature.BigTail },
            Eye = (7.0, 3.2), EyeSize = 0.24, EyeStyle = EyeStyle.Bead,
            Legs = new LegKit
            {
                Sites = new[]
                {
                    new LegSite(LimbArchetype.Insect, 20, 9.2, 0.80, 1.06, 1), new LegSite(LimbArchetype.Insect, 23, 9.2, 0.28, 0.92, 1),
                    new LegSite(LimbArchetype.Insect, 26, 9.2, -0.26, 0.92, 1), new LegSite(LimbArchetype.Insect, 29, 9.2, -0.78, 1.06, 1),
                },
                Reach = (0.42, 0.56), Height = (0.16, 0.28), Thickness = 0.05, KneeRise = 1.9,
            },
            Parts = new[]
            {
                new PartSlot(new PartChoice(
                    1,
                    Part(new FeatureBlueprint(FeatureKind.Mandible, 1.0, 11, 0.17, 0.045, 0.3, -0.75, 0.6, -0.05, -0.25, -0.15, 0, 1, 0.8), 0.85, 1.15),
                    Part(new FeatureBlueprint(FeatureKind.Antenna, 2.5, 9.5, 0.26, 0.024, 0, 0.2, 0.8, 0.55, -0.75, 0.35, -0.1, 0.45, 0.4), 0.9, 1.1))),
                new PartSlot(new PartChoice(1, Ocellus(5.2, 1.3, 0.026), Ocellus(6.2, 5.4, 0.021), Ocellus(9.4, 2.6, 0.021), Ocellus(9.8, 5.4, 0.02))),
            },
            Patterns = Weights.Of((PatternKind.Bands, 1), (PatternKind.Mottle, 0.7), (PatternKind.Patches, 0.6), (PatternKind.Plain, 0.5)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.30, 0.03, 60)) { Pattern = new Tint(0.6, 0.08, 70), Kind = PatternKind.Mottle },
                new Colouring(new Tint(0.20, 0.015, 270)) { Pattern = new Tint(0.55, 0.2, 28), Kind = PatternKind.Patches, Accent = new Tint(0.55, 0.2, 28) },
                new Colouring(new Tint(0.45, 0.06, 65)) { Pattern = new Tint(0.25, 0.03, 50), Kind = PatternKind.Mottle },
                new Colouring(new Tint(0.36, 0.05, 40)) { Pattern = new Tint(0.68, 0.12, 60), Kind = PatternKind.Bands, Limb = new Tint(0.62, 0.12, 55) },
            },
        },
        insect with
        {
            Body = "centipede",
            Frequency = (0.12, 0, 0),
            Dominance = (0.93, 0.98),
            WalkingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.ManyLegged, 1) },
            Eye = (8.8, 6.2), EyeSize = 0.30,
            Annuli = new AnnuliBlueprint(17, 0.07),
            Legs = new LegKit { Sites = Row(12, 18, 3, 0.35, -0.45), Reach = (0.15, 0.18), Height = (0.05, 0.08), Thickness = 0.026, KneeRise = 0.7 },
            Parts = new[]
            {
                new PartSlot(new PartChoice(1, Part(Jaw(0.15, 0.034, 0.1, 0, -0.5), 0.8, 1.2))),
                new PartSlot(new PartChoice(1, Part(Feeler(3, 2.6, 0.75, 0.011, 0.42, 0.55, 0.75, -0.4, 0.2), 0.8, 1.15))),
                new PartSlot(new PartChoice(1, Part(new FeatureBlueprint(FeatureKind.Antenna, 52, 5, 0.3, 0.012, 0.1, 0.1, -0.9, 0.35, 0.1, 0, 0.1, 0.3, 0.6), 0.8, 1.2))),
            },
            Colourings = new[]
            {
                new Colouring(new Tint(0.40, 0.13, 35)) { Kind = PatternKind.Plain, Limb = new Tint(0.66, 0.15, 60) },
                new Colouring(new Tint(0.30, 0.06, 270)) { Kind = PatternKind.Plain, Limb = new Tint(0.7, 0.14, 80) },
                new Colouring(new Tint(0.45, 0.08, 80)) { Pattern = new Tint(0.25, 0.03, 60), Kind = PatternKind.Bands },
            },
        },
        insect with
        {
            Body = "butterfly",
            Frequency = (0, 0.42, 0),
            Eye = (8.8, 7.0), EyeSize = 0.74, EyeSink = 0.55,
            Annuli = new AnnuliBlueprint(41, 0.05),
            Legs = new LegKit { Sites = Sixth(0.45, -0.05, -0.6), Reach = (0.18, 0.22), Height = (0.16, 0.22), Thickness = 0.024 },
            Wings = new ThinWings { Spread = new[] { new ThinWing(26, 0.95, 0.55, 22, 45), new ThinWing(30, 0.70, 0.50, -34, 42) } },
            Parts = new[] { SmallJaws(), new PartSlot(new PartChoice(1, Part(Feeler(6, 2.6, 0.5, 0.011, 0.4, 0.85, 0.7, 0, 0, 1.2), 0.9, 1.1))) },
            Colourings = new[] { new Colouring(new Tint(0.30, 0.03, 60)) { Kind = PatternKind.Plain, KeepsAccent = true }, new Colouring(new Tint(0.22, 0.02, 270)) { Kind = PatternKind.Plain, KeepsAccent = true } },
        },
        insect with
        {
            Body = "dragonfly",
            Frequency = (0, 0.36, 0),
            Eye = (9.6, 5.4), EyeSize = 0.80, EyeSink = 0.55,
            Legs = new LegKit
            {
                Sites = new[]
                {
                    new LegSite(LimbArchetype.Insect, 23, 9.7, 0.55, 1, 1), new LegSite(LimbArchetype.Insect, 26, 9.7, 0.1, 1, 1), new LegSite(LimbArchetype.Insect, 29, 9.7, -0.4, 1, 1),
                },
                Reach = (0.20, 0.26), Height = (0.16, 0.22), Thickness = 0.028,
            },
            Wings = new ThinWings { Spread = new[] { new ThinWing(25, 1.1, 0.14, 12, 14), new ThinWing(29, 1.02, 0.16, -16, 10) } },
            Parts = new[] { SmallJaws(), new PartSlot(new PartChoice(1, Part(Feeler(6, 2.6, 0.13, 0.009, 0.4, 0.6, 0.6, 0, 0), 0.9, 1.1))) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.60, 0.13, 232)) { Pattern = new Tint(0.22, 0.03, 250), Kind = PatternKind.Bands },
                new Colouring(new Tint(0.62, 0.15, 150)) { Pattern = new Tint(0.24, 0.04, 150), Kind = PatternKind.Bands },
                new Colouring(new Tint(0.40, 0.04, 60)) { Pattern = new Tint(0.80, 0.15, 95), Kind = PatternKind.Bands },
                new Colouring(new Tint(0.46, 0.13, 300)) { Kind = PatternKind.Plain },
                new Colouring(new Tint(0.55, 0.19, 28)) { Kind = PatternKind.Plain },
            },
        },
        insect with
        {
            Body = "bee",
            Frequency = (0, 0.24, 0),
            Eye = (8.8, 6.6), EyeSize = 0.50, EyeSink = 0.55,
            Legs = new LegKit { Sites = Sixth(0.45, -0.05, -0.6), Reach = (0.22, 0.28), Height = (0.14, 0.2), Thickness = 0.04 },
            Wings = new ThinWings { Spread = new[] { new ThinWing(26, 0.72, 0.22, -4, 34), new ThinWing(30, 0.48, 0.17, -36, 26) } },
            Parts = new[] { SmallJaws(), new PartSlot(new PartChoice(1, Part(Feeler(6, 2.6, 0.24, 0.014, 0.35, 1.05, 0.35, -0.6, 0.6), 0.85, 1.1))) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.74, 0.15, 82)) { Pattern = new Tint(0.18, 0.02, 60), Kind = PatternKind.Bands, Scale = 0.9, Limb = new Tint(0.2, 0.02, 60) },
                new Colouring(new Tint(0.22, 0.02, 60)) { Pattern = new Tint(0.62, 0.15, 50), Kind = PatternKind.Bands, Scale = 0.7, Limb = new Tint(0.2, 0.02, 60) },
                new Colouring(new Tint(0.52, 0.10, 55)) { Pattern = new Tint(0.86, 0.05, 90), Kind = PatternKind.Bands, Scale = 1.1, Limb = new Tint(0.25, 0.03, 50) },
                new Colouring(new Tint(0.68, 0.01, 250)) { Pattern = new Tint(0.2, 0.01, 260), Kind = PatternKind.Bands, Scale = 0.8, Limb = new Tint(0.22, 0.01, 260) },
                new Colouring(new Tint(0.30, 0.09, 275)) { Kind = PatternKind.Plain, Limb = new Tint(0.2, 0.02, 270), Accent = new Tint(0.42, 0.13, 290) },
                new Colouring(new Tint(0.60, 0.16, 60)) { Pattern = new Tint(0.24, 0.03, 50), Kind = PatternKind.Saddle, Limb = new Tint(0.22, 0.02, 60) },
            },
        },
        insect with
        {
            Body = "moth",
            Frequency = (0, 0.26, 0),
            Eye = (8.8, 6.6), EyeSize = 0.58, EyeSink = 0.55,
            Legs = new LegKit { Sites = Sixth(0.45, -0.05, -0.6), Reach = (0.2, 0.24), Height = (0.14, 0.2), Thickness = 0.036 },
            Wings = new ThinWings { Spread = new[] { new ThinWing(26, 1.0, 0.66, -10, 16), new ThinWing(30, 0.66, 0.56, -50, 10) } },
            Parts = new[] { new PartSlot(new PartChoice(1, Part(Feeler(6, 2.6, 0.3, 0.03, 0.75, 0.8, 0.5, 0.15, 0.3, 0.2), 0.85, 1.15))) },
            Patterns = Weights.Of((PatternKind.Mottle, 1), (PatternKind.Bands, 0.6), (PatternKind.Spots, 0.6)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.62, 0.05, 70)) { Pattern = new Tint(0.4, 0.05, 55), Kind = PatternKind.Mottle, Accent = new Tint(0.52, 0.08, 60) },
                new Colouring(new Tint(0.84, 0.06, 140)) { Kind = PatternKind.Plain, Accent = new Tint(0.78, 0.10, 140) },
                new Colouring(new Tint(0.34, 0.03, 60)) { Pattern = new Tint(0.72, 0.14, 70), Kind = PatternKind.Bands, Accent = new Tint(0.60, 0.15, 40) },
                new Colouring(new Tint(0.88, 0.02, 90)) { Pattern = new Tint(0.3, 0.02, 60), Kind = PatternKind.Spots, Accent = new Tint(0.85, 0.03, 95) },
            },
        },
    };

    private static LegSite[] Sixth(double front, double middle, double rear) => new[]
    {
        new LegSite(LimbArchetype.Insect, 24, 9.7, front, 1.05, 1),
        new LegSite(LimbArchetype.Insect, 28, 9.7, middle, 1, 1),
        new LegSite(LimbArchetype.Insect, 32, 9.7, rear, 1.06, 1),
    };

    private static LegSite[] Row(int pairs, int first, int step, double front, double rear)
    {
        var sites = new LegSite[pairs];
        for (int k = 0; k < pairs; k++)
        {
            sites[k] = new LegSite(LimbArchetype.Insect, first + (step * k), 9.7, front + ((rear - front) * k / (pairs - 1)), 1, 1);
        }

        return sites;
    }

    private static PartKit Part(FeatureBlueprint part, double least, double most) => new(part, least, most);

    private static FeatureBlueprint Jaw(double length, double radius, double sideward, double bendUp, double bendSide) =>
        new(FeatureKind.Mandible, 1.5, 8.5, length, radius, 0, 0.1, 0.95, sideward, bendUp, 0.1, bendSide, 1, 0.65);

    private static FeatureBlueprint NoseHorn(double length) => new(FeatureKind.Horn, 4, 0, length, 0.048, 0, 0.55, 0.85, 0, 0.4, -0.35, 0, 1, 0.7);

    private static FeatureBlueprint Feeler(double ring, double segment, double length, double radius, double outward, double upward, double forward, double bendUp, double bendForward, double knob = 0.3) =>
        new(FeatureKind.Antenna, ring, segment, length, radius, 0, upward, forward, outward, bendUp, bendForward, 0.12, knob, 0.6);

    private static PartSlot Elbowed() => new(new PartChoice(1, Part(Feeler(6, 2.6, 0.36, 0.013, 0.35, 1.05, 0.35, -0.75, 0.7), 0.85, 1.1)));

    private static PartSlot Long(double length) => new(new PartChoice(1, Part(Feeler(6, 2.6, length, 0.011, 0.42, 0.8, 0.75, -0.3, 0.15), 0.85, 1.2)));

    private static PartSlot SmallJaws() => new(new PartChoice(1, Part(Jaw(0.07, 0.022, 0, -0.1, -0.4), 0.8, 1.2)));

    private static PartKit Ocellus(double ring, double segment, double radius) =>
        Part(new FeatureBlueprint(FeatureKind.Ocellus, ring, segment, radius * 1.1, radius, 1, 0, 0, 0, 0, 0, 0, 1, 0.42), 1, 1);
}
