using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Lions.</summary>
internal static class Lion
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Feline.Profile.Tamed() with
    {
        Body = "lion",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -14, 52, 42, 44),      // nose
            (28, -12, 82, 62, 66),     // muzzle, front
            (45, -12, 94, 68, 76),     // muzzle
            (50, -18, 110, 86, 88),    // stop
            (50, -22, 138, 128, 98),   // brow
            (85, -14, 156, 140, 110),  // cranium
            (100, 8, 118, 110, 115),   // nape
            (110, 50, 118, 120, 135),  // neck
            (130, 40, 140, 182, 204),  // neck base
            (140, 8, 181, 153, 282),   // shoulders
            (260, 0, 168, 134, 273),   // ribs
            (270, -3, 151, 114, 231),  // belly
            (240, 1, 118, 122, 143),   // loin
            (220, 10, 160, 102, 117),  // pelvis
            (130, 24, 55, 46, 46),     // tail base
            (300, 40, 34, 34, 34),     // tail, first third
            (320, 20, 28, 28, 28),     // tail, second third
            (240, -30, 20, 20, 20)),   // tail tip
        TailHair = TailHair.Tuft,
        TorsoLength = (0.9, 1.25),
        Frequency = (0.25, 0, 0),
        Dominance = (0.93, 0.98),
        Kinship = 0,
        Partners = new[] { "feline", "feline", "canine", "feline" },
        HipHeight = (0.62, 0.77),
        WalkingPlans = Weights.Of((BodyPlan.Digitigrade, 1)),
        HeadSize = (1.16, 0.7),
        EyeSize = 0.33, SlitPupils = 0, Ears = Weights.Of((EarShape.Round, 1)),
        Parts = new[] { new PartSlot(new PartChoice(1) { Mane = NeckPresets.Ruff }) },
        Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.70, 0.085, 75)) { Kind = PatternKind.Plain, Accent = new Tint(0.42, 0.085, 52) },
            new Colouring(new Tint(0.66, 0.075, 72)) { Kind = PatternKind.Plain, Accent = new Tint(0.26, 0.03, 50) },
            new Colouring(new Tint(0.84, 0.03, 85)) { Kind = PatternKind.Plain, Accent = new Tint(0.70, 0.06, 75) },
        },
    };
}
