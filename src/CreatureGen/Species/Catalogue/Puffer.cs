using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Pufferfish.</summary>
internal static class Puffer
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Fish.Profile.Tamed() with
    {
        Body = "puffer",
        Table = new BodyTable(
            2.0,
            2.0,
            (0, 0, 30, 30, 30),       // nose
            (30, 0, 60, 56, 56),      // muzzle, front
            (45, 0, 90, 90, 84),      // muzzle
            (50, 0, 130, 130, 124),   // stop
            (60, 0, 175, 165, 170),   // brow
            (80, 0, 215, 200, 225),   // cranium
            (90, 0, 240, 220, 262),   // nape
            (90, 0, 252, 228, 282),   // neck
            (100, 0, 256, 230, 290),  // neck base
            (120, 0, 250, 226, 286),  // shoulders
            (150, 0, 226, 206, 256),  // ribs
            (130, 0, 180, 170, 202),  // belly
            (110, 0, 128, 126, 140),  // loin
            (100, 0, 84, 90, 92),     // pelvis
            (90, 0, 54, 64, 62),      // tail base
            (80, 0, 36, 46, 44),      // tail, first third
            (70, 0, 26, 40, 38),      // tail, second third
            (70, 0, 10, 30, 30)),     // tail tip
        Cover = SkinCover.Wrinkles, CoverSize = 0.022f,
        TorsoLength = (0.1, 0.3),
        Frequency = (0, 0, 0.22),
        Dominance = (0.93, 0.98),
        Signatures = new[] { Signature.None, Signature.BigEyes },
        Eye = (9.2, 5.6), EyeSize = 0.26,
        MouthCorner = 3, Teeth = 0,
        MouthOpenings = Weights.Of<double>((0, 1), (0.1, 0.5)),
        SwimmingPlans = Weights.Of((BodyPlan.Fish, 1)),
        Fins = new FinPreset
        {
            Fins = new[]
            {
                new FinSitePreset(FinPlace.Dorsal, FinStyle.Sail, 38, 0, 6, (0.13, 0.17), (0, 0), 0, 0.5),
                new FinSitePreset(FinPlace.Ventral, FinStyle.Sail, 39, 0, 6, (0.1, 0.14), (0, 0), 0, 0.5),
                new FinSitePreset(FinPlace.Pectoral, FinStyle.Carp, 24, 8.6, 4, (0.2, 0.26), (0.8, 0.9), 0.2, 0.6),
            },
            Tail = TailStyle.Fan, TailSize = (0.16, 0.2), TailFork = (-0.4, -0.2),
        },
        Parts = new[] { new PartSlot(new PartChoice(1, SwimmerParts.Quills(0.075)), new PartChoice(0.5, SwimmerParts.Quills(0.14)), new PartChoice(0.4)) },
        Patterns = Weights.Of((PatternKind.Spots, 1), (PatternKind.Turing, 1), (PatternKind.Mottle, 0.6)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.62, 0.08, 85)) { Pattern = new Tint(0.32, 0.05, 70), Kind = PatternKind.Spots, Belly = new Tint(0.94, 0.01, 90) },
            new Colouring(new Tint(0.42, 0.06, 220)) { Pattern = new Tint(0.9, 0.02, 200), Kind = PatternKind.Spots, Belly = new Tint(0.94, 0.01, 200) },
            new Colouring(new Tint(0.78, 0.14, 92)) { Pattern = new Tint(0.3, 0.04, 70), Kind = PatternKind.Turing, Belly = new Tint(0.93, 0.03, 95) },
        },
    };
}
