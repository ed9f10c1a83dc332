using System;
using System.Collections.Generic;

namespace CreatureGen.Console.Working;

/// <summary>Which of two figures is the worse.</summary>
internal enum WorseFigure
{
    /// <summary>The greater.</summary>
    Greater,

    /// <summary>The smaller.</summary>
    Smaller,
}

/// <summary>A figure that every run has, or has not where it does not apply.</summary>
/// <param name="Name">In JSON. These names are a contract.</param>
/// <param name="Worse">Which of two is the worse.</param>
/// <param name="Value">Of a run; null where it does not apply.</param>
internal sealed record MotionMeasure(string Name, WorseFigure Worse, Func<MeasuredRun, float?> Value)
{
    private const float DegreesPerRadian = 57.29578f;

    public static readonly MotionMeasure Slip = Of("slipMaxLegLengths", WorseFigure.Greater, run => run.Report.Slip);
    public static readonly MotionMeasure Penetration = Of("penetrationMaxLegLengths", WorseFigure.Greater, run => run.Report.Penetration);
    public static readonly MotionMeasure Clearance = Of("clearanceMinLegLengths", WorseFigure.Smaller, run => run.Report.Clearance);
    public static readonly MotionMeasure LimitViolations = Of("limitViolations", WorseFigure.Greater, run => run.Report.LimitViolations);
    public static readonly MotionMeasure LimitExcess = Of("limitExcessMaxDegrees", WorseFigure.Greater, run => run.Report.LimitExcess * DegreesPerRadian);
    public static readonly MotionMeasure Residual = Of("reachResidualMaxLegLengths", WorseFigure.Greater, run => run.Report.StanceResidual);
    public static readonly MotionMeasure SwingResidual = Of("swingResidualMaxLegLengths", WorseFigure.Greater, run => run.Report.SwingResidual);
    public static readonly MotionMeasure PoseJump = Of("poseJumpMax", WorseFigure.Greater, run => run.Report.PoseJump);
    public static readonly MotionMeasure LegOverlap = Of("legOverlapMaxLegLengths", WorseFigure.Greater, run => run.Report.LegOverlap);
    public static readonly MotionMeasure BellyOverlap = Of("bellyOverlapMaxLegLengths", WorseFigure.Greater, run => run.Report.BellyOverlap);
    public static readonly MotionMeasure Support = Of("supportMin", WorseFigure.Smaller, run => run.Report.LeastSupport);

    /// <summary>All, in the order of the JSON.</summary>
    public static IReadOnlyList<MotionMeasure> All { get; } =
    [
        Metres("slipMaxMetres", Slip),
        Metres("penetrationMaxMetres", Penetration),
        Metres("clearanceMinMetres", Clearance),
        LimitViolations,
        Metres("reachResidualMaxMetres", Residual),
        PoseJump,
        Support,
        Slip,
        Penetration,
        Clearance,
        Residual,
        LimitExcess,
        Metres("swingResidualMaxMetres", SwingResidual),
        SwingResidual,
        Metres("penetrationMeanMetres", Of("", WorseFigure.Greater, run => run.Report.MeanPenetration)),
        Metres("floatMaxMetres", Of("", WorseFigure.Greater, run => run.Report.Float)),
        Metres("lockDriftMaxMetres", Of("", WorseFigure.Greater, run => run.Report.LockDrift)),
        Of("skatingShare", WorseFigure.Greater, run => run.Report.SkatingShare),
        Of("stretchedShare", WorseFigure.Greater, run => run.Report.StretchedShare),
        Of("supportMean", WorseFigure.Smaller, run => run.Report.MeanSupport),
        Metres("bobMetres", Of("", WorseFigure.Greater, run => run.Report.Bob)),
        Metres("legOverlapMaxMetres", LegOverlap),
        LegOverlap,
        Metres("bellyOverlapMaxMetres", BellyOverlap),
        BellyOverlap,
        Of("jointSpeedMaxRadiansPerSecond", WorseFigure.Greater, run => run.Report.FastestJoint),
    ];

    /// <summary>Whether a figure is worse than another.</summary>
    public bool IsWorse(float value, float than) => Worse == WorseFigure.Greater ? value > than : value < than;

    private static MotionMeasure Of(string name, WorseFigure worse, Func<MeasuredRun, float?> value) => new(name, worse, value);

    private static MotionMeasure Metres(string name, MotionMeasure legLengths) => new(name, legLengths.Worse, run => legLengths.Value(run) * run.LegLength);
}
