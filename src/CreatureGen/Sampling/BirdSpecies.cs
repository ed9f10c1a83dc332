using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>Birds: a beak is the pitch of the first stations of the table; legs, folded wing and tail fan are proportions.</summary>
internal static class BirdSpecies
{
    private static readonly SpeciesProfile avian = SwimmerSpecies.Tamed(FamilyProfiles.Find("avian")) with
    {
        HeadSize = (1.12, 0.7),
        LatticeSpread = 0.16,
        HeadOrnament = (0, 0),
        WingMembrane = 0,
        WalkingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Theropod, 1) },
        FlyingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Flapping, 1) },
    };

    /// <summary>All of them, in a fixed order.</summary>
    public static readonly SpeciesProfile[] All =
    {
        avian with
        {
            Body = "duck",
            Frequency = (0.19, 0.25, 0),
            Eye = (10.2, 6.2), EyeSize = 0.30,
            Bird = new BirdKit { HipHeight = (0.46, 0.55), Thigh = (0.46, 0.58), Foot = 1.15, Claw = 0.3, HipSegment = 9.6, FoldRing = 46.5, Fan = 0.10 },
            Parts = new[] { new PartSlot(new PartChoice(1, Crest(0.6)), new PartChoice(3)) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.80, 0.02, 90)) { Kind = PatternKind.Plain, Limb = new Tint(0.66, 0.14, 55), Muzzle = new Tint(0.72, 0.15, 62) },
                new Colouring(new Tint(0.56, 0.05, 70)) { Pattern = new Tint(0.38, 0.05, 60), Kind = PatternKind.Mottle, Limb = new Tint(0.62, 0.15, 50), Accent = new Tint(0.45, 0.11, 160), Muzzle = new Tint(0.74, 0.14, 85) },
                new Colouring(new Tint(0.86, 0.10, 95)) { Kind = PatternKind.Plain, Limb = new Tint(0.66, 0.15, 55), Muzzle = new Tint(0.70, 0.16, 58) },
                new Colouring(new Tint(0.30, 0.04, 250)) { Kind = PatternKind.Plain, Belly = new Tint(0.90, 0.01, 90), Limb = new Tint(0.60, 0.14, 50), Accent = new Tint(0.90, 0.01, 90), Muzzle = new Tint(0.55, 0.10, 240) },
                new Colouring(new Tint(0.50, 0.11, 40)) { Kind = PatternKind.Plain, Belly = new Tint(0.62, 0.10, 60), Limb = new Tint(0.32, 0.03, 60), Accent = new Tint(0.34, 0.08, 160), Muzzle = new Tint(0.24, 0.02, 60) },
            },
        },
        avian with
        {
            Body = "raptor",
            Frequency = (0.15, 0.32, 0),
            Eye = (9.8, 5.6), EyeSize = 0.36, Bone = 1.15, Mood = 0.55, LidDegrees = (50, 72),
            Bird = new BirdKit { HipHeight = (0.57, 0.72), Thigh = (0.68, 0.80), Foot = 1.15, Claw = 1.8, FoldRing = 48, Fan = 0.17, FlightPitch = (-16, -4) },
            Parts = new[] { new PartSlot(new PartChoice(1, Crest(0.7)), new PartChoice(2.2)) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.42, 0.05, 58)) { Pattern = new Tint(0.26, 0.03, 50), Kind = PatternKind.Mottle, Limb = new Tint(0.80, 0.13, 90), Muzzle = new Tint(0.78, 0.15, 85) },
                new Colouring(new Tint(0.55, 0.06, 60)) { Pattern = new Tint(0.32, 0.05, 50), Kind = PatternKind.Bands, Limb = new Tint(0.78, 0.13, 88), Muzzle = new Tint(0.32, 0.02, 60) },
                new Colouring(new Tint(0.50, 0.02, 250)) { Pattern = new Tint(0.34, 0.02, 250), Kind = PatternKind.Bands, Limb = new Tint(0.78, 0.13, 88), Muzzle = new Tint(0.34, 0.02, 250) },
                new Colouring(new Tint(0.28, 0.02, 60)) { Kind = PatternKind.Plain, Belly = new Tint(0.34, 0.03, 50), Limb = new Tint(0.78, 0.14, 90), Accent = new Tint(0.92, 0.02, 90), Muzzle = new Tint(0.80, 0.15, 88) },
                new Colouring(new Tint(0.56, 0.12, 46)) { Pattern = new Tint(0.30, 0.04, 40), Kind = PatternKind.Spots, Belly = new Tint(0.86, 0.06, 75), Limb = new Tint(0.78, 0.13, 88), Muzzle = new Tint(0.4, 0.03, 240) },
            },
        },
        avian with
        {
            Body = "ostrich",
            Frequency = (0.19, 0, 0),
            Eye = (10.0, 6.0), EyeSize = 0.44,
            Bird = new BirdKit { HipHeight = (1.07, 1.3), Thigh = (0.56, 0.66), Toes = 2, FoldRing = 43, Fan = 0.12 },
            Parts = new[] { new PartSlot(new PartChoice(1, Crest(0.8)), new PartChoice(2)) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.28, 0.015, 60)) { Kind = PatternKind.Plain, Limb = new Tint(0.68, 0.05, 40), Accent = new Tint(0.85, 0.02, 80), Muzzle = new Tint(0.62, 0.08, 45) },
                new Colouring(new Tint(0.52, 0.04, 70)) { Kind = PatternKind.Mottle, Limb = new Tint(0.62, 0.06, 50), Muzzle = new Tint(0.6, 0.06, 60) },
                new Colouring(new Tint(0.24, 0.02, 270)) { Kind = PatternKind.Plain, Limb = new Tint(0.5, 0.03, 70), Accent = new Tint(0.50, 0.16, 250), Muzzle = new Tint(0.50, 0.15, 250) },
            },
        },
        avian with
        {
            Body = "parrot",
            Frequency = (0.15, 0.25, 0),
            Eye = (10.4, 6.4), EyeSize = 0.275,
            Bird = new BirdKit { HipHeight = (0.44, 0.52), Thigh = (0.48, 0.60), Foot = 0.9, FoldRing = 47.5, Fan = 0.11, FlightPitch = (-34, -40) },
            Parts = new[] { new PartSlot(new PartChoice(1.2, Crest(1)), new PartChoice(1)) },
            Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1), new Weighted<PatternKind>(PatternKind.Saddle, 0.7), new Weighted<PatternKind>(PatternKind.Patches, 0.4) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.58, 0.20, 28)) { Kind = PatternKind.Plain, Accent = new Tint(0.55, 0.16, 255), Muzzle = new Tint(0.25, 0.02, 60) },
                new Colouring(new Tint(0.66, 0.18, 138)) { Kind = PatternKind.Plain, Accent = new Tint(0.60, 0.20, 30), Muzzle = new Tint(0.75, 0.12, 75) },
                new Colouring(new Tint(0.58, 0.15, 245)) { Kind = PatternKind.Plain, Belly = new Tint(0.82, 0.16, 92), Accent = new Tint(0.82, 0.16, 92), Muzzle = new Tint(0.25, 0.02, 60) },
                new Colouring(new Tint(0.88, 0.04, 95)) { Kind = PatternKind.Plain, Accent = new Tint(0.85, 0.16, 95), Muzzle = new Tint(0.35, 0.02, 60) },
                new Colouring(new Tint(0.62, 0.02, 250)) { Kind = PatternKind.Plain, Belly = new Tint(0.76, 0.02, 250), Accent = new Tint(0.52, 0.20, 25), Muzzle = new Tint(0.24, 0.02, 60) },
                new Colouring(new Tint(0.80, 0.16, 95)) { Kind = PatternKind.Plain, Belly = new Tint(0.86, 0.13, 98), Accent = new Tint(0.62, 0.16, 140), Muzzle = new Tint(0.78, 0.06, 60) },
                new Colouring(new Tint(0.48, 0.14, 300)) { Kind = PatternKind.Plain, Accent = new Tint(0.72, 0.16, 60), Muzzle = new Tint(0.25, 0.02, 60) },
            },
        },
        avian with
        {
            Body = "heron",
            Frequency = (0.19, 0.22, 0),
            Eye = (9.8, 6.2), EyeSize = 0.375,
            Bird = new BirdKit { HipHeight = (1.0, 1.33), Thigh = (0.36, 0.46), Foot = 1.5, FoldRing = 47, Fan = 0, FlightPitch = (-14, -6) },
            Parts = new[] { new PartSlot(new PartChoice(1.5, Plumes()), new PartChoice(1)) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.68, 0.02, 245)) { Pattern = new Tint(0.3, 0.02, 250), Kind = PatternKind.Saddle, Limb = new Tint(0.55, 0.06, 90), Muzzle = new Tint(0.72, 0.13, 75) },
                new Colouring(new Tint(0.90, 0.01, 90)) { Kind = PatternKind.Plain, Limb = new Tint(0.28, 0.02, 60), Muzzle = new Tint(0.74, 0.14, 80) },
                new Colouring(new Tint(0.80, 0.09, 20)) { Kind = PatternKind.Plain, Limb = new Tint(0.70, 0.12, 20), Muzzle = new Tint(0.4, 0.05, 20) },
                new Colouring(new Tint(0.36, 0.06, 270)) { Pattern = new Tint(0.50, 0.06, 30), Kind = PatternKind.Saddle, Limb = new Tint(0.72, 0.14, 90), Muzzle = new Tint(0.3, 0.02, 260) },
            },
        },
        avian with
        {
            Body = "owl",
            Frequency = (0.17, 0.2, 0),
            Eye = (8.6, 4.6), EyeSize = 0.40, EyeForward = 2, Bone = 1.15, Mood = 0.4, LidDegrees = (54, 72),
            Bird = new BirdKit { HipHeight = (0.34, 0.44), Thigh = (0.50, 0.62), Foot = 0.9, Claw = 1.5, FoldRing = 47, Fan = 0.11, FlightPitch = (-40, -26) },
            Parts = new[] { new PartSlot(new PartChoice(1.3, new PartKit(new FeatureBlueprint(FeatureKind.Tuft, 11.5, 3.2, 0.17, 0.045, 0.5, 0.8, 0, 0.3, 0, -0.2, 0, 0.5, 0.7), 0.8, 1.3)), new PartChoice(1)) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.55, 0.06, 62)) { Pattern = new Tint(0.32, 0.04, 55), Kind = PatternKind.Mottle, Limb = new Tint(0.6, 0.05, 70), Muzzle = new Tint(0.3, 0.02, 60) },
                new Colouring(new Tint(0.88, 0.02, 85)) { Pattern = new Tint(0.4, 0.03, 60), Kind = PatternKind.Spots, Muzzle = new Tint(0.3, 0.02, 60) },
                new Colouring(new Tint(0.42, 0.04, 50)) { Pattern = new Tint(0.7, 0.05, 75), Kind = PatternKind.Spots, Muzzle = new Tint(0.75, 0.1, 85) },
                new Colouring(new Tint(0.66, 0.09, 65)) { Pattern = new Tint(0.46, 0.06, 55), Kind = PatternKind.Mottle, Belly = new Tint(0.93, 0.02, 85), Muzzle = new Tint(0.78, 0.08, 60) },
            },
        },
        avian with
        {
            Body = "penguin",
            Frequency = (0.16, 0, 0),
            Dominance = (0.93, 0.98),
            Eye = (9.8, 6.0), EyeSize = 0.26,
            Bird = new BirdKit { HipHeight = (0.2, 0.27), Thigh = (0.6, 0.7), Foot = 1.2, Claw = 0.5, FoldRing = 41, Fan = 0.08 },
            Parts = new[] { new PartSlot(new PartChoice(1, Brows()), new PartChoice(2)) },
            Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1), new Weighted<PatternKind>(PatternKind.Saddle, 0.5) },
            Colourings = new[]
            {
                new Colouring(new Tint(0.25, 0.02, 260)) { Kind = PatternKind.Plain, Belly = new Tint(0.95, 0.01, 90), Limb = new Tint(0.3, 0.02, 60), Accent = new Tint(0.80, 0.15, 80), Muzzle = new Tint(0.62, 0.17, 50) },
                new Colouring(new Tint(0.46, 0.05, 250)) { Kind = PatternKind.Plain, Belly = new Tint(0.94, 0.01, 220), Limb = new Tint(0.72, 0.08, 30), Accent = new Tint(0.36, 0.05, 250), Muzzle = new Tint(0.3, 0.02, 260) },
                new Colouring(new Tint(0.40, 0.015, 250)) { Kind = PatternKind.Plain, Belly = new Tint(0.93, 0.01, 90), Limb = new Tint(0.66, 0.15, 55), Accent = new Tint(0.84, 0.16, 92), Muzzle = new Tint(0.55, 0.15, 40) },
            },
        },
        avian with
        {
            Body = "toucan",
            Frequency = (0.14, 0.22, 0),
            Dominance = (0.92, 0.97),
            Eye = (10.6, 6.2), EyeSize = 0.28,
            Bird = new BirdKit { HipHeight = (0.44, 0.52), Thigh = (0.48, 0.60), Foot = 0.9, FoldRing = 47, Fan = 0.11, FlightPitch = (-34, -34) },
            Parts = System.Array.Empty<PartSlot>(),
            Colourings = new[]
            {
                new Colouring(new Tint(0.24, 0.015, 270)) { Kind = PatternKind.Plain, Belly = new Tint(0.93, 0.03, 95), Limb = new Tint(0.45, 0.06, 240), Accent = new Tint(0.36, 0.06, 270), Muzzle = new Tint(0.74, 0.17, 65) },
                new Colouring(new Tint(0.26, 0.02, 150)) { Kind = PatternKind.Plain, Belly = new Tint(0.86, 0.15, 100), Limb = new Tint(0.45, 0.06, 240), Accent = new Tint(0.56, 0.19, 28), Muzzle = new Tint(0.72, 0.16, 130) },
                new Colouring(new Tint(0.34, 0.05, 30)) { Kind = PatternKind.Plain, Belly = new Tint(0.62, 0.17, 30), Limb = new Tint(0.4, 0.04, 60), Accent = new Tint(0.84, 0.15, 92), Muzzle = new Tint(0.24, 0.02, 60) },
                new Colouring(new Tint(0.92, 0.02, 90)) { Pattern = new Tint(0.24, 0.02, 260), Kind = PatternKind.Saddle, Limb = new Tint(0.55, 0.13, 40), Accent = new Tint(0.24, 0.02, 260), Muzzle = new Tint(0.66, 0.18, 45) },
                new Colouring(new Tint(0.44, 0.10, 150)) { Kind = PatternKind.Plain, Belly = new Tint(0.66, 0.13, 150), Limb = new Tint(0.4, 0.05, 150), Accent = new Tint(0.6, 0.17, 35), Muzzle = new Tint(0.84, 0.14, 95) },
            },
        },
    };

    /// <summary>Five tufts over the crown.</summary>
    private static PartKit[] Crest(double size)
    {
        var tufts = new PartKit[5];
        for (int q = 0; q < tufts.Length; q++)
        {
            double length = 0.12 * size * (1 - (0.5 * System.Math.Abs((q / 4.0) - 0.35)));
            tufts[q] = new PartKit(new FeatureBlueprint(FeatureKind.Tuft, 11 + (q * 0.9), 0, length, 0.024, 0.8, 0, -0.6, 0, 0.1, -0.3, 0, 0.5, 0.7), 0.85, 1.3);
        }

        return tufts;
    }

    /// <summary>A long feather over each eye.</summary>
    private static PartKit[] Brows() => new[]
    {
        new PartKit(new FeatureBlueprint(FeatureKind.Tuft, 9.4, 4.0, 0.2, 0.016, 0.35, 0.2, -0.8, 0.5, -0.15, 0, 0, 0.6, 0.8), 0.8, 1.3),
        new PartKit(new FeatureBlueprint(FeatureKind.Tuft, 10.2, 3.4, 0.15, 0.014, 0.4, 0.3, -0.8, 0.4, -0.1, 0, 0, 0.6, 0.8), 0.8, 1.3),
    };

    /// <summary>Two long feathers from the nape.</summary>
    private static PartKit[] Plumes() => new[]
    {
        new PartKit(new FeatureBlueprint(FeatureKind.Tuft, 13.5, 1.0, 0.26, 0.014, 0.35, 0.1, -1, 0, -0.35, 0, 0, 0.6, 0.8), 0.8, 1.3),
        new PartKit(new FeatureBlueprint(FeatureKind.Tuft, 13.0, 0, 0.2, 0.014, 0.4, 0.1, -1, 0, -0.3, 0, 0, 0.6, 0.8), 0.8, 1.3),
    };
}
