using System;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>How the three bones of a leg share the work.</summary>
internal enum LegLinkage
{
    /// <summary>Thigh and metatarsus turn together.</summary>
    Pantograph,

    /// <summary>The foot has its own angle to the ground; thigh and shank reach for the ankle.</summary>
    Foot,
}

/// <summary>How a leg of some build steps: data, angles in radians, lengths in leg lengths.</summary>
internal sealed class LegGaitParameters
{
    private static readonly CurveTable hockFold = CurveTable.Bell(0.42, 1.6);

    /// <summary>A carpus folds later and over more of the swing than a hock: it turns fastest of all joints.</summary>
    private static readonly CurveTable carpusFold = CurveTable.Bell(0.46, 1.4);

    private static readonly LegGaitParameters[] all =
    {
        new(LimbArchetype.DigitigradeHind, 0.13, 0.40, 40, -12, 50, 70, -6, LegLinkage.Pantograph, 1),
        new(LimbArchetype.DigitigradeFore, 0.14, 0.46, 48, 0, 45, 80, -6, LegLinkage.Pantograph, -1),
        new(LimbArchetype.UnguligradeHind, 0.075, 0.40, 42, -14, 55, 70, -4, LegLinkage.Pantograph, 1),
        new(LimbArchetype.UnguligradeFore, 0.10, 0.46, 54, 0, 52, 92, -4, LegLinkage.Pantograph, -1),
        new(LimbArchetype.PlantigradeHind, 0.085, 0.38, 0, 0, 46, 52, -14, LegLinkage.Foot, 1),
        new(LimbArchetype.PlantigradeFore, 0.12, 0.45, 0, 0, 48, 68, -8, LegLinkage.Foot, -1),
        new(LimbArchetype.Column, 0.07, 0.42, 0, 0, 22, 32, -3, LegLinkage.Foot, 1),
        new(LimbArchetype.Sprawl, 0.14, 0.45, 0, 0, 30, 36, -3, LegLinkage.Foot, 0),
        new(LimbArchetype.Theropod, 0.14, 0.38, 48, -16, 55, 85, -8, LegLinkage.Pantograph, 1),
        new(LimbArchetype.Insect, 0.16, 0.5, 0, 0, 10, 14, 0, LegLinkage.Foot, 0),
        new(LimbArchetype.Arm, 0.12, 0.45, 0, 0, 40, 50, -8, LegLinkage.Foot, -1),
        new(LimbArchetype.Bird, 0.16, 0.38, 52, -16, 55, 85, -8, LegLinkage.Pantograph, 1),
        new(LimbArchetype.Raptorial, 0.12, 0.45, 0, 0, 10, 14, 0, LegLinkage.Foot, -1),
        new(LimbArchetype.Jumper, 0.14, 0.5, 0, 0, 10, 14, 0, LegLinkage.Foot, -1),
        new(LimbArchetype.FrogHind, 0.14, 0.42, 0, 0, 30, 36, -8, LegLinkage.Foot, 1),
        new(LimbArchetype.FrogFore, 0.14, 0.45, 0, 0, 30, 36, -8, LegLinkage.Foot, -1),
    };

    private LegGaitParameters(LimbArchetype archetype, double lift, double peak, double fold, double unfold, double off, double swing, double strike, LegLinkage linkage, int bend)
    {
        Archetype = archetype;
        Lift = (float)lift;
        LiftCurve = CurveTable.Bell(peak, 1.6);
        Fold = (float)Scalar.Radians(fold);
        Unfold = (float)Scalar.Radians(unfold);
        ToeOff = (float)Scalar.Radians(off);
        SwingPitch = (float)Scalar.Radians(swing);
        Strike = (float)Scalar.Radians(strike);
        Linkage = linkage;
        Bend = bend;
        FoldCurve = bend < 0 ? carpusFold : hockFold;
    }

    /// <summary>Share of the swing in which the knee must not come straight yet.</summary>
    public static CurveTable SlackCurve { get; } = CurveTable.Bell(0.72, 4);

    /// <summary>Course of the folding of a leg that is tucked in the air.</summary>
    public static CurveTable TuckCurve { get; } = CurveTable.Bell(0.45, 1.5);

    /// <summary>Course of the stretching of a leg that trails behind in the air: it has left the ground stretched, and is drawn in before it comes down.</summary>
    public static CurveTable TrailCurve { get; } = CurveTable.Bell(0.30, 1.5);

    /// <summary>The build.</summary>
    public LimbArchetype Archetype { get; }

    /// <summary>Height of the ball in the swing.</summary>
    public float Lift { get; }

    /// <summary>Course of the height over the swing.</summary>
    public CurveTable LiftCurve { get; }

    /// <summary>How far the metatarsus folds back early in the swing.</summary>
    public float Fold { get; }

    /// <summary>Course of that fold over the swing.</summary>
    public CurveTable FoldCurve { get; }

    /// <summary>How far it reaches ahead late in the swing (negative).</summary>
    public float Unfold { get; }

    /// <summary>Pitch of the foot, toes down, as it leaves the ground.</summary>
    public float ToeOff { get; }

    /// <summary>Greatest pitch in the swing.</summary>
    public float SwingPitch { get; }

    /// <summary>Pitch as it comes down; negative is heel first.</summary>
    public float Strike { get; }

    /// <summary>How the bones share the work.</summary>
    public LegLinkage Linkage { get; }

    /// <summary>How far the leg is drawn in towards the middle at most, part of the height of its hip: as far as its foot gives way to a side.</summary>
    public float MaxAdduction => Archetype == LimbArchetype.Column ? 0.03f : Archetype == LimbArchetype.PlantigradeFore ? 0.10f : 0.13f;

    /// <summary>How far the heel of a hind foot rises that rests on its tip while the body stands, radians: 38° of horses, cattle and deer, half as much of dogs and cats; none of those that stand on their soles.</summary>
    public float RestPitch => Archetype == LimbArchetype.UnguligradeHind ? 0.66f : Archetype == LimbArchetype.DigitigradeHind ? 0.33f : 0f;

    /// <summary>Side to which the knee bends about the left axis: 1 knee, −1 elbow, 0 as it is built (legs out to the side).</summary>
    public int Bend { get; }

    /// <summary>The traits of a build.</summary>
    public static LegGaitParameters Of(LimbArchetype archetype) => Array.Find(all, t => t.Archetype == archetype) ?? throw new ArgumentOutOfRangeException(nameof(archetype), archetype, "there are no traits for this archetype");
}
