using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Hyenas.</summary>
internal static class Hyena
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Canine.Profile.Tamed() with
    {
        Body = "hyena",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -14, 46, 40, 42),      // nose
            (30, -14, 70, 58, 58),     // muzzle, front
            (60, -14, 78, 62, 64),     // muzzle
            (60, -18, 96, 76, 76),     // stop
            (50, -22, 126, 124, 86),   // brow
            (80, -14, 146, 132, 104),  // cranium
            (90, 14, 116, 110, 118),   // nape
            (120, 58, 118, 124, 140),  // neck
            (130, 48, 145, 196, 230),  // neck base
            (140, 16, 186, 168, 355),  // shoulders
            (250, 12, 182, 138, 297),  // ribs
            (250, 10, 158, 107, 218),  // belly
            (220, 9, 115, 115, 89),    // loin
            (200, 16, 134, 83, 57),    // pelvis
            (130, 34, 48, 35, 35),     // tail base
            (130, 55, 38, 42, 42),     // tail, first third
            (140, 60, 36, 40, 40),     // tail, second third
            (120, 60, 18, 20, 20)),    // tail tip
        TorsoLength = (0.65, 0.9),
        Frequency = (0.18, 0, 0),
        Dominance = (0.93, 0.98),
        Kinship = 0,
        Partners = new[] { "canine", "feline", "canine", "canine" },
        HipHeight = (0.65, 0.83),
        WalkingPlans = Weights.Of((BodyPlan.Digitigrade, 1)),
        HeadSize = (1.14, 0.7),
        Ears = Weights.Of((EarShape.Round, 1)), 
        Parts = new[] { new PartSlot(new PartChoice(1) { Mane = NeckPresets.Bristles }) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.62, 0.05, 75)) { Pattern = new Tint(0.28, 0.03, 60), Kind = PatternKind.Spots, Limb = new Tint(0.36, 0.035, 60), Accent = new Tint(0.36, 0.04, 60) },
            new Colouring(new Tint(0.68, 0.04, 80)) { Pattern = new Tint(0.24, 0.02, 60), Kind = PatternKind.Stripes, Accent = new Tint(0.24, 0.02, 60) },
            new Colouring(new Tint(0.40, 0.05, 55)) { Kind = PatternKind.Plain, Accent = new Tint(0.60, 0.07, 70) },
        },
    };
}
