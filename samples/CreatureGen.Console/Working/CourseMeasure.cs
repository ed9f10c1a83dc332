using System;
using System.Collections.Generic;
using CreatureGen.Console.Text;
using CreatureGen.Motion;

namespace CreatureGen.Console.Working;

/// <summary>The figures of <see cref="MeasuredCourse"/>.</summary>
internal static class CourseMeasure
{
    private const float DegreesPerRadian = 57.29578f;
    private static readonly float gravity = MotionSettings.Default.Gravity;

    public static readonly Measure<MeasuredCourse> LimitExcess = Of("limitExcessMaxDegrees", run => run.Report.LimitExcess * DegreesPerRadian);
    public static readonly Measure<MeasuredCourse> JointSpeed = Of("jointSpeedMaxRadiansPerSecond", run => run.Report.JointSpeed);
    public static readonly Measure<MeasuredCourse> HeadSpeed = Of("headSpeedMaxRadiansPerSecond", run => run.Report.HeadSpeed);
    public static readonly Measure<MeasuredCourse> Slip = Of("stanceSlipMaxLegLengths", run => run.Report.StanceSlip);
    public static readonly Measure<MeasuredCourse> Penetration = Of("penetrationMaxLegLengths", run => run.Report.Penetration);
    public static readonly Measure<MeasuredCourse> Clearance = new("clearanceMinLegLengths", WorseFigure.Smaller, run => run.Report.Clearance);
    public static readonly Measure<MeasuredCourse> RootLag = Of("rootLagMaxLegLengths", run => run.Report.RootLag);
    public static readonly Measure<MeasuredCourse> LostGround = Of("lostGround", run => run.Report.LostGround);
    public static readonly Measure<MeasuredCourse> LinearAcceleration = Of("linearAccelerationMaxG", run => run.Report.LinearAcceleration / gravity);
    public static readonly Measure<MeasuredCourse> RestingFootSpread = Of("restingFootSpreadLegLengths", run => run.Report.RestingFootSpread);

    /// <summary>All, in the order of the JSON.</summary>
    public static IReadOnlyList<Measure<MeasuredCourse>> All { get; } =
    [
        LimitExcess,
        JointSpeed,
        HeadSpeed,
        Of("jointAccelerationMaxRadiansPerSecondSquared", run => run.Report.JointAcceleration),
        Of("fastJoints", run => run.Report.FastJoints),
        LinearAcceleration,
        Slip,
        Of("stanceSlip99LegLengths", run => run.Report.StanceSlip99),
        Penetration,
        Clearance,
        RootLag,
        LostGround,
        Of("lostGroundSeconds", run => run.Report.LostGroundSeconds),
        new("supportMin", WorseFigure.Smaller, run => run.Report.MinSupport),
        new("supportMean", WorseFigure.Smaller, run => run.Report.MeanSupport),
        Of("flightMaxSeconds", run => run.Report.LongestFlight),
        RestingFootSpread,
        Of("restingRootSpreadLegLengths", run => run.Report.RestingRootSpread),
    ];

    /// <summary>Those that a table shows.</summary>
    public static IReadOnlyList<MeasureColumn<MeasuredCourse>> Columns { get; } =
    [
        new("beyond", LimitExcess, Units.Tenths),
        new("rad/s", JointSpeed, Units.Whole),
        new("head", HeadSpeed, Units.Whole),
        new("g", LinearAcceleration, Units.Tenths),
        new("slip", Slip, Units.Hundredths),
        new("sinks", Penetration, Units.Hundredths),
        new("clears", Clearance, Units.Hundredths),
        new("lag", RootLag, Units.Hundredths),
        new("lost", LostGround, Units.Whole),
        new("spread", RestingFootSpread, Units.Hundredths),
    ];

    private static Measure<MeasuredCourse> Of(string name, Func<MeasuredCourse, float?> value) => new(name, WorseFigure.Greater, value);
}
