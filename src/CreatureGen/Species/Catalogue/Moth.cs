using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Moths.</summary>
internal static class Moth
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = InsectParts.Common with
    {
        Body = "moth",
        Table = new BodyTable(
            2.0,
            2.0,
            (0, -50, 34, 32, 32),     // nose
            (22, -50, 68, 60, 60),    // muzzle, front
            (32, -46, 90, 78, 78),    // muzzle
            (34, -38, 106, 94, 90),   // stop
            (40, -28, 112, 104, 92),  // brow
            (44, -12, 104, 98, 90),   // cranium
            (40, 0, 80, 80, 76),      // nape
            (36, 2, 92, 94, 90),      // neck
            (60, 2, 140, 146, 136),   // neck base
            (90, 0, 168, 172, 160),   // shoulders
            (90, 0, 160, 162, 152),   // ribs
            (70, 0, 124, 122, 118),   // belly
            (80, 4, 116, 112, 110),   // loin
            (110, 6, 132, 126, 124),  // pelvis
            (110, 8, 124, 118, 116),  // tail base
            (110, 8, 98, 92, 92),     // tail, first third
            (100, 8, 62, 60, 60),     // tail, second third
            (70, 8, 12, 12, 12)),     // tail tip
        Cover = SkinCover.Fur, CoverSize = 0.022f,
        Annuli = new AnnuliBlueprint(41, 0.05),
        TorsoLength = (0.015, 0.04),
        Frequency = (0, 0.26, 0),
        Eye = (8.8, 6.6), EyeSize = 0.58, EyeSink = 0.55,
        Legs = new LegPreset { Sites = InsectParts.Sixth(0.45, -0.05, -0.6), Reach = (0.2, 0.24), Height = (0.14, 0.2), Thickness = 0.036 },
        Wings = new ThinWings { Spread = new[]
            {
                new ThinWing(ring: 26, length: 1.0, width: 0.56, azimuth: -14, elevation: 25, style: ThinWingStyle.MothFore),
                new ThinWing(ring: 30, length: 0.84, width: 0.56, azimuth: -16, elevation: 18, style: ThinWingStyle.MothHind),
            } },
        Parts = new[] { new PartSlot(new PartChoice(1, InsectParts.Part(InsectParts.Feeler(ring: 6, segment: 2.6, length: 0.3, radius: 0.017, outward: 0.7, upward: 1.05, forward: 0.3, bendUp: 0.15, bendForward: 0.3, knob: 0.2), 0.85, 1.15))) },
        Patterns = Weights.Of((PatternKind.Mottle, 1), (PatternKind.Bands, 0.6), (PatternKind.Spots, 0.6)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.62, 0.05, 70)) { Pattern = new Tint(0.4, 0.05, 55), Kind = PatternKind.Mottle, Accent = new Tint(0.52, 0.08, 60) },
            new Colouring(new Tint(0.84, 0.06, 140)) { Kind = PatternKind.Plain, Accent = new Tint(0.78, 0.10, 140) },
            new Colouring(new Tint(0.34, 0.03, 60)) { Pattern = new Tint(0.72, 0.14, 70), Kind = PatternKind.Bands, Accent = new Tint(0.60, 0.15, 40) },
            new Colouring(new Tint(0.88, 0.02, 90)) { Pattern = new Tint(0.3, 0.02, 60), Kind = PatternKind.Spots, Accent = new Tint(0.85, 0.03, 95) },
        },
    };
}
