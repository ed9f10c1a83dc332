using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Spiders.</summary>
internal static class Spider
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = InsectParts.Common with
    {
        Body = "spider",
        Table = new BodyTable(
            2.0,
            2.1,
            (0, -40, 50, 40, 40),       // nose
            (30, -38, 92, 66, 60),      // muzzle, front
            (30, -32, 118, 84, 70),     // muzzle
            (30, -22, 134, 94, 75),     // stop
            (30, -12, 148, 102, 80),    // brow
            (40, -6, 158, 106, 80),     // cranium
            (50, 0, 172, 110, 85),      // nape
            (50, 0, 188, 115, 90),      // neck
            (70, 2, 202, 116, 90),      // neck base
            (100, 4, 208, 110, 90),     // shoulders
            (100, 4, 180, 100, 85),     // ribs
            (80, 2, 100, 72, 65),       // belly
            (60, -10, 44, 44, 44),      // loin
            (100, -16, 170, 165, 130),  // pelvis
            (120, -10, 258, 240, 190),  // tail base
            (180, 4, 290, 270, 220),    // tail, first third
            (200, 18, 215, 196, 170),   // tail, second third
            (160, 28, 20, 20, 20)),     // tail tip
        TorsoLength = (0.01, 0.04),
        Frequency = (0.14, 0, 0),
        Waist = 0.22, Annuli = new AnnuliBlueprint(41, 0),
        Dominance = (0.93, 0.98),
        HeadSize = (1, 0.3),
        Signatures = new[] { Signature.None, Signature.BigEyes, Signature.BigTail },
        Eye = (7.0, 3.2), EyeSize = 0.24, EyeStyle = EyeStyle.Bead,
        Legs = new LegPreset
        {
            Sites = new[]
            {
                new LegSite(LimbArchetype.Insect) { Ring = 20, Segment = 9.2, Azimuth = 0.80, Reach = 1.06 },
                new LegSite(LimbArchetype.Insect) { Ring = 23, Segment = 9.2, Azimuth = 0.28, Reach = 0.92 },
                new LegSite(LimbArchetype.Insect) { Ring = 26, Segment = 9.2, Azimuth = -0.26, Reach = 0.92 },
                new LegSite(LimbArchetype.Insect) { Ring = 29, Segment = 9.2, Azimuth = -0.78, Reach = 1.06 },
            },
            Reach = (0.42, 0.56), Height = (0.16, 0.28), Thickness = 0.06, KneeRise = 1.9,
        },
        Parts = new[]
        {
            new PartSlot(new PartChoice(
                1,
                InsectParts.Part(new FeatureBlueprint(FeatureKind.Mandible, Ring: 1.0, Segment: 11, Length: 0.19, Radius: 0.036, Outward: 0.3, Upward: -0.9, Forward: 0.3, Sideward: -0.05, BendUp: -0.2, BendForward: -0.3, BendSide: 0, Flatness: 1, Taper: 0.8), 0.85, 1.15),
                InsectParts.Part(new FeatureBlueprint(FeatureKind.Antenna, Ring: 2.5, Segment: 9.5, Length: 0.26, Radius: 0.024, Outward: 0, Upward: 0.2, Forward: 0.8, Sideward: 0.55, BendUp: -0.75, BendForward: 0.35, BendSide: -0.1, Flatness: 0.45, Taper: 0.4), 0.9, 1.1))),
            new PartSlot(new PartChoice(1, InsectParts.Ocellus(5.2, 1.3, 0.026), InsectParts.Ocellus(6.2, 5.4, 0.021), InsectParts.Ocellus(9.4, 2.6, 0.021), InsectParts.Ocellus(9.8, 5.4, 0.02))),
        },
        Patterns = Weights.Of((PatternKind.Bands, 1), (PatternKind.Mottle, 0.7), (PatternKind.Patches, 0.6), (PatternKind.Plain, 0.5)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.30, 0.03, 60)) { Pattern = new Tint(0.6, 0.08, 70), Kind = PatternKind.Mottle },
            new Colouring(new Tint(0.20, 0.015, 270)) { Pattern = new Tint(0.55, 0.2, 28), Kind = PatternKind.Patches, Accent = new Tint(0.55, 0.2, 28) },
            new Colouring(new Tint(0.45, 0.06, 65)) { Pattern = new Tint(0.25, 0.03, 50), Kind = PatternKind.Mottle },
            new Colouring(new Tint(0.36, 0.05, 40)) { Pattern = new Tint(0.68, 0.12, 60), Kind = PatternKind.Bands, Limb = new Tint(0.62, 0.12, 55) },
        },
    };
}
