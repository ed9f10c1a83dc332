using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Wasps.</summary>
internal static class Wasp
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = InsectParts.Common with
    {
        Body = "wasp",
        Table = new BodyTable(
            2.0,
            2.1,
            (0, -66, 40, 35, 35),      // nose
            (30, -66, 80, 62, 62),     // muzzle, front
            (40, -62, 112, 84, 84),    // muzzle
            (40, -52, 132, 100, 95),   // stop
            (45, -42, 142, 112, 100),  // brow
            (50, -22, 132, 105, 95),   // cranium
            (50, 0, 75, 70, 65),       // nape
            (40, 8, 60, 60, 60),       // neck
            (60, 10, 122, 125, 112),   // neck base
            (100, 6, 168, 168, 155),   // shoulders
            (120, 0, 168, 166, 155),   // ribs
            (100, -6, 100, 100, 100),  // belly
            (90, -4, 24, 24, 24),      // loin
            (120, 8, 115, 110, 110),   // pelvis
            (120, 12, 158, 152, 152),  // tail base
            (160, 16, 148, 142, 142),  // tail, first third
            (180, 20, 86, 82, 82),     // tail, second third
            (160, 26, 9, 9, 9)),       // tail tip
        TorsoLength = (0.012, 0.024),
        Frequency = (0.13, 0.24, 0),
        Variety = 0.6, LatticeSpread = 0.2,
        Signatures = new[] { Signature.None, Signature.BigHead, Signature.BigEyes, Signature.BigTail },
        Eye = (8.6, 7.0), EyeSize = 0.70, EyeSink = 0.55,
        Waist = 0.17, Annuli = new AnnuliBlueprint(41, 0.08),
        Legs = new LegPreset
        {
            Sites = InsectParts.Sixth(0.45, -0.05, -0.6),
            Reach = (0.26, 0.34), Height = (0.20, 0.30), Thickness = 0.036,
        },
        Wings = new ThinWings
        {
            Spread = new[] { new ThinWing(ring: 26, length: 1.0, width: 0.26, azimuth: -6, elevation: 36), new ThinWing(ring: 30, length: 0.72, width: 0.21, azimuth: -36, elevation: 26) },
            Folded = new[] { new ThinWing(ring: 27, length: 0.74, width: 0.25, azimuth: -72, elevation: 7) },
        },
        Parts = new[] { InsectParts.SmallJaws(), InsectParts.Elbowed() },
        Colourings = new[]
        {
            new Colouring(new Tint(0.78, 0.15, 88)) { Pattern = new Tint(0.20, 0.02, 60), Kind = PatternKind.Bands, Scale = 1.5, Limb = new Tint(0.30, 0.05, 60) },
            new Colouring(new Tint(0.62, 0.16, 50)) { Pattern = new Tint(0.2, 0.02, 60), Kind = PatternKind.Bands, Scale = 1.4 },
            new Colouring(new Tint(0.22, 0.02, 270)) { Pattern = new Tint(0.92, 0.02, 90), Kind = PatternKind.Bands, Scale = 0.8, Limb = new Tint(0.2, 0.02, 270) },
            new Colouring(new Tint(0.46, 0.11, 200)) { Kind = PatternKind.Plain, Limb = new Tint(0.34, 0.10, 300), Accent = new Tint(0.46, 0.14, 320) },
            new Colouring(new Tint(0.24, 0.02, 40)) { Pattern = new Tint(0.50, 0.17, 30), Kind = PatternKind.Saddle, Limb = new Tint(0.5, 0.16, 32) },
        },
    };
}
