using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Grasshoppers.</summary>
internal static class Hopper
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = InsectParts.Common with
    {
        Body = "hopper",
        Table = new BodyTable(
            2.0,
            2.2,
            (0, -70, 40, 35, 35),      // nose
            (35, -70, 70, 60, 60),     // muzzle, front
            (45, -66, 90, 78, 78),     // muzzle
            (50, -56, 104, 98, 92),    // stop
            (50, -40, 112, 116, 100),  // brow
            (55, -18, 108, 112, 100),  // cranium
            (50, 0, 98, 104, 100),     // nape
            (50, 4, 104, 112, 108),    // neck
            (80, 4, 122, 132, 130),    // neck base
            (110, 0, 130, 134, 138),   // shoulders
            (120, -4, 126, 122, 132),  // ribs
            (130, -5, 118, 112, 124),  // belly
            (170, -4, 108, 104, 114),  // loin
            (200, -2, 96, 96, 102),    // pelvis
            (200, 0, 82, 84, 88),      // tail base
            (180, 2, 66, 68, 70),      // tail, first third
            (160, 4, 46, 46, 50),      // tail, second third
            (100, 6, 12, 12, 12)),     // tail tip
        TorsoLength = (0.02, 0.045),
        Frequency = (0.13, 0, 0),
        Eye = (9.6, 6.0), EyeSize = 0.50,
        Waist = 0.78, Annuli = new AnnuliBlueprint(36, 0.05),
        Legs = new LegPreset
        {
            Sites = new[]
            {
                new LegSite(LimbArchetype.Insect) { Ring = 22, Segment = 9.7, Azimuth = 0.5 },
                new LegSite(LimbArchetype.Insect) { Ring = 26, Segment = 9.7, Azimuth = -0.05 },
                new LegSite(LimbArchetype.Jumper) { Ring = 32, Segment = 9.0, Reach = 1.68, Thickness = 1.7 },
            },
            Reach = (0.22, 0.28), Height = (0.20, 0.28), Thickness = 0.03,
        },
        Wings = new ThinWings { Spread = new[] { new ThinWing(ring: 28, length: 1.05, width: 0.26, azimuth: -2, elevation: 34) }, Folded = new[] { new ThinWing(ring: 28, length: 0.95, width: 0.24, azimuth: -77, elevation: 5) } },
        Parts = new[] { InsectParts.SmallJaws(), InsectParts.Long(0.6) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.68, 0.15, 125)) { Kind = PatternKind.Plain },
            new Colouring(new Tint(0.58, 0.08, 75)) { Kind = PatternKind.Mottle },
            new Colouring(new Tint(0.66, 0.14, 100)) { Pattern = new Tint(0.3, 0.05, 60), Kind = PatternKind.Bands },
            new Colouring(new Tint(0.36, 0.03, 60)) { Pattern = new Tint(0.64, 0.17, 60), Kind = PatternKind.Bands, Limb = new Tint(0.58, 0.17, 32) },
        },
    };
}
