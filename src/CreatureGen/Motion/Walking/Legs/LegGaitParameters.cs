using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>How a leg of some build steps: data, angles in radians, lengths in leg lengths.</summary>
internal sealed class LegGaitParameters
{
    private static readonly CurveTable hockFold = CurveTable.Bell(0.42, 1.6);

    /// <summary>A carpus folds later and over more of the swing than a hock: it turns fastest of all joints.</summary>
    private static readonly CurveTable carpusFold = CurveTable.Bell(0.46, 1.4);

    private static readonly LegGaitParameters[] all = Array.ConvertAll(LegKinds.All.ToArray(), kind => new LegGaitParameters(kind));

    private readonly LegStep step;

    private LegGaitParameters(LegKind kind)
    {
        step = kind.Step;
        Kind = kind;
        Lift = (float)step.Lift;
        LiftCurve = CurveTable.Bell(step.Peak, 1.6);
        Fold = (float)Scalar.Radians(step.FoldDegrees);
        Unfold = (float)Scalar.Radians(step.UnfoldDegrees);
        ToeOff = (float)Scalar.Radians(step.ToeOffDegrees);
        SwingPitch = (float)Scalar.Radians(step.SwingPitchDegrees);
        Strike = (float)Scalar.Radians(step.StrikeDegrees);
        Linkage = step.Linkage;
        FoldCurve = step.Bend < 0 ? carpusFold : hockFold;
    }

    /// <summary>Share of the swing in which the knee must not come straight yet.</summary>
    public static CurveTable SlackCurve { get; } = CurveTable.Bell(0.72, 4);

    /// <summary>Course of the folding of a leg that is tucked in the air.</summary>
    public static CurveTable TuckCurve { get; } = CurveTable.Bell(0.45, 1.5);

    /// <summary>Course of the stretching of a leg that trails behind in the air: it has left the ground stretched, and is drawn in before it comes down.</summary>
    public static CurveTable TrailCurve { get; } = CurveTable.Bell(0.30, 1.5);

    /// <summary>All that is known of the build.</summary>
    public LegKind Kind { get; }

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

    /// <inheritdoc cref="LegRig.FlatFoot"/>
    public bool FlatFoot => Linkage == LegLinkage.Foot && Kind.Outline.End == FootEnd.Toes;

    /// <summary>How far the leg is drawn in towards the middle at most, part of the height of its hip: as far as its foot gives way to a side.</summary>
    public float MaxAdduction => step.MaxAdduction;

    /// <summary>How far the heel of a hind foot rises that rests on its tip while the body stands, radians: 38° of horses, cattle and deer, half as much of dogs and cats; none of those that stand on their soles.</summary>
    public float RestPitch => step.RestPitch;

    /// <summary>Side to which the knee bends about the left axis: 1 knee, −1 elbow, 0 as it is built (legs out to the side).</summary>
    public int Bend => step.Bend;

    /// <summary>The traits of a build.</summary>
    public static LegGaitParameters Of(LimbArchetype archetype) => all[(int)LegKinds.Of(archetype).Archetype];
}
