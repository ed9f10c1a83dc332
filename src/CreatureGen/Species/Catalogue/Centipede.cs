using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Centipedes.</summary>
internal static class Centipede
{
    private static readonly LegRow row = new(First: 18, Last: 51, Segment: 9.7, Front: 0.1, Rear: -0.45);

    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = InsectParts.Common with
    {
        Body = "centipede",
        Table = new BodyTable(
            2.2,
            3.0,
            (0, -14, 50, 30, 30),   // nose
            (30, -12, 92, 48, 46),  // muzzle, front
            (40, -8, 116, 60, 52),  // muzzle
            (40, -6, 126, 66, 56),  // stop
            (50, -4, 124, 66, 56),  // brow
            (50, 0, 108, 60, 52),   // cranium
            (60, 0, 94, 54, 50),    // nape
            (90, 0, 112, 60, 50),   // neck
            (110, 0, 120, 64, 52),  // neck base
            (150, 0, 124, 66, 54),  // shoulders
            (150, 0, 126, 66, 54),  // ribs
            (150, 0, 126, 66, 54),  // belly
            (150, 0, 124, 64, 54),  // loin
            (150, 0, 118, 62, 52),  // pelvis
            (110, 0, 110, 58, 50),  // tail base
            (110, 0, 100, 54, 46),  // tail, first third
            (110, 0, 84, 46, 40),   // tail, second third
            (100, 0, 30, 20, 20)),  // tail tip
        TorsoLength = (0.04, 0.16),
        Frequency = (0.12, 0, 0),
        Dominance = (0.93, 0.98),
        WalkingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.ManyLegged, 1) },
        Eye = (8.8, 6.2), EyeSize = 0.30,
        Annuli = new AnnuliBlueprint(17, 0.07),
        Legs = new LegPreset { Sites = row.Sites(12), Row = row, Reach = (0.15, 0.18), Height = (0.05, 0.08), Thickness = 0.035, KneeRise = 0.7 },
        Parts = new[]
        {
            new PartSlot(new PartChoice(1, InsectParts.Part(InsectParts.Jaw(length: 0.15, radius: 0.034, sideward: 0.1, bendUp: 0, bendSide: -0.5), 0.8, 1.2))),
            new PartSlot(new PartChoice(1, InsectParts.Part(InsectParts.Feeler(ring: 3, segment: 2.6, length: 0.75, radius: 0.011, outward: 0.42, upward: 0.55, forward: 0.75, bendUp: -0.4, bendForward: 0.2), 0.8, 1.15))),
            new PartSlot(new PartChoice(1, InsectParts.Part(new FeatureBlueprint(FeatureKind.Antenna, Ring: 52, Segment: 5, Length: 0.3, Radius: 0.012, Outward: 0.1, Upward: 0.1, Forward: -0.9, Sideward: 0.35, BendUp: 0.1, BendForward: 0, BendSide: 0.1, Flatness: 0.3, Taper: 0.6), 0.8, 1.2))),
        },
        Colourings = new[]
        {
            new Colouring(new Tint(0.40, 0.13, 35)) { Kind = PatternKind.Plain, Limb = new Tint(0.66, 0.15, 60) },
            new Colouring(new Tint(0.30, 0.06, 270)) { Kind = PatternKind.Plain, Limb = new Tint(0.7, 0.14, 80) },
            new Colouring(new Tint(0.45, 0.08, 80)) { Pattern = new Tint(0.25, 0.03, 60), Kind = PatternKind.Bands },
        },
    };
}
