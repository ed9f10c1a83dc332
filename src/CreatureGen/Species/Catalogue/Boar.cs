using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Boars.</summary>
internal static class Boar
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Bovine.Profile.Tamed() with
    {
        Body = "boar",
        Table = new BodyTable(
            2.1,
            2.3,
            (0, -30, 62, 52, 50),      // nose
            (26, -30, 66, 56, 54),     // muzzle, front
            (80, -30, 70, 62, 62),     // muzzle
            (90, -31, 92, 86, 84),     // stop
            (80, -32, 128, 122, 108),  // brow
            (90, -24, 146, 142, 130),  // cranium
            (100, -4, 150, 158, 160),  // nape
            (95, 14, 158, 186, 196),   // neck
            (100, 16, 172, 241, 218),  // neck base
            (140, 8, 214, 254, 285),   // shoulders
            (230, 1, 214, 222, 276),   // ribs
            (230, 3, 193, 180, 228),   // belly
            (210, 4, 163, 162, 110),   // loin
            (190, 10, 156, 128, 72),   // pelvis
            (90, 28, 46, 48, 48),      // tail base
            (90, 70, 18, 19, 19),      // tail, first third
            (90, 75, 14, 15, 15),      // tail, second third
            (90, 75, 18, 22, 22)),     // tail tip
        TorsoLength = (0.7, 1.05),
        Frequency = (0.24, 0, 0),
        Kinship = 0,
        HipHeight = (0.52, 0.66), LegGirth = 1.15,
        Eye = (9.6, 5.2), EyeSize = 0.2,
        HeadOrnament = (1, 0), EarSize = 0.8, Ears = Weights.Of((EarShape.Pointed, 1), (EarShape.Drooping, 0.4)),
        WalkingPlans = Weights.Of((BodyPlan.Unguligrade, 1)),
        Parts = new[]
        {
            new PartSlot(
                new PartChoice(1, new PartPreset(new FeatureBlueprint(FeatureKind.Tusk, Ring: 3.4, Segment: 10.4, Length: 0.13, Radius: 0.022, Outward: 0.1, Upward: 0.1, Forward: 0.5, Sideward: 0.45, BendUp: 0.8, BendForward: 0, BendSide: 0, Flatness: 1, Taper: 0.9), 0.7, 1.6)),
                new PartChoice(0.4)),
            new PartSlot(new PartChoice(1) { Mane = NeckPresets.Bristles }),
        },
        Patterns = Weights.Of((PatternKind.Plain, 1), (PatternKind.Patches, 0.6), (PatternKind.Mottle, 0.5)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.34, 0.03, 55)) { Kind = PatternKind.Plain, Accent = new Tint(0.22, 0.02, 50) },
            new Colouring(new Tint(0.78, 0.06, 25)) { Pattern = new Tint(0.28, 0.02, 50), Kind = PatternKind.Patches, Muzzle = new Tint(0.72, 0.09, 20) },
            new Colouring(new Tint(0.52, 0.09, 48)) { Kind = PatternKind.Mottle, Accent = new Tint(0.88, 0.03, 80) },
        },
        IsCloven = true,
    };
}
