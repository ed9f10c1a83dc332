using System;
using System.Collections.Generic;
using CreatureGen.Console.Text;

namespace CreatureGen.Console.Working;

/// <summary>The figures of <see cref="MeasuredAct"/>.</summary>
internal static class ActMeasure
{
    private const float DegreesPerRadian = 57.29578f;

    public static readonly Measure<MeasuredAct> LimitExcess = Of("limitExcessMaxDegrees", run => run.Report.LimitExcess * DegreesPerRadian);
    public static readonly Measure<MeasuredAct> JointSpeed = Of("jointSpeedMaxRadiansPerSecond", run => run.Report.JointSpeed);
    public static readonly Measure<MeasuredAct> Penetration = Of("penetrationMaxBodyLengths", run => run.Report.Penetration);
    public static readonly Measure<MeasuredAct> ContactError = Of("contactErrorMaxBodyLengths", run => run.Report.ContactError);
    public static readonly Measure<MeasuredAct> Slip = Of("footSlipMaxLegLengths", run => run.Report.FootSlip);
    public static readonly Measure<MeasuredAct> Jolt = Of("trunkJoltMaxBodyLengths", run => run.Report.TrunkJolt);

    /// <summary>All, in the order of the JSON.</summary>
    public static IReadOnlyList<Measure<MeasuredAct>> All { get; } = [LimitExcess, JointSpeed, Penetration, ContactError, Slip, Jolt];

    /// <summary>Those that a table shows.</summary>
    public static IReadOnlyList<MeasureColumn<MeasuredAct>> Columns { get; } =
    [
        new("beyond", LimitExcess, Units.Tenths),
        new("rad/s", JointSpeed, Units.Whole),
        new("sinks", Penetration, Units.Hundredths),
        new("misses", ContactError, Units.Hundredths),
        new("slip", Slip, Units.Hundredths),
        new("jolt", Jolt, Units.Hundredths),
    ];

    private static Measure<MeasuredAct> Of(string name, Func<MeasuredAct, float?> value) => new(name, WorseFigure.Greater, value);
}
