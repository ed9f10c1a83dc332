using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;

namespace CreatureGen.Sampling;

/// <summary>The families of the nine base bodies. Numbers were tuned by eye on sheets of unselected creatures.</summary>
internal static class FamilyProfiles
{
    private static readonly SpeciesProfile[] all =
    {
        new("canine")
        {
            Frequency = (0.62, 0.4, 0.16),
            Partners = new[] { "feline", "bovine", "reptile", "avian" },
            WalkingPlans = Weights.Of((BodyPlan.Digitigrade, 0.8), (BodyPlan.Upright, 0.15), (BodyPlan.Centaur, 0.05)),
            SwimmingPlans = Weights.Of((BodyPlan.Whale, 1)),
            Eye = (9.6, 5.2), EyeSize = 0.325, EyeSink = 0.66, EyeForward = 0.65, LidDegrees = (54, 64), Bone = 1,
            Swelling = (0.10, 0.10), MouthCorner = 8, MuzzleSquareness = 2.9, Nostril = 0.19,
            HeadOrnament = (1, 0.15), Ears = Weights.Of((EarShape.Pointed, 0.6), (EarShape.Drooping, 0.25), (EarShape.Big, 0.15)), Teeth = 0.5,
            Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Saddle, 1.2), (PatternKind.Patches, 0.8), (PatternKind.Spots, 0.5), (PatternKind.Rosettes, 0.1)),
        },
        new("bovine")
        {
            Frequency = (0.45, 0, 0),
            Partners = new[] { "canine", "amphibian", "reptile", "feline" },
            WalkingPlans = Weights.Of((BodyPlan.Unguligrade, 0.56), (BodyPlan.Columnar, 0.4), (BodyPlan.Centaur, 0.04)),
            SwimmingPlans = Weights.Of((BodyPlan.Whale, 1)),
            Eye = (9.6, 6.0), EyeSize = 0.35, EyeSink = 0.64, EyeForward = 0.4, LidDegrees = (50, 64), Bone = 0.8,
            Swelling = (0.10, 0.08), BarPupils = 0.55, TongueTints = Weights.Of((new Tint(0.60, 0.10, 14), 1), (new Tint(0.30, 0.045, 285), 0.35)), MouthCorner = 7, MuzzleSquareness = 2.9, Nostril = 0.19,
            HeadOrnament = (1, 0.85), Ears = Weights.Of((EarShape.Sideways, 1)),
            Patterns = Weights.Of((PatternKind.Patches, 1.2), (PatternKind.Plain, 0.9), (PatternKind.Stripes, 0.7), (PatternKind.Saddle, 0.8), (PatternKind.Giraffe, 1), (PatternKind.Rosettes, 0.15)),
        },
        new("feline")
        {
            Frequency = (0.75, 0.5, 0),
            Partners = new[] { "canine", "reptile", "avian", "serpent" },
            WalkingPlans = Weights.Of((BodyPlan.Digitigrade, 0.58), (BodyPlan.Plantigrade, 0.22), (BodyPlan.Upright, 0.17), (BodyPlan.Centaur, 0.03)),
            SwimmingPlans = Weights.Of((BodyPlan.Whale, 1)),
            Eye = (9.6, 5.0), EyeSize = 0.375, EyeSink = 0.60, EyeForward = 0.75, LidDegrees = (56, 66), SlitPupils = 0.75, Bone = 0.9,
            Swelling = (0.08, 0.13), MouthCorner = 7, MuzzleSquareness = 2.9, Nostril = 0.19,
            HeadOrnament = (1, 0.12), Ears = Weights.Of((EarShape.Pointed, 0.6), (EarShape.Round, 0.4)), Teeth = 0.5,
            Patterns = Weights.Of((PatternKind.Stripes, 1), (PatternKind.Spots, 0.8), (PatternKind.Plain, 0.6), (PatternKind.Saddle, 0.3), (PatternKind.Rosettes, 1.3), (PatternKind.Giraffe, 0.3)),
        },
        new("reptile")
        {
            Frequency = (0.45, 0.65, 0.3),
            Partners = new[] { "amphibian", "serpent", "canine", "avian" },
            WalkingPlans = Weights.Of((BodyPlan.Sprawling, 0.45), (BodyPlan.Theropod, 0.33), (BodyPlan.Plantigrade, 0.22)),
            SwimmingPlans = Weights.Of((BodyPlan.Flipper, 0.65), (BodyPlan.Fish, 0.2), (BodyPlan.Whale, 0.15)),
            Eye = (9.6, 4.8), EyeSize = 0.3125, EyeSink = 0.56, EyeForward = 0.4, LidDegrees = (56, 72), SlitPupils = 0.75, Bone = 0.8,
            Swelling = (0.16, 0.08), MouthCorner = 9, Nostril = 0.15, Mood = 0.55, TongueTints = Weights.Of((new Tint(0.60, 0.115, 14), 1), (new Tint(0.50, 0.13, 255), 0.25), (new Tint(0.30, 0.05, 350), 0.3)),
            HeadOrnament = (0.04, 0.4), Teeth = 0.55,
            Patterns = Weights.Of((PatternKind.Bands, 1), (PatternKind.Mottle, 1), (PatternKind.Stripes, 0.8), (PatternKind.Patches, 0.4), (PatternKind.Saddle, 0.3), (PatternKind.Rosettes, 0.12), (PatternKind.Giraffe, 0.15)),
        },
        new("avian")
        {
            Frequency = (0.2, 0.25, 0),
            Partners = new[] { "reptile", "feline", "canine", "fish" },
            WalkingPlans = Weights.Of((BodyPlan.Theropod, 1)),
            SwimmingPlans = Weights.Of((BodyPlan.Flipper, 1)),
            Eye = (9.6, 6.6), EyeSize = 0.4125, EyeSink = 0.60, EyeForward = 0.35, LidDegrees = (60, 72), Bone = 0.5,
            Swelling = (0.06, 0.04), TongueTints = Weights.Of((new Tint(0.62, 0.10, 20), 1), (new Tint(0.30, 0.04, 20), 0.4)), MouthCorner = 7, Nostril = 0.12,
            HeadOrnament = (0.02, 0.12), WingMembrane = 0.12,
            Patterns = Weights.Of((PatternKind.Saddle, 1), (PatternKind.Plain, 0.6), (PatternKind.Mottle, 0.7), (PatternKind.Bands, 0.4), (PatternKind.Spots, 0.4)),
        },
        new("fish")
        {
            Frequency = (0.2, 0.15, 1.5),
            Partners = new[] { "serpent", "amphibian", "reptile", "avian" },
            WalkingPlans = Weights.Of((BodyPlan.Theropod, 0.4), (BodyPlan.Sprawling, 0.6)),
            SwimmingPlans = Weights.Of((BodyPlan.Fish, 0.82), (BodyPlan.Whale, 0.18)),
            Eye = (10, 7.0), EyeSize = 0.3, EyeSink = 0.62, EyeForward = 0.3, LidDegrees = (70, 80), Bone = 0,
            Swelling = (0.03, 0.02), TongueTints = Weights.Of((new Tint(0.66, 0.06, 25), 1)), MouthCorner = 5, Nostril = 0.12,
            Teeth = 0.4,
            Patterns = Weights.Of((PatternKind.Bands, 1), (PatternKind.Stripes, 0.6), (PatternKind.Spots, 0.8), (PatternKind.Mottle, 0.5), (PatternKind.Saddle, 0.9), (PatternKind.Turing, 0.8)),
        },
        new("insect")
        {
            Frequency = (0.06, 0.08, 0),
            Partners = new[] { "amphibian", "reptile", "avian", "fish" },
            WalkingPlans = Weights.Of((BodyPlan.Hexapod, 1)),
            FlyingPlans = Weights.Of((BodyPlan.Buzzing, 1)),
            SwimmingPlans = Weights.Of((BodyPlan.Fish, 1)),
            Eye = (9, 6.8), EyeSize = 0.55, EyeSink = 0.45, EyeForward = 0.4, LidDegrees = (70, 80), Bone = 0,
            Nostril = 0,
            Patterns = Weights.Of((PatternKind.Bands, 1.2), (PatternKind.Plain, 0.8), (PatternKind.Spots, 0.6), (PatternKind.Saddle, 0.5)),
        },
        new("serpent")
        {
            Frequency = (0.38, 0.22, 0.2),
            Partners = new[] { "reptile", "fish", "feline", "amphibian" },
            WalkingPlans = Weights.Of((BodyPlan.ManyLegged, 0.42), (BodyPlan.Legless, 0.34), (BodyPlan.Sprawling, 0.24)),
            SwimmingPlans = Weights.Of((BodyPlan.Eel, 0.75), (BodyPlan.Fish, 0.25)),
            Eye = (9.6, 5.6), EyeSize = 0.3125, EyeSink = 0.56, EyeForward = 0.4, LidDegrees = (56, 72), SlitPupils = 0.75, Bone = 0.6,
            Swelling = (0.12, 0.12), Tongue = TongueStyle.Forked, TongueTints = Weights.Of((new Tint(0.40, 0.07, 300), 0.7), (new Tint(0.56, 0.17, 20), 1)), MouthCorner = 9, Nostril = 0.15, Mood = 0.55,
            HeadOrnament = (0, 0.35), Teeth = 0.55,
            Patterns = Weights.Of((PatternKind.Bands, 1.4), (PatternKind.Spots, 0.6), (PatternKind.Stripes, 0.6), (PatternKind.Mottle, 0.5)),
        },
        new("amphibian")
        {
            Frequency = (0.4, 0, 0.15),
            Partners = new[] { "reptile", "fish", "bovine", "feline" },
            WalkingPlans = Weights.Of((BodyPlan.Sprawling, 0.86), (BodyPlan.Plantigrade, 0.14)),
            SwimmingPlans = Weights.Of((BodyPlan.Flipper, 0.45), (BodyPlan.Whale, 0.3), (BodyPlan.Fish, 0.25)),
            Eye = (9.5, 4.2), EyeSize = 0.375, EyeSink = 0.25, EyeForward = 0.45, LidDegrees = (66, 72), SlitPupils = 0.35, BarPupils = 0.5, Bone = 0,
            Swelling = (0.16, 0.06), MouthCorner = 9, Nostril = 0.12,
            HeadOrnament = (0, 0.12),
            Patterns = Weights.Of((PatternKind.Spots, 1), (PatternKind.Mottle, 0.9), (PatternKind.Patches, 0.6), (PatternKind.Bands, 0.4), (PatternKind.Turing, 0.9)),
        },
    };

    /// <summary>All families, in a fixed order.</summary>
    public static IReadOnlyList<SpeciesProfile> All => all;

    /// <summary>The profile of a family.</summary>
    public static SpeciesProfile Find(string family) => Array.Find(all, profile => profile.Family == family)!;
}
