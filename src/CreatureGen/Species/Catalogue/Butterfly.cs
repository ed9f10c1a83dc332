using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Butterflies.</summary>
internal static class Butterfly
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = InsectParts.Common with
    {
        Body = "butterfly",
        Table = new BodyTable(
            2.0,
            2.0,
            (0, -44, 30, 30, 30),    // nose
            (20, -44, 60, 54, 54),   // muzzle, front
            (30, -42, 80, 70, 70),   // muzzle
            (30, -35, 92, 82, 80),   // stop
            (40, -25, 94, 88, 80),   // brow
            (40, -10, 82, 80, 75),   // cranium
            (40, 0, 52, 56, 56),     // nape
            (30, 0, 58, 62, 62),     // neck
            (50, 0, 88, 94, 92),     // neck base
            (80, 0, 104, 110, 106),  // shoulders
            (80, 0, 102, 106, 100),  // ribs
            (70, 0, 80, 80, 80),     // belly
            (80, 4, 76, 76, 76),     // loin
            (120, 8, 86, 86, 86),    // pelvis
            (120, 10, 82, 82, 82),   // tail base
            (120, 10, 66, 66, 66),   // tail, first third
            (120, 10, 44, 44, 44),   // tail, second third
            (80, 8, 10, 10, 10)),    // tail tip
        TorsoLength = (0.014, 0.03),
        Frequency = (0, 0.42, 0),
        Eye = (8.8, 7.0), EyeSize = 0.74, EyeSink = 0.55,
        Annuli = new AnnuliBlueprint(41, 0.05),
        Legs = new LegPreset { Sites = InsectParts.Sixth(0.45, -0.05, -0.6), Reach = (0.18, 0.22), Height = (0.16, 0.22), Thickness = 0.024 },
        Wings = new ThinWings { Spread = new[]
            {
                new ThinWing(ring: 26, length: 0.98, width: 0.6, azimuth: -16, elevation: 39, style: ThinWingStyle.ButterflyFore),
                new ThinWing(ring: 30, length: 0.84, width: 0.68, azimuth: -1, elevation: 38, style: ThinWingStyle.ButterflyHind),
            } },
        Parts = new[] { InsectParts.SmallJaws(), new PartSlot(new PartChoice(1, InsectParts.Part(InsectParts.Feeler(ring: 6, segment: 2.6, length: 0.4, radius: 0.012, outward: 0.5, upward: 1, forward: 0.45, bendUp: -0.35, bendForward: 0.35, knob: 1.1), 0.9, 1.1))) },
        Colourings = new[] { new Colouring(new Tint(0.30, 0.03, 60)) { Kind = PatternKind.Plain, KeepsAccent = true }, new Colouring(new Tint(0.22, 0.02, 270)) { Kind = PatternKind.Plain, KeepsAccent = true } },
    };
}
