using System;
using System.Collections.Generic;
using CreatureGen.Console.Text;

namespace CreatureGen.Console.Working;

/// <summary>The figures of <see cref="MeasuredRun"/>.</summary>
internal static class MotionMeasure
{
    private const float DegreesPerRadian = 57.29578f;

    public static readonly Measure<MeasuredRun> Slip = Of("slipMaxLegLengths", WorseFigure.Greater, run => run.Report.Slip);
    public static readonly Measure<MeasuredRun> Penetration = Of("penetrationMaxLegLengths", WorseFigure.Greater, run => run.Report.Penetration);
    public static readonly Measure<MeasuredRun> Clearance = Of("clearanceMinLegLengths", WorseFigure.Smaller, run => run.Report.Clearance);
    public static readonly Measure<MeasuredRun> LimitViolations = Of("limitViolations", WorseFigure.Greater, run => run.Report.LimitViolations);
    public static readonly Measure<MeasuredRun> LimitExcess = Of("limitExcessMaxDegrees", WorseFigure.Greater, run => run.Report.LimitExcess * DegreesPerRadian);
    public static readonly Measure<MeasuredRun> Residual = Of("reachResidualMaxLegLengths", WorseFigure.Greater, run => run.Report.StanceResidual);
    public static readonly Measure<MeasuredRun> SwingResidual = Of("swingResidualMaxLegLengths", WorseFigure.Greater, run => run.Report.SwingResidual);
    public static readonly Measure<MeasuredRun> PoseJump = Of("poseJumpMax", WorseFigure.Greater, run => run.Report.PoseJump);
    public static readonly Measure<MeasuredRun> LegOverlap = Of("legOverlapMaxLegLengths", WorseFigure.Greater, run => run.Report.LegOverlap);
    public static readonly Measure<MeasuredRun> BellyOverlap = Of("bellyOverlapMaxLegLengths", WorseFigure.Greater, run => run.Report.BellyOverlap);
    public static readonly Measure<MeasuredRun> Support = Of("supportMin", WorseFigure.Smaller, run => run.Report.MinSupport);

    /// <summary>All, in the order of the JSON.</summary>
    public static IReadOnlyList<Measure<MeasuredRun>> All { get; } =
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
        Of("skatingShare", WorseFigure.Greater, run => run.Report.SkatingFraction),
        Of("stretchedShare", WorseFigure.Greater, run => run.Report.StretchedFraction),
        Of("supportMean", WorseFigure.Smaller, run => run.Report.MeanSupport),
        Metres("bobMetres", Of("", WorseFigure.Greater, run => run.Report.Bob)),
        Metres("legOverlapMaxMetres", LegOverlap),
        LegOverlap,
        Metres("bellyOverlapMaxMetres", BellyOverlap),
        BellyOverlap,
        Of("jointSpeedMaxRadiansPerSecond", WorseFigure.Greater, run => run.Report.FastestJoint),
    ];

    /// <summary>Those that a table shows.</summary>
    public static IReadOnlyList<MeasureColumn<MeasuredRun>> Columns { get; } =
    [
        new("slip", Slip, Units.Hundredths),
        new("sinks", Penetration, Units.Hundredths),
        new("clears", Clearance, Units.Hundredths),
        new("short", Residual, Units.Hundredths),
        new("beyond", LimitExcess, Units.Tenths),
        new("limits", LimitViolations, Units.Whole),
        new("jump", PoseJump, Units.Tenths),
        new("feet", Support, Units.Whole),
    ];

    private static Measure<MeasuredRun> Of(string name, WorseFigure worse, Func<MeasuredRun, float?> value) => new(name, worse, value);

    private static Measure<MeasuredRun> Metres(string name, Measure<MeasuredRun> legLengths) => new(name, legLengths.Worse, run => legLengths.Value(run) * run.LegLength);
}
