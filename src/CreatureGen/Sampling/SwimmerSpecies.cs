using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>Swimmers, and those of them that walk as well.</summary>
internal static class SwimmerSpecies
{
    private static readonly SpeciesProfile fish = Tamed(FamilyProfiles.Find("fish"));
    private static readonly SpeciesProfile reptile = Tamed(FamilyProfiles.Find("reptile"));
    private static readonly SpeciesProfile amphibian = Tamed(FamilyProfiles.Find("amphibian"));
    private static readonly SpeciesProfile canine = Tamed(FamilyProfiles.Find("canine"));
    private static readonly SpeciesProfile serpent = Tamed(FamilyProfiles.Find("serpent"));

    /// <summary>All of them, in a fixed order.</summary>
    public static readonly SpeciesProfile[] All =
    {
        fish with
        {
            Body = "shark",
            Frequency = (0, 0, 0.42),
            Eye = (8.4, 7.2), EyeSize = 0.17,
            MouthCorner = 6, Teeth = 0.9, ToothLength = 0.12,
            MouthOpenings = Weights.Of<double>((0.10, 1), (0.18, 1), (0.0, 0.6)),
            SwimmingPlans = Weights.Of((BodyPlan.Fish, 1)),
            Fins = new FinKit
            {
                Fins = new[]
                {
                    new FinSiteKit(FinPlace.Dorsal, FinStyle.Shark, 27, 0, 8, (0.24, 0.32), (0, 0), 0, 0.9),
                    new FinSiteKit(FinPlace.Dorsal, FinStyle.Shark, 41, 0, 4, (0.07, 0.09), (0, 0), 0, 0.9),
                    new FinSiteKit(FinPlace.Pectoral, FinStyle.Paddle, 24, 10, 4, (0.38, 0.50), (0.40, 0.50), 0.38, 0.6),
                    new FinSiteKit(FinPlace.Pectoral, FinStyle.Paddle, 38, 11, 4, (0.15, 0.18), (0.5, 0.5), 0.4, 0.6),
                },
                Tail = TailStyle.Fork, TailSize = (0.26, 0.32), TailFork = (1.1, 1.6), TailLobe = 0.38,
            },
            Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Stripes, 0.5), (PatternKind.Spots, 0.4)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.56, 0.03, 240)) { Kind = PatternKind.Plain, Belly = new Tint(0.9, 0.01, 230), Accent = new Tint(0.40, 0.03, 240) },
                new Colouring(new Tint(0.50, 0.05, 225)) { Pattern = new Tint(0.34, 0.04, 235), Kind = PatternKind.Stripes, Belly = new Tint(0.88, 0.01, 200), Accent = new Tint(0.36, 0.04, 235) },
                new Colouring(new Tint(0.60, 0.04, 80)) { Pattern = new Tint(0.4, 0.04, 70), Kind = PatternKind.Spots, Accent = new Tint(0.42, 0.04, 75) },
                new Colouring(new Tint(0.44, 0.07, 262)) { Kind = PatternKind.Plain, Belly = new Tint(0.92, 0.01, 240), Accent = new Tint(0.34, 0.07, 262) },
                new Colouring(new Tint(0.66, 0.06, 62)) { Pattern = new Tint(0.44, 0.05, 55), Kind = PatternKind.Bands, Belly = new Tint(0.9, 0.02, 80) },
                new Colouring(new Tint(0.36, 0.02, 60)) { Pattern = new Tint(0.86, 0.02, 90), Kind = PatternKind.Spots, Scale = 1.6, Belly = new Tint(0.86, 0.02, 90) },
            },
        },
        fish with
        {
            Body = "ray",
            Frequency = (0, 0, 0.38),
            Dominance = (0.93, 0.98),
            Kinship = 0,
            HeadSize = (1, 0.2),
            Signatures = new[] { Signature.None, Signature.BigEyes },
            Disc = (0.42, -0.28, 0.38),
            Eye = (6.4, 3.0), EyeSize = 0.20, EyeSink = 0.4,
            MouthCorner = 0, Nostril = 0, Bone = 0, Swelling = (0, 0),
            SwimmingPlans = Weights.Of((BodyPlan.Whale, 1)),
            Fins = new FinKit
            {
                Fins = new[] { new FinSiteKit(FinPlace.Pectoral, FinStyle.Paddle, 43, 10, 4, (0.14, 0.18), (0.6, 0.7), 0.15, 0.9) },
                Tail = TailStyle.Plain,
            },
            Parts = new[]
            {
                new PartSlot(
                    new PartChoice(1, new PartKit(new FeatureBlueprint(FeatureKind.Scute, 1.5, 8, 0.24, 0.055, 0, -0.1, 1, 0.05, -0.15, 0, -0.2, 0.4, 0.55), 0.8, 1.15)),
                    new PartChoice(0.8)),
                new PartSlot(new PartChoice(1, new PartKit(new FeatureBlueprint(FeatureKind.Spike, 46, 0, 0.2, 0.018, 0.4, 0.3, -1, 0, 0, -0.2, 0, 1, 1), 0.8, 1.2)), new PartChoice(1)),
            },
            Patterns = Weights.Of((PatternKind.Spots, 1), (PatternKind.Mottle, 1), (PatternKind.Plain, 0.6)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.32, 0.03, 250)) { Pattern = new Tint(0.8, 0.02, 90), Kind = PatternKind.Spots, Belly = new Tint(0.88, 0.01, 240) },
                new Colouring(new Tint(0.55, 0.06, 75)) { Pattern = new Tint(0.38, 0.05, 65), Kind = PatternKind.Mottle, Belly = new Tint(0.88, 0.02, 80) },
                new Colouring(new Tint(0.42, 0.09, 255)) { Pattern = new Tint(0.72, 0.11, 230), Kind = PatternKind.Spots, Belly = new Tint(0.9, 0.02, 240) },
                new Colouring(new Tint(0.66, 0.11, 85)) { Pattern = new Tint(0.44, 0.12, 255), Kind = PatternKind.Spots, Scale = 1.3, Belly = new Tint(0.92, 0.02, 90) },
                new Colouring(new Tint(0.24, 0.015, 270)) { Kind = PatternKind.Plain, Belly = new Tint(0.93, 0.01, 240) },
            },
        },
        fish with
        {
            Body = "angler",
            Frequency = (0, 0, 0.26),
            Dominance = (0.93, 0.98),
            Signatures = new[] { Signature.None, Signature.BigEyes },
            Eye = (6.6, 5.0), EyeSize = 0.17,
            MouthCorner = 7, Teeth = 1, ToothLength = 0.24,
            MouthOpenings = Weights.Of<double>((0.30, 1)),
            SwimmingPlans = Weights.Of((BodyPlan.Fish, 1)),
            Fins = new FinKit
            {
                Fins = new[]
                {
                    new FinSiteKit(FinPlace.Dorsal, FinStyle.Sail, 34, 0, 8, (0.13, 0.16), (0, 0), 0, 0.35),
                    new FinSiteKit(FinPlace.Ventral, FinStyle.Sail, 36, 0, 6, (0.09, 0.11), (0, 0), 0, 0.35),
                    new FinSiteKit(FinPlace.Pectoral, FinStyle.Paddle, 25, 9, 4, (0.22, 0.27), (0.7, 0.8), 0.35, 0.6),
                },
                Tail = TailStyle.Fan, TailSize = (0.2, 0.26), TailFork = (-0.4, -0.2),
            },
            Parts = new[]
            {
                new PartSlot(new PartChoice(1, new PartKit(new FeatureBlueprint(FeatureKind.Lure, 11, 0, 0.52, 0.018, 0, 1, 0.25, 0, -0.42, 0.75, 0, 1.6, 0.5), 0.8, 1.1))),
            },
            Patterns = Weights.Of((PatternKind.Mottle, 1), (PatternKind.Plain, 0.5)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.30, 0.03, 300)) { Kind = PatternKind.Mottle },
                new Colouring(new Tint(0.34, 0.05, 40)) { Kind = PatternKind.Mottle },
                new Colouring(new Tint(0.28, 0.04, 220)) { Kind = PatternKind.Mottle },
                new Colouring(new Tint(0.46, 0.14, 30)) { Kind = PatternKind.Plain },
            },
        },
        reptile with
        {
            Body = "turtle",
            Frequency = (0.28, 0, 0.36),
            Dominance = (0.93, 0.98),
            Signatures = new[] { Signature.None, Signature.BigHead, Signature.BigEyes },
            Shell = new ShellBlueprint(ShellStyle.Carapace, 24, 21, 7, 0.10),
            Eye = (9.0, 5.6), EyeSize = 0.30,
            MouthCorner = 7, Teeth = 0, HeadOrnament = (0, 0), Mood = 0.1,
            MouthOpenings = Weights.Of<double>((0, 1), (0.08, 0.6)),
            WalkingPlans = Weights.Of((BodyPlan.Sprawling, 1)),
            SwimmingPlans = Weights.Of((BodyPlan.Flipper, 1)),
            Fins = new FinKit
            {
                Fins = new[]
                {
                    new FinSiteKit(FinPlace.Pectoral, FinStyle.Paddle, 26, 9.6, 4, (0.62, 0.75), (0.30, 0.38), 0.35, 0.6),
                    new FinSiteKit(FinPlace.Pectoral, FinStyle.Paddle, 41, 10, 4, (0.28, 0.34), (0.6, 0.6), 0.4, 0.6),
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
        },
        reptile with
        {
            Body = "plesiosaur",
            Frequency = (0, 0, 0.33),
            Eye = (9.4, 5.0), EyeSize = 0.30,
            HeadOrnament = (0, 0.15),
            SwimmingPlans = Weights.Of((BodyPlan.Flipper, 1)),
            Fins = new FinKit
            {
                Fins = new[]
                {
                    new FinSiteKit(FinPlace.Pectoral, FinStyle.Paddle, 25, 10, 4, (0.55, 0.75), (0.36, 0.46), 0.4, 0.6),
                    new FinSiteKit(FinPlace.Pectoral, FinStyle.Paddle, 41, 10, 4, (0.38, 0.55), (0.42, 0.42), 0.4, 0.6),
                },
                Tail = TailStyle.Plain,
            },
            Colourings = new[]
            {
                new Colouring(new Tint(0.50, 0.05, 215)) { Pattern = new Tint(0.34, 0.04, 225), Kind = PatternKind.Mottle },
                new Colouring(new Tint(0.48, 0.06, 120)) { Pattern = new Tint(0.3, 0.05, 110), Kind = PatternKind.Bands },
                new Colouring(new Tint(0.40, 0.06, 262)) { Kind = PatternKind.Plain, Belly = new Tint(0.88, 0.02, 240) },
                new Colouring(new Tint(0.62, 0.07, 68)) { Pattern = new Tint(0.40, 0.06, 45), Kind = PatternKind.Saddle, Belly = new Tint(0.9, 0.03, 85) },
                new Colouring(new Tint(0.30, 0.03, 190)) { Pattern = new Tint(0.70, 0.10, 180), Kind = PatternKind.Spots, Belly = new Tint(0.78, 0.05, 180) },
            },
        },
        reptile with
        {
            Body = "crocodile",
            Frequency = (0.25, 0, 0.3),
            Eye = (10.0, 3.4), EyeSize = 0.22, EyeSink = 0.35, Bone = 0.3,
            Teeth = 1, ToothLength = 0.16, HeadOrnament = (0, 0),
            WalkingPlans = Weights.Of((BodyPlan.Sprawling, 1)),
            SwimmingPlans = Weights.Of((BodyPlan.Eel, 1)),
            Paddles = Paddling(0.085, 0.6),
            Fins = new FinKit { Tail = TailStyle.Plain },
            Parts = new[] { new PartSlot(new PartChoice(1, Scutes())) },
            Patterns = Weights.Of((PatternKind.Bands, 1), (PatternKind.Mottle, 1)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.46, 0.06, 110)) { Pattern = new Tint(0.30, 0.04, 105), Kind = PatternKind.Bands },
                new Colouring(new Tint(0.38, 0.04, 85)) { Kind = PatternKind.Mottle },
                new Colouring(new Tint(0.64, 0.07, 80)) { Pattern = new Tint(0.42, 0.05, 70), Kind = PatternKind.Bands, Belly = new Tint(0.88, 0.04, 90) },
            },
        },
        canine with
        {
            Body = "seal",
            Frequency = (0, 0, 0.3),
            Eye = (8.8, 5.6), EyeSize = 0.30,
            HeadOrnament = (0, 0), Teeth = 0.2,
            MouthOpenings = Weights.Of<double>((0, 1), (0.1, 0.4)),
            SwimmingPlans = Weights.Of((BodyPlan.Whale, 1)),
            Fins = new FinKit
            {
                Fins = new[] { new FinSiteKit(FinPlace.Pectoral, FinStyle.Paddle, 27, 10.6, 4, (0.42, 0.55), (0.5, 0.6), 0.75, 0.6) },
                Tail = TailStyle.Fluke, TailSize = (0.19, 0.23), TailFork = (0.8, 1.1),
            },
            Parts = new[]
            {
                new PartSlot(new PartChoice(2.2), new PartChoice(1, new PartKit(new FeatureBlueprint(FeatureKind.Tusk, 3, 10.8, 0.24, 0.026, 0, -1, 0.3, 0.08, 0, -0.25, 0, 1, 0.8), 0.8, 1.3))),
            },
            Colourings = new[]
            {
                new Colouring(new Tint(0.52, 0.02, 70)) { Pattern = new Tint(0.3, 0.02, 60), Kind = PatternKind.Spots },
                new Colouring(new Tint(0.36, 0.02, 60)) { Kind = PatternKind.Plain },
                new Colouring(new Tint(0.78, 0.02, 85)) { Pattern = new Tint(0.45, 0.02, 60), Kind = PatternKind.Mottle },
            },
        },
        amphibian with
        {
            Body = "newt",
            Frequency = (0.25, 0, 0.3),
            Eye = (9.4, 4.6), EyeSize = 0.24,
            WalkingPlans = Weights.Of((BodyPlan.Sprawling, 1)),
            SwimmingPlans = Weights.Of((BodyPlan.Eel, 1)),
            Paddles = Paddling(0.07, 0),
            Fins = new FinKit
            {
                Fins = new[] { new FinSiteKit(FinPlace.Dorsal, FinStyle.Sail, 32, 0, 14, (0.07, 0.13), (0, 0), 0, 0.35) },
                Tail = TailStyle.Plain,
            },
            Parts = new[] { new PartSlot(new PartChoice(0.85, Gills()), new PartChoice(0.15)) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.34, 0.03, 50)) { Pattern = new Tint(0.68, 0.17, 50), Kind = PatternKind.Patches, Accent = new Tint(0.66, 0.18, 42) },
                new Colouring(new Tint(0.86, 0.05, 12)) { Kind = PatternKind.Plain, Limb = new Tint(0.8, 0.07, 12), Accent = new Tint(0.60, 0.17, 18) },
                new Colouring(new Tint(0.48, 0.08, 110)) { Pattern = new Tint(0.25, 0.03, 100), Kind = PatternKind.Spots },
                new Colouring(new Tint(0.64, 0.13, 132)) { Pattern = new Tint(0.26, 0.03, 120), Kind = PatternKind.Turing, Accent = new Tint(0.62, 0.15, 45) },
            },
        },
        serpent with
        {
            Body = "eel",
            Frequency = (0, 0, 0.28),
            HeadOrnament = (0, 0),
            SwimmingPlans = Weights.Of((BodyPlan.Eel, 1)),
            Patterns = Weights.Of((PatternKind.Bands, 1.2), (PatternKind.Spots, 0.8), (PatternKind.Mottle, 0.5), (PatternKind.Turing, 1)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.42, 0.07, 95)) { Pattern = new Tint(0.75, 0.13, 90), Kind = PatternKind.Spots, Accent = new Tint(0.5, 0.1, 100) },
                new Colouring(new Tint(0.70, 0.02, 90)) { Pattern = new Tint(0.2, 0.02, 60), Kind = PatternKind.Bands },
                new Colouring(new Tint(0.30, 0.03, 250)) { Kind = PatternKind.Plain, Belly = new Tint(0.7, 0.03, 90) },
                new Colouring(new Tint(0.52, 0.13, 250)) { Pattern = new Tint(0.82, 0.15, 95), Kind = PatternKind.Stripes, Belly = new Tint(0.84, 0.14, 95) },
                new Colouring(new Tint(0.76, 0.06, 88)) { Pattern = new Tint(0.30, 0.04, 62), Kind = PatternKind.Turing },
            },
        },
        fish with
        {
            Body = "dolphin",
            Frequency = (0, 0, 0.34),
            Dominance = (0.93, 0.98),
            Eye = (8.6, 8.2), EyeSize = 0.17,
            MouthCorner = 8, Teeth = 0.3, ToothLength = 0.1, Nostril = 0,
            MouthOpenings = Weights.Of<double>((0, 1), (0.12, 0.6)),
            SwimmingPlans = Weights.Of((BodyPlan.Whale, 1)),
            Fins = new FinKit
            {
                Fins = new[]
                {
                    new FinSiteKit(FinPlace.Dorsal, FinStyle.Shark, 29, 0, 8, (0.19, 0.3), (0, 0), 0, 0.9),
                    new FinSiteKit(FinPlace.Pectoral, FinStyle.Paddle, 24, 10.4, 4, (0.32, 0.42), (0.40, 0.48), 0.6, 0.6),
                },
                Tail = TailStyle.Fluke, TailSize = (0.24, 0.3), TailFork = (0.7, 1.0),
            },
            Parts = System.Array.Empty<PartSlot>(),
            Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Saddle, 0.6), (PatternKind.Spots, 0.3)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.56, 0.03, 240)) { Kind = PatternKind.Plain, Belly = new Tint(0.9, 0.01, 230), Accent = new Tint(0.44, 0.03, 240) },
                new Colouring(new Tint(0.22, 0.015, 260)) { Pattern = new Tint(0.94, 0.01, 90), Kind = PatternKind.Patches, Scale = 0.6, Belly = new Tint(0.95, 0.01, 90), Accent = new Tint(0.2, 0.015, 260), Limb = new Tint(0.2, 0.015, 260) },
                new Colouring(new Tint(0.76, 0.07, 10)) { Kind = PatternKind.Plain, Belly = new Tint(0.9, 0.03, 20), Accent = new Tint(0.66, 0.09, 10) },
                new Colouring(new Tint(0.9, 0.01, 220)) { Kind = PatternKind.Plain },
            },
        },
        fish with
        {
            Body = "puffer",
            Frequency = (0, 0, 0.22),
            Dominance = (0.93, 0.98),
            Signatures = new[] { Signature.None, Signature.BigEyes },
            Eye = (9.2, 5.6), EyeSize = 0.26,
            MouthCorner = 3, Teeth = 0,
            MouthOpenings = Weights.Of<double>((0, 1), (0.1, 0.5)),
            SwimmingPlans = Weights.Of((BodyPlan.Fish, 1)),
            Fins = new FinKit
            {
                Fins = new[]
                {
                    new FinSiteKit(FinPlace.Dorsal, FinStyle.Sail, 38, 0, 6, (0.13, 0.17), (0, 0), 0, 0.5),
                    new FinSiteKit(FinPlace.Ventral, FinStyle.Sail, 39, 0, 6, (0.1, 0.14), (0, 0), 0, 0.5),
                    new FinSiteKit(FinPlace.Pectoral, FinStyle.Paddle, 24, 8.6, 4, (0.2, 0.26), (0.8, 0.9), 0.2, 0.6),
                },
                Tail = TailStyle.Fan, TailSize = (0.16, 0.2), TailFork = (-0.4, -0.2),
            },
            Parts = new[] { new PartSlot(new PartChoice(1, Quills(0.075)), new PartChoice(0.5, Quills(0.14)), new PartChoice(0.4)) },
            Patterns = Weights.Of((PatternKind.Spots, 1), (PatternKind.Turing, 1), (PatternKind.Mottle, 0.6)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.62, 0.08, 85)) { Pattern = new Tint(0.32, 0.05, 70), Kind = PatternKind.Spots, Belly = new Tint(0.94, 0.01, 90) },
                new Colouring(new Tint(0.42, 0.06, 220)) { Pattern = new Tint(0.9, 0.02, 200), Kind = PatternKind.Spots, Belly = new Tint(0.94, 0.01, 200) },
                new Colouring(new Tint(0.78, 0.14, 92)) { Pattern = new Tint(0.3, 0.04, 70), Kind = PatternKind.Turing, Belly = new Tint(0.93, 0.03, 95) },
            },
        },
        fish with
        {
            Body = "swordfish",
            Frequency = (0, 0, 0.22),
            Dominance = (0.93, 0.98),
            Eye = (10, 6.8), EyeSize = 0.26,
            MouthCorner = 7, Teeth = 0,
            MouthOpenings = Weights.Of<double>((0, 1)),
            SwimmingPlans = Weights.Of((BodyPlan.Fish, 1)),
            Fins = new FinKit
            {
                Fins = new[]
                {
                    new FinSiteKit(FinPlace.Dorsal, FinStyle.Shark, 22, 0, 8, (0.22, 0.34), (0, 0), 0, 0.8),
                    new FinSiteKit(FinPlace.Ventral, FinStyle.Shark, 40, 0, 4, (0.09, 0.13), (0, 0), 0, 0.9),
                    new FinSiteKit(FinPlace.Pectoral, FinStyle.Paddle, 23, 11, 4, (0.3, 0.4), (0.26, 0.32), 0.6, 0.7),
                },
                Tail = TailStyle.Fork, TailSize = (0.28, 0.34), TailFork = (1.3, 1.7),
            },
            Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Bands, 0.6)),
            Colourings = new[]
            {
                new Colouring(new Tint(0.36, 0.07, 255)) { Kind = PatternKind.Plain, Belly = new Tint(0.9, 0.01, 230), Accent = new Tint(0.3, 0.08, 262) },
                new Colouring(new Tint(0.48, 0.08, 250)) { Pattern = new Tint(0.34, 0.10, 262), Kind = PatternKind.Bands, Belly = new Tint(0.9, 0.01, 230), Accent = new Tint(0.4, 0.15, 262) },
                new Colouring(new Tint(0.44, 0.03, 60)) { Kind = PatternKind.Plain, Belly = new Tint(0.86, 0.02, 80) },
                new Colouring(new Tint(0.58, 0.09, 205)) { Pattern = new Tint(0.40, 0.09, 240), Kind = PatternKind.Saddle, Belly = new Tint(0.93, 0.02, 200), Accent = new Tint(0.78, 0.14, 95) },
            },
        },
    };

    /// <summary>What all species have in common against their families: they keep more of their own table.</summary>
    public static SpeciesProfile Tamed(SpeciesProfile family) => family with
    {
        Dominance = (0.86, 0.96),
        Kinship = 0.6,
        Variety = 0.65,
        TiltVariety = 0.35,
        LatticeSpread = 0.16,
        HeadSize = (1.06, 0.7),
        Signatures = new[] { Signature.None, Signature.BigHead, Signature.BigEyes },
    };

    private static LegKit Paddling(double thickness, double claw) => new()
    {
        Sites = new[] { new LegSite(LimbArchetype.Sprawl, 27, 9.7, 0.10, 0.95, 0.88), new LegSite(LimbArchetype.Sprawl, 41, 9.8, -0.12, 1, 1) },
        Reach = (0.24, 0.28), HangingLength = 0.2, Thickness = thickness, Claw = claw,
    };

    private static PartKit[] Scutes()
    {
        var rows = new System.Collections.Generic.List<PartKit>();
        for (int ring = 18; ring < 52; ring += 2)
        {
            double size = ring < 26 ? 0.026 : ring < 44 ? 0.034 : 0.03;
            rows.Add(Scute(ring, ring < 44 ? 1.3 : 1.0, size));
            if (ring < 44)
            {
                rows.Add(Scute(ring, 3.2, size));
            }
        }

        return rows.ToArray();
    }

    private static PartKit Scute(double ring, double segment, double size) =>
        new(new FeatureBlueprint(FeatureKind.Scute, ring, segment, size, size * 0.95, 0.9, 0, -0.5, 0, 0, 0, 0, 0.75, 0.8), 0.85, 1.15);

    /// <summary>Rows of short spines over back and flanks.</summary>
    private static PartKit[] Quills(double length)
    {
        var quills = new System.Collections.Generic.List<PartKit>();
        for (int row = 0; row < 5; row++)
        {
            double first = 1.6 + (row % 2 * 1.1);
            for (double segment = first; segment < 14; segment += 2.6)
            {
                quills.Add(new PartKit(new FeatureBlueprint(FeatureKind.Spike, 18 + (3.6 * row), segment, length, 0.012 + (0.05 * length), 1, 0, -0.45, 0, 0, 0, 0, 1, 1), 0.85, 1.2));
            }
        }

        return quills.ToArray();
    }

    private static PartKit[] Gills()
    {
        var plumes = new PartKit[3];
        for (int k = 0; k < plumes.Length; k++)
        {
            plumes[k] = new PartKit(new FeatureBlueprint(FeatureKind.Tuft, 16.5 + k, 4.5 + (1.6 * k), 0.17, 0.032, 1, 0.45 - (0.35 * k), -0.55, 0.2, -0.12, -0.3, 0, 1, 0.7), 0.8, 1.2);
        }

        return plumes;
    }
}
