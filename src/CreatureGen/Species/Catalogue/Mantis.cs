using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Mantises.</summary>
internal static class Mantis
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = InsectParts.Common with
    {
        Body = "mantis",
        Table = new BodyTable(
            2.0,
            2.2,
            (0, -80, 20, 20, 20),      // nose
            (30, -80, 45, 40, 40),     // muzzle, front
            (40, -78, 70, 52, 52),     // muzzle
            (45, -74, 105, 66, 64),    // stop
            (50, -66, 150, 76, 70),    // brow
            (50, -50, 150, 66, 64),    // cranium
            (50, -10, 75, 50, 50),     // nape
            (50, 35, 48, 45, 45),      // neck
            (140, 50, 52, 50, 50),     // neck base
            (260, 50, 68, 64, 64),     // shoulders
            (180, 28, 88, 82, 92),     // ribs
            (120, 6, 100, 92, 104),    // belly
            (160, -2, 112, 98, 115),   // loin
            (240, -5, 122, 104, 126),  // pelvis
            (240, -5, 116, 98, 116),   // tail base
            (200, -4, 94, 82, 92),     // tail, first third
            (180, 0, 62, 52, 56),      // tail, second third
            (120, 4, 12, 12, 12)),     // tail tip
        TorsoLength = (0.03, 0.07),
        Frequency = (0.13, 0.12, 0),
        Dominance = (0.93, 0.98),
        Eye = (9.6, 7.4), EyeSize = 0.62, EyeSink = 0.55,
        Waist = 0.72, Annuli = new AnnuliBlueprint(36, 0.05),
        Legs = new LegPreset
        {
            Sites = new[]
            {
                new LegSite(LimbArchetype.Insect) { Ring = 29, Segment = 9.7, Azimuth = 0.45, Reach = 1.05 },
                new LegSite(LimbArchetype.Insect) { Ring = 33, Segment = 9.7, Azimuth = -0.5, Reach = 1.05 },
            },
            Arms = new[]
            {
                new LegSite(LimbArchetype.Raptorial) { Ring = 24, Segment = 10, Reach = 0.52, Thickness = 1.9 },
            },
            Reach = (0.34, 0.42), Height = (0.40, 0.55), Thickness = 0.032,
        },
        Wings = new ThinWings
        {
            Spread = new[] { new ThinWing(ring: 28, length: 0.95, width: 0.22, azimuth: -18, elevation: 32), new ThinWing(ring: 31, length: 0.85, width: 0.28, azimuth: -44, elevation: 24) },
            Folded = new[] { new ThinWing(ring: 30, length: 0.80, width: 0.23, azimuth: -76, elevation: 6) },
        },
        Parts = new[] { InsectParts.SmallJaws(), InsectParts.Long(0.42) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.68, 0.15, 128)),
            new Colouring(new Tint(0.62, 0.07, 80)) { Kind = PatternKind.Mottle },
            new Colouring(new Tint(0.84, 0.05, 5)) { Accent = new Tint(0.7, 0.15, 350) },
            new Colouring(new Tint(0.38, 0.04, 65)) { Pattern = new Tint(0.58, 0.06, 75), Kind = PatternKind.Bands },
        },
    };
}
