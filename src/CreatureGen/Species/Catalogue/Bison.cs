using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Bison.</summary>
internal static class Bison
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Bovine.Profile.Tamed() with
    {
        Body = "bison",
        Table = new BodyTable(
            2.2,
            2.4,
            (0, -50, 74, 58, 60),      // nose
            (45, -48, 112, 82, 80),    // muzzle, front
            (62, -48, 106, 86, 84),    // muzzle
            (70, -48, 112, 108, 100),  // stop
            (75, -46, 142, 126, 118),  // brow
            (80, -36, 158, 140, 150),  // cranium
            (90, -12, 160, 165, 190),  // nape
            (110, 14, 175, 215, 230),  // neck
            (130, 18, 200, 271, 315),  // neck base
            (150, 8, 239, 324, 409),   // shoulders
            (250, 2, 246, 293, 384),   // ribs
            (250, 4, 226, 149, 330),   // belly
            (240, 2, 190, 118, 200),   // loin
            (220, 8, 190, 118, 140),   // pelvis
            (130, 26, 62, 63, 63),     // tail base
            (120, 75, 26, 28, 28),     // tail, first third
            (150, 82, 20, 20, 20),     // tail, second third
            (150, 84, 14, 14, 14)),    // tail tip
        TorsoLength = (1.35, 1.8),
        Frequency = (0.15, 0, 0),
        Dominance = (0.93, 0.98),
        Kinship = 0,
        Partners = new[] { "bovine", "bovine", "canine", "bovine" },
        HipHeight = (0.72, 0.80),
        Motion = new MotionTraits { RisesHindFirst = true },
        WalkingPlans = Weights.Of((BodyPlan.Unguligrade, 1)),
        HeadSize = (1.06, 0.6),
        EyeSize = 0.26,
        Parts = new[]
        {
            new PartSlot(new PartChoice(1) { Mane = NeckPresets.Shag }),
            new PartSlot(new PartChoice(1, new PartPreset(new FeatureBlueprint(FeatureKind.Horn, Ring: 12.4, Segment: 3.6, Length: 0.26, Radius: 0.05, Outward: 0.5, Upward: 0.15, Forward: 0, Sideward: 0.8, BendUp: 0.75, BendForward: 0.1, BendSide: -0.3, Flatness: 1, Taper: 1), 0.8, 1.3))),
        },
        Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1), new Weighted<PatternKind>(PatternKind.Saddle, 0.6) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.42, 0.06, 58)) { Kind = PatternKind.Plain, Accent = new Tint(0.24, 0.03, 50) },
            new Colouring(new Tint(0.34, 0.045, 50)) { Kind = PatternKind.Plain, Accent = new Tint(0.44, 0.07, 58) },
            new Colouring(new Tint(0.80, 0.03, 85)) { Kind = PatternKind.Plain, Accent = new Tint(0.66, 0.05, 75) },
        },
        IsCloven = true,
    };
}
