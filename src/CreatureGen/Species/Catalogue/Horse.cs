using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Horses.</summary>
internal static class Horse
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Bovine.Profile.Tamed() with
    {
        Body = "horse",
        Table = new BodyTable(
            2.1,
            2.3,
            (0, -46, 58, 50, 48),      // nose
            (42, -46, 78, 66, 64),     // muzzle, front
            (85, -46, 74, 70, 72),     // muzzle
            (100, -46, 84, 92, 92),    // stop
            (80, -44, 112, 112, 112),  // brow
            (75, -30, 116, 112, 116),  // cranium
            (90, 14, 92, 110, 112),    // nape
            (170, 54, 96, 135, 140),   // neck
            (190, 46, 118, 190, 254),  // neck base
            (170, 12, 165, 155, 344),  // shoulders
            (250, 2, 198, 112, 324),   // ribs
            (250, -2, 218, 87, 334),   // belly
            (230, 1, 184, 143, 230),   // loin
            (210, 10, 198, 125, 146),  // pelvis
            (110, 26, 68, 58, 58),     // tail base
            (130, 62, 42, 46, 46),     // tail, first third
            (170, 76, 50, 56, 56),     // tail, second third
            (180, 80, 24, 28, 28)),    // tail tip
        TailHair = TailHair.Skirt,
        TorsoLength = (1.1, 1.5),
        Frequency = (0.25, 0, 0),
        Dominance = (0.93, 0.98),
        Kinship = 0,
        Partners = new[] { "bovine", "bovine", "canine", "bovine" },
        HipHeight = (0.88, 1.12),
        WalkingPlans = Weights.Of((BodyPlan.Unguligrade, 1)),
        HeadSize = (1.0, 0.6),
        EyeSize = 0.33, BarPupils = 0.8, Ears = Weights.Of((EarShape.Pointed, 1)),
        Parts = new[] { new PartSlot(new PartChoice(1) { Mane = NeckPresets.Falling }), new PartSlot(new PartChoice(0.15, MammalParts.NoseHorn(10.6, 0.42, 0.028)), new PartChoice(1)) },
        Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1), new Weighted<PatternKind>(PatternKind.Patches, 0.7), new Weighted<PatternKind>(PatternKind.Stripes, 0.6) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.46, 0.085, 48)) { Kind = PatternKind.Plain, Limb = new Tint(0.22, 0.02, 50), Accent = new Tint(0.19, 0.015, 50) },
            new Colouring(new Tint(0.58, 0.09, 58)) { Kind = PatternKind.Plain, Accent = new Tint(0.86, 0.05, 85) },
            new Colouring(new Tint(0.90, 0.012, 85)) { Pattern = new Tint(0.20, 0.01, 60), Kind = PatternKind.Stripes, Accent = new Tint(0.24, 0.01, 60) },
            new Colouring(new Tint(0.86, 0.02, 85)) { Pattern = new Tint(0.42, 0.07, 50), Kind = PatternKind.Patches, Accent = new Tint(0.88, 0.02, 85) },
            new Colouring(new Tint(0.62, 0.012, 260)) { Kind = PatternKind.Mottle, Accent = new Tint(0.82, 0.01, 260) },
        },
        IsCloven = false,
    };
}
