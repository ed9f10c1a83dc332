using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Anglerfish.</summary>
internal static class Angler
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Fish.Profile.Tamed() with
    {
        Body = "angler",
        Table = new BodyTable(
            2.0,
            2.0,
            (0, 26, 92, 40, 52),       // nose
            (30, 22, 155, 76, 102),    // muzzle, front
            (50, 18, 195, 112, 152),   // muzzle
            (60, 12, 216, 152, 192),   // stop
            (70, 8, 230, 192, 222),    // brow
            (80, 4, 236, 214, 236),    // cranium
            (80, 0, 234, 222, 242),    // nape
            (90, 0, 226, 220, 242),    // neck
            (100, -2, 212, 210, 236),  // neck base
            (120, -2, 186, 194, 216),  // shoulders
            (140, -2, 150, 168, 182),  // ribs
            (130, -2, 116, 140, 142),  // belly
            (120, 0, 85, 105, 105),    // loin
            (110, 0, 60, 80, 80),      // pelvis
            (90, 0, 42, 60, 60),       // tail base
            (90, 0, 30, 45, 45),       // tail, first third
            (80, 0, 22, 42, 40),       // tail, second third
            (100, 0, 8, 30, 30)),      // tail tip
        Cover = SkinCover.Wrinkles, CoverSize = 0.05f,
        TorsoLength = (0.2, 0.55),
        Frequency = (0, 0, 0.26),
        Dominance = (0.93, 0.98),
        Signatures = new[] { Signature.None, Signature.BigEyes },
        Eye = (6.6, 5.0), EyeSize = 0.17,
        MouthCorner = 7, Dentition = NeedleTeeth.Teeth, Teeth = 1, ToothLength = 0.3,
        MouthOpenings = Weights.Of<double>((0.30, 1)),
        SwimmingPlans = Weights.Of((BodyPlan.Fish, 1)),
        Fins = new FinPreset
        {
            Fins = new[]
            {
                new FinSitePreset(FinPlace.Dorsal, FinStyle.Sail, 34, 0, 8, (0.13, 0.16), (0, 0), 0, 0.35),
                new FinSitePreset(FinPlace.Ventral, FinStyle.Sail, 36, 0, 6, (0.09, 0.11), (0, 0), 0, 0.35),
                new FinSitePreset(FinPlace.Pectoral, FinStyle.Carp, 25, 9, 4, (0.22, 0.27), (0.7, 0.8), 0.35, 0.6),
            },
            Tail = TailStyle.Fan, TailSize = (0.2, 0.26), TailFork = (-0.4, -0.2),
        },
        Parts = new[]
        {
            new PartSlot(new PartChoice(1, new PartPreset(new FeatureBlueprint(FeatureKind.Lure, Ring: 11, Segment: 0, Length: 0.52, Radius: 0.018, Outward: 0, Upward: 1, Forward: 0.25, Sideward: 0, BendUp: -0.42, BendForward: 0.75, BendSide: 0, Flatness: 1.6, Taper: 0.5), 0.8, 1.1))),
        },
        Patterns = Weights.Of((PatternKind.Mottle, 1), (PatternKind.Plain, 0.5)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.30, 0.03, 300)) { Kind = PatternKind.Mottle },
            new Colouring(new Tint(0.34, 0.05, 40)) { Kind = PatternKind.Mottle },
            new Colouring(new Tint(0.28, 0.04, 220)) { Kind = PatternKind.Mottle },
            new Colouring(new Tint(0.46, 0.14, 30)) { Kind = PatternKind.Plain },
        },
    };
}
