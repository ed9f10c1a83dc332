using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Species.Catalogue;

/// <summary>Bats.</summary>
internal static class Bat
{
    /// <summary>All that is known of it.</summary>
    public static readonly SpeciesProfile Profile = Canine.Profile.Tamed() with
    {
        Body = "bat",
        Table = new BodyTable(
            2.1,
            2.2,
            (0, -8, 36, 36, 32),       // nose
            (16, -8, 54, 50, 46),      // muzzle, front
            (24, -12, 68, 58, 54),     // muzzle
            (28, -26, 96, 86, 74),     // stop
            (36, -34, 128, 126, 90),   // brow
            (65, -14, 134, 130, 98),   // cranium
            (70, 14, 108, 108, 100),   // nape
            (65, 38, 112, 112, 116),   // neck
            (80, 36, 138, 138, 150),   // neck base
            (110, 20, 172, 172, 196),  // shoulders
            (170, 8, 180, 168, 196),   // ribs
            (170, 4, 166, 148, 176),   // belly
            (150, 2, 136, 126, 146),   // loin
            (130, 2, 100, 100, 112),   // pelvis
            (60, 10, 48, 50, 50),      // tail base
            (50, 10, 30, 30, 30),      // tail, first third
            (50, 10, 22, 22, 22),      // tail, second third
            (40, 10, 10, 10, 10)),     // tail tip
        Motion = new MotionTraits { StandingPitch = 26 },
        TailHair = TailHair.Scut,
        TorsoLength = (0.04, 0.13),
        Frequency = (0, 0.42, 0),
        Dominance = (0.92, 0.97),
        Kinship = 0,
        Eye = (9.4, 5.4), EyeSize = 0.24,
        HeadOrnament = (1, 0), Ears = Weights.Of((EarShape.Big, 1), (EarShape.Pointed, 0.4)),
        FlyingPlans = new[] { new Weighted<BodyPlan>(BodyPlan.Flapping, 1) },
        WingMembrane = 1, FlierLegPairs = Weights.Of((1, 1)), LegGirth = 0.62,
        Variety = 0.25,
        Signatures = new[] { Signature.None, Signature.BigHead, Signature.BigEyes },
        Parts = System.Array.Empty<PartSlot>(),
        Patterns = new[] { new Weighted<PatternKind>(PatternKind.Plain, 1), new Weighted<PatternKind>(PatternKind.Saddle, 0.4) },
        WingStyles = Weights.Of((WingStyle.Bat, 1)),
        Colourings = new[]
        {
            new Colouring(new Tint(0.40, 0.05, 55)) { Kind = PatternKind.Plain, Accent = new Tint(0.3, 0.04, 40) },
            new Colouring(new Tint(0.54, 0.10, 52)) { Kind = PatternKind.Plain, Accent = new Tint(0.26, 0.03, 40) },
            new Colouring(new Tint(0.32, 0.015, 280)) { Kind = PatternKind.Plain, Accent = new Tint(0.42, 0.08, 20) },
            new Colouring(new Tint(0.86, 0.02, 90)) { Kind = PatternKind.Plain, Accent = new Tint(0.74, 0.11, 80) },
        },
    };
}
