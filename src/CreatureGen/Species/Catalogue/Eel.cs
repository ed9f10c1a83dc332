using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Eels.</summary>
internal static class Eel
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Serpent.Profile.Tamed() with
    {
        Body = "eel",
        Table = new BodyTable(
            2.0,
            2.0,
            (0, -4, 34, 26, 22),   // nose
            (30, -4, 56, 40, 34),  // muzzle, front
            (50, -4, 68, 50, 42),  // muzzle
            (60, -4, 80, 60, 52),  // stop
            (60, -4, 88, 72, 62),  // brow
            (70, -2, 90, 80, 72),  // cranium
            (80, 0, 88, 86, 84),   // nape
            (120, 2, 86, 90, 92),  // neck
            (160, 2, 88, 94, 96),  // neck base
            (220, 0, 90, 96, 98),  // shoulders
            (300, 0, 88, 96, 98),  // ribs
            (320, 0, 84, 94, 96),  // belly
            (320, 0, 78, 90, 92),  // loin
            (300, 0, 70, 86, 88),  // pelvis
            (260, 0, 60, 80, 80),  // tail base
            (300, 0, 46, 70, 68),  // tail, first third
            (320, 0, 30, 52, 50),  // tail, second third
            (280, 0, 8, 16, 16)),  // tail tip
        TorsoLength = (0.35, 0.9),
        Frequency = (0, 0, 0.28),
        Dentition = NeedleTeeth.Teeth, ToothLength = 0.16, HeadOrnament = (0, 0),
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
    };
}
