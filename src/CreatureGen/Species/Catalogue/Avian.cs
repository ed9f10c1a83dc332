using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Birds. A family: species start from it.</summary>
internal static class Avian
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = new SpeciesProfile("avian")
    {
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -14, 14, 14, 12),      // nose
            (50, -14, 32, 34, 26),     // muzzle, front
            (70, -12, 46, 50, 40),     // muzzle
            (60, -12, 72, 76, 55),     // stop
            (60, -14, 92, 108, 75),    // brow
            (70, -8, 96, 110, 85),     // cranium
            (80, 20, 80, 85, 85),      // nape
            (160, 68, 74, 78, 80),     // neck
            (160, 64, 95, 100, 120),   // neck base
            (140, 42, 150, 150, 190),  // shoulders
            (220, 18, 200, 180, 230),  // ribs
            (220, 8, 200, 180, 210),   // belly
            (200, 3, 170, 165, 170),   // loin
            (180, 0, 130, 140, 130),   // pelvis
            (140, -3, 85, 88, 80),     // tail base
            (200, -5, 60, 55, 50),     // tail, first third
            (220, -5, 45, 36, 30),     // tail, second third
            (160, -5, 20, 16, 14)),    // tail tip
        Class = AnimalClass.Bird, Cover = SkinCover.Feathers, CoverSize = 0.04f, Snout = SnoutKind.Beak, Beaks = Weights.Of((BeakStyle.Conical, 1.0), (BeakStyle.Hooked, 0.4), (BeakStyle.Probe, 0.6)),
        Motion = new MotionTraits { StandingPitch = 24, BobsHead = true },
        Skull = new SkullShape { Chin = 0 }, BipedHipHeight = (0.95, 1.4),
        Crest = 0.45, BackRow = 0, FlierLegPairs = Weights.Of((1, 1)),
        TorsoLength = (0.13, 0.26),
        Frequency = (0.2, 0.25, 0),
        Partners = new[] { "reptile", "feline", "canine", "fish" },
        WalkingPlans = Weights.Of((BodyPlan.Theropod, 1)),
        SwimmingPlans = Weights.Of((BodyPlan.Flipper, 1)),
        Eye = (9.6, 6.6), EyeSize = 0.4125, EyeSink = 0.60, EyeForward = 0.35, LidDegrees = (60, 72), Bone = 0.5,
        Swelling = (0.06, 0.04), TongueTints = Weights.Of((new Tint(0.62, 0.10, 20), 1), (new Tint(0.30, 0.04, 20), 0.4)), MouthCorner = 7, Nostril = 0.12,
        HeadOrnament = (0.02, 0.12), WingMembrane = 0.12,
        Patterns = Weights.Of((PatternKind.Saddle, 1), (PatternKind.Plain, 0.6), (PatternKind.Mottle, 0.7), (PatternKind.Bands, 0.4), (PatternKind.Spots, 0.4)),
    };
}
