using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Beetles.</summary>
internal static class Beetle
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = InsectParts.Common with
    {
        Body = "beetle",
        Table = new BodyTable(
            2.1,
            3.0,
            (0, -30, 50, 35, 35),       // nose
            (30, -30, 85, 55, 55),      // muzzle, front
            (40, -28, 110, 75, 70),     // muzzle
            (40, -25, 122, 85, 80),     // stop
            (50, -20, 126, 90, 85),     // brow
            (50, -12, 122, 90, 85),     // cranium
            (50, -4, 128, 88, 85),      // nape
            (50, 2, 190, 120, 100),     // neck
            (70, 4, 240, 160, 120),     // neck base
            (100, 3, 250, 180, 125),    // shoulders
            (60, 2, 215, 168, 120),     // ribs
            (100, 2, 285, 205, 130),    // belly
            (160, 0, 315, 235, 130),    // loin
            (180, -2, 320, 240, 130),   // pelvis
            (160, -6, 285, 218, 120),   // tail base
            (140, -10, 225, 178, 100),  // tail, first third
            (120, -16, 135, 112, 75),   // tail, second third
            (70, -24, 30, 30, 30)),     // tail tip
        TorsoLength = (0.012, 0.05),
        Waist = 0.5, Annuli = new AnnuliBlueprint(41, 0.08),
        Frequency = (0.13, 0.2, 0),
        Eye = (8.5, 7.2), EyeSize = 0.42,
        Legs = new LegPreset
        {
            Sites = InsectParts.Sixth(0.6, -0.05, -0.6),
            Reach = (0.24, 0.30), Height = (0.13, 0.20), Thickness = 0.055, KneeRise = 0.9,
        },
        Shell = new ShellBlueprint(ShellStyle.Elytra, Ring: 34, Rows: 19, Columns: 7, Rise: 0.07),
        Wings = new ThinWings { Spread = new[] { new ThinWing(ring: 32, length: 1.15, width: 0.32, azimuth: 2, elevation: 33) } },
        Parts = new[]
        {
            new PartSlot(
                new PartChoice(1, InsectParts.Part(InsectParts.Jaw(length: 0.34, radius: 0.038, sideward: 0.30, bendUp: 0.25, bendSide: -0.30), 0.8, 1.2)),
                new PartChoice(1, InsectParts.Part(InsectParts.NoseHorn(0.36), 0.85, 1.2), InsectParts.Part(InsectParts.Jaw(length: 0.1, radius: 0.026, sideward: 0.05, bendUp: -0.1, bendSide: -0.4), 0.8, 1.2)),
                new PartChoice(1, InsectParts.Part(InsectParts.Jaw(length: 0.07, radius: 0.022, sideward: 0, bendUp: -0.1, bendSide: -0.4), 0.8, 1.2))),
            new PartSlot(new PartChoice(1, InsectParts.Part(InsectParts.Feeler(ring: 6, segment: 2.6, length: 0.3, radius: 0.012, outward: 0.7, upward: 0.5, forward: 0.7, bendUp: 0.25, bendForward: 0, knob: 1.5), 0.85, 1.1))),
        },
        Colourings = new[]
        {
            new Colouring(new Tint(0.55, 0.19, 28)) { Pattern = new Tint(0.16, 0.02, 30), Kind = PatternKind.Spots, Limb = new Tint(0.2, 0.02, 30), Accent = new Tint(0.55, 0.2, 28) },
            new Colouring(new Tint(0.34, 0.07, 150)) { Kind = PatternKind.Plain, Accent = new Tint(0.55, 0.13, 150) },
            new Colouring(new Tint(0.27, 0.05, 270)) { Kind = PatternKind.Plain, Accent = new Tint(0.42, 0.10, 265) },
            new Colouring(new Tint(0.40, 0.08, 55)) { Kind = PatternKind.Plain, Accent = new Tint(0.5, 0.1, 55) },
            new Colouring(new Tint(0.60, 0.14, 80)) { Pattern = new Tint(0.2, 0.03, 60), Kind = PatternKind.Stripes, Limb = new Tint(0.25, 0.03, 60) },
        },
    };
}
