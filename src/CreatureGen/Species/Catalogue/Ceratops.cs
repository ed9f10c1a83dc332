using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Horned dinosaurs with a bony shield.</summary>
internal static class Ceratops
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Reptile.Profile.Tamed() with
    {
        Body = "ceratops",
        Table = new BodyTable(
            2.2,
            2.5,
            (0, -62, 18, 22, 20),      // nose
            (45, -52, 50, 62, 52),     // muzzle, front
            (75, -40, 82, 86, 72),     // muzzle
            (85, -34, 110, 106, 88),   // stop
            (80, -28, 140, 130, 106),  // brow
            (90, -18, 160, 142, 128),  // cranium
            (90, -4, 150, 135, 140),   // nape
            (90, 8, 160, 155, 170),    // neck
            (100, 10, 185, 185, 215),  // neck base
            (140, 4, 225, 215, 265),   // shoulders
            (260, 0, 270, 235, 290),   // ribs
            (260, -2, 275, 235, 285),  // belly
            (240, -4, 240, 215, 245),  // loin
            (220, -2, 205, 190, 200),  // pelvis
            (150, 6, 140, 135, 135),   // tail base
            (260, 16, 85, 85, 82),     // tail, first third
            (280, 14, 45, 48, 46),     // tail, second third
            (220, 6, 12, 14, 14)),     // tail tip
        TorsoLength = (1.9, 3),
        Frequency = (0.16, 0, 0),
        Dominance = (0.93, 0.98),
        Kinship = 0,
        HipHeight = (0.58, 0.69), LegGirth = 0.84,
        HeadSize = (1.1, 0.6),
        WalkingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Columnar, 1) },
        Eye = (9.6, 6.0), EyeSize = 0.22, SlitPupils = 0.3,
        MouthCorner = 7, Teeth = 0, MouthOpenings = new[] { new Weighted<double>(0, 1), new Weighted<double>(0.12, 0.5) },
        HeadOrnament = (0, 0),
        Parts = new[]
        {
            new PartSlot(new PartChoice(1) { Frill = NeckPresets.Shield }),
            new PartSlot(new PartChoice(1, SaurianParts.BrowHorns), new PartChoice(0.6, SaurianParts.NoseHorn)),
        },
        Colourings = new[]
        {
            new Colouring(new Tint(0.52, 0.05, 95)) { Kind = PatternKind.Mottle, Accent = new Tint(0.58, 0.14, 40), Muzzle = new Tint(0.34, 0.03, 80) },
            new Colouring(new Tint(0.50, 0.045, 240)) { Kind = PatternKind.Bands, Accent = new Tint(0.66, 0.13, 70), Muzzle = new Tint(0.3, 0.02, 240) },
            new Colouring(new Tint(0.50, 0.07, 50)) { Kind = PatternKind.Saddle, Accent = new Tint(0.50, 0.10, 195), Muzzle = new Tint(0.3, 0.02, 60) },
        },
        Feet = Weights.Of((FootStyle.Stump, 1)),
    };
}
