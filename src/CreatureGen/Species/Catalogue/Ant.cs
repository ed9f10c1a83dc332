using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Ants.</summary>
internal static class Ant
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = InsectParts.Common with
    {
        Body = "ant",
        Table = new BodyTable(
            2.0,
            2.1,
            (0, -50, 60, 45, 45),      // nose
            (35, -50, 112, 76, 70),    // muzzle, front
            (45, -48, 148, 102, 90),   // muzzle
            (50, -44, 174, 122, 105),  // stop
            (60, -36, 190, 134, 115),  // brow
            (70, -20, 174, 126, 110),  // cranium
            (60, 0, 82, 72, 70),       // nape
            (50, 10, 52, 52, 52),      // neck
            (60, 12, 84, 90, 80),      // neck base
            (100, 8, 100, 112, 100),   // shoulders
            (120, 2, 88, 94, 90),      // ribs
            (120, -4, 66, 72, 68),     // belly
            (100, 0, 28, 28, 28),      // loin
            (80, 0, 36, 88, 34),       // pelvis
            (80, 4, 110, 108, 100),    // tail base
            (160, 8, 200, 186, 186),   // tail, first third
            (200, 14, 155, 140, 146),  // tail, second third
            (160, 20, 12, 12, 12)),    // tail tip
        TorsoLength = (0.006, 0.014),
        Frequency = (0.13, 0, 0),
        Signatures = new[] { Signature.None, Signature.BigHead, Signature.BigEyes, Signature.BigTail },
        Eye = (9.4, 7.0), EyeSize = 0.34,
        Waist = 0.2, Annuli = new AnnuliBlueprint(44, 0.08),
        Legs = new LegPreset
        {
            Sites = InsectParts.Sixth(0.6, -0.05, -0.65),
            Reach = (0.30, 0.40), Height = (0.24, 0.36), Thickness = 0.036, KneeRise = 1.2,
        },
        Parts = new[]
        {
            new PartSlot(new PartChoice(1, InsectParts.Part(InsectParts.Jaw(length: 0.17, radius: 0.034, sideward: 0.1, bendUp: 0, bendSide: -0.5), 0.8, 1.2))),
            InsectParts.Elbowed(),
        },
        Colourings = new[]
        {
            new Colouring(new Tint(0.36, 0.09, 35)),
            new Colouring(new Tint(0.26, 0.02, 40)),
            new Colouring(new Tint(0.52, 0.13, 42)) { Pattern = new Tint(0.3, 0.08, 30), Kind = PatternKind.Saddle },
        },
    };
}
