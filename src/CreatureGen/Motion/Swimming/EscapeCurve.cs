using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;

namespace CreatureGen.Motion.Swimming;

/// <summary>
/// The C-start of a startled fish. Time is counted in lengths of its first stage, in which the body curls up to one side; in the second the tail strikes back to the other;
/// then the bend goes and swimming takes over.
/// </summary>
/// <remarks>Based on: Domenici and Blake, "The kinematics and performance of fish fast-start swimming", J. Exp. Biol. 200 (1997): stage 1 of 20–40 ms in fish of 5–10 cm, turns of 60–120°.</remarks>
internal static class EscapeCurve
{
    /// <summary>Length of the first stage, in cycles at cruise.</summary>
    public const double StageFraction = 0.18;

    /// <summary>Length of the whole, in stages.</summary>
    public const double Duration = 4.5;

    /// <summary>Heading between nose and tail at the height of the curl, radians.</summary>
    public const double Curl = 2.3;

    /// <summary>How far the body turns round in all, radians.</summary>
    public const double TurnAngle = 1.3;

    private const double StrikeBegin = 0.8;
    private const double StrikeRise = 0.8;
    private const double StrikeEnd = 2.3;
    private const double DriveFall = Duration - StrikeEnd;

    /// <summary>Bend, 1 at the height of the curl, negative to the other side.</summary>
    public static double Bend(double stages)
    {
        if (stages < 1)
        {
            return Scalar.Smoother(stages);
        }

        return stages < StrikeEnd
            ? Scalar.Lerp(1, -0.5, Scalar.Smoother((stages - 1) / (StrikeEnd - 1)))
            : -0.5 * (1 - Scalar.Smoother((stages - StrikeEnd) / (Duration - StrikeEnd)));
    }

    /// <summary>Part of the turn that is done.</summary>
    public static double Turned(double stages) => Scalar.Smoother(stages / StrikeEnd);

    /// <summary>How much the strike drives: 0 before it, 1 in it, then falling to 0.</summary>
    public static double Drive(double stages) => Scalar.Smoother((stages - StrikeBegin) / StrikeRise) - Scalar.Smoother((stages - StrikeEnd) / DriveFall);

    /// <summary>Integral of <see cref="Drive"/> over the stages so far.</summary>
    public static double Driven(double stages) =>
        (StrikeRise * EaseIntegral((stages - StrikeBegin) / StrikeRise)) - (DriveFall * EaseIntegral((stages - StrikeEnd) / DriveFall));

    /// <summary>How much of the swimming wave is left.</summary>
    public static double Wave(double stages) => 1 - (Scalar.Smoother(stages / 0.7) * (1 - Scalar.Smoother((stages - 1.8) / (Duration - 1.8))));

    /// <summary>Integral of <see cref="Scalar.Smoother(double)"/> from 0.</summary>
    private static double EaseIntegral(double x)
    {
        double t = x < 0 ? 0 : x > 1 ? 1 : x;
        return (t * t * t * t * (2.5 + (t * (-3 + t)))) + Math.Max(x - 1, 0);
    }
}
