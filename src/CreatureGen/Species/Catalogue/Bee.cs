using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Bees.</summary>
internal static class Bee
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = InsectParts.Common with
    {
        Body = "bee",
        Table = new BodyTable(
            2.0,
            2.1,
            (0, -62, 40, 35, 35),      // nose
            (28, -62, 78, 62, 62),     // muzzle, front
            (36, -58, 104, 84, 84),    // muzzle
            (38, -50, 122, 96, 92),    // stop
            (42, -40, 130, 106, 98),   // brow
            (48, -20, 122, 98, 92),    // cranium
            (46, 0, 84, 80, 74),       // nape
            (36, 8, 88, 90, 86),       // neck
            (60, 10, 160, 165, 150),   // neck base
            (100, 6, 205, 208, 190),   // shoulders
            (110, 0, 205, 200, 188),   // ribs
            (80, -6, 140, 134, 136),   // belly
            (70, -4, 92, 88, 92),      // loin
            (110, 6, 185, 172, 176),   // pelvis
            (120, 12, 222, 206, 208),  // tail base
            (140, 18, 205, 188, 190),  // tail, first third
            (130, 24, 132, 122, 124),  // tail, second third
            (90, 30, 10, 10, 10)),     // tail tip
        Cover = SkinCover.Fur, CoverSize = 0.022f,
        Waist = 0.26,
        TorsoLength = (0.01, 0.02),
        Frequency = (0, 0.24, 0),
        Eye = (8.8, 6.6), EyeSize = 0.50, EyeSink = 0.55,
        Legs = new LegPreset { Sites = InsectParts.Sixth(0.45, -0.05, -0.6), Reach = (0.22, 0.28), Height = (0.14, 0.2), Thickness = 0.04 },
        Wings = new ThinWings { Spread = new[] { new ThinWing(ring: 26, length: 0.8, width: 0.26, azimuth: -4, elevation: 34), new ThinWing(ring: 30, length: 0.56, width: 0.2, azimuth: -36, elevation: 26) } },
        Parts = new[] { InsectParts.SmallJaws(), new PartSlot(new PartChoice(1, InsectParts.Part(InsectParts.Feeler(ring: 6, segment: 2.6, length: 0.24, radius: 0.014, outward: 0.35, upward: 1.05, forward: 0.35, bendUp: -0.6, bendForward: 0.6), 0.85, 1.1))) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.74, 0.15, 82)) { Pattern = new Tint(0.18, 0.02, 60), Kind = PatternKind.Bands, Scale = 0.9, Limb = new Tint(0.2, 0.02, 60) },
            new Colouring(new Tint(0.22, 0.02, 60)) { Pattern = new Tint(0.62, 0.15, 50), Kind = PatternKind.Bands, Scale = 0.7, Limb = new Tint(0.2, 0.02, 60) },
            new Colouring(new Tint(0.52, 0.10, 55)) { Pattern = new Tint(0.86, 0.05, 90), Kind = PatternKind.Bands, Scale = 1.1, Limb = new Tint(0.25, 0.03, 50) },
            new Colouring(new Tint(0.68, 0.01, 250)) { Pattern = new Tint(0.2, 0.01, 260), Kind = PatternKind.Bands, Scale = 0.8, Limb = new Tint(0.22, 0.01, 260) },
            new Colouring(new Tint(0.30, 0.09, 275)) { Kind = PatternKind.Plain, Limb = new Tint(0.2, 0.02, 270), Accent = new Tint(0.42, 0.13, 290) },
            new Colouring(new Tint(0.60, 0.16, 60)) { Pattern = new Tint(0.24, 0.03, 50), Kind = PatternKind.Saddle, Limb = new Tint(0.22, 0.02, 60) },
        },
    };
}
