using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Dragonflies.</summary>
internal static class Dragonfly
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = InsectParts.Common with
    {
        Body = "dragonfly",
        Table = new BodyTable(
            2.0,
            2.1,
            (0, -40, 50, 45, 45),      // nose
            (30, -40, 95, 80, 80),     // muzzle, front
            (40, -38, 125, 100, 98),   // muzzle
            (45, -32, 145, 116, 108),  // stop
            (50, -24, 155, 120, 108),  // brow
            (50, -10, 140, 110, 100),  // cranium
            (40, 0, 60, 60, 60),       // nape
            (30, 6, 66, 66, 64),       // neck
            (60, 8, 120, 125, 115),    // neck base
            (110, 4, 150, 160, 140),   // shoulders
            (110, -2, 140, 150, 130),  // ribs
            (100, -3, 90, 95, 90),     // belly
            (120, -2, 56, 58, 58),     // loin
            (240, 0, 50, 52, 52),      // pelvis
            (260, 1, 46, 46, 46),      // tail base
            (260, 1, 44, 42, 42),      // tail, first third
            (240, 0, 48, 40, 40),      // tail, second third
            (100, 0, 14, 10, 10)),     // tail tip
        TorsoLength = (0.03, 0.06),
        Annuli = new AnnuliBlueprint(41, 0.05),
        Frequency = (0, 0.36, 0),
        Eye = (9.6, 5.4), EyeSize = 0.80, EyeSink = 0.55,
        Legs = new LegPreset
        {
            Sites = new[]
            {
                new LegSite(LimbArchetype.Insect) { Ring = 23, Segment = 9.7, Azimuth = 0.55 },
                new LegSite(LimbArchetype.Insect) { Ring = 26, Segment = 9.7, Azimuth = 0.1 },
                new LegSite(LimbArchetype.Insect) { Ring = 29, Segment = 9.7, Azimuth = -0.4 },
            },
            Reach = (0.20, 0.26), Height = (0.16, 0.22), Thickness = 0.028,
        },
        Wings = new ThinWings { Spread = new[]
            {
                new ThinWing(ring: 25, length: 1.1, width: 0.24, azimuth: 12, elevation: 14, style: ThinWingStyle.DragonflyFore),
                new ThinWing(ring: 29, length: 1.02, width: 0.32, azimuth: -16, elevation: 10, style: ThinWingStyle.DragonflyHind),
            } },
        Parts = new[] { InsectParts.SmallJaws(), new PartSlot(new PartChoice(1, InsectParts.Part(InsectParts.Feeler(ring: 6, segment: 2.6, length: 0.13, radius: 0.009, outward: 0.4, upward: 0.6, forward: 0.6, bendUp: 0, bendForward: 0), 0.9, 1.1))) },
        Colourings = new[]
        {
            new Colouring(new Tint(0.60, 0.13, 232)) { Pattern = new Tint(0.22, 0.03, 250), Kind = PatternKind.Bands },
            new Colouring(new Tint(0.62, 0.15, 150)) { Pattern = new Tint(0.24, 0.04, 150), Kind = PatternKind.Bands },
            new Colouring(new Tint(0.40, 0.04, 60)) { Pattern = new Tint(0.80, 0.15, 95), Kind = PatternKind.Bands },
            new Colouring(new Tint(0.46, 0.13, 300)) { Kind = PatternKind.Plain },
            new Colouring(new Tint(0.55, 0.19, 28)) { Kind = PatternKind.Plain },
        },
    };
}
