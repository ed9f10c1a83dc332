using System;

namespace CreatureGen.Maths;

/// <summary>Transcendental functions built from basic arithmetic alone, so that every platform gives the same bits.</summary>
public static class PortableMath
{
    /// <summary>Half the circumference of the unit circle.</summary>
    public const double Pi = 3.14159265358979323846;
    /// <summary>The circumference of the unit circle.</summary>
    public const double Tau = 6.28318530717958647692;

    /// <summary>Sine of an angle in radians.</summary>
    public static double Sin(double x) => Math.Sin(x);
    /// <summary>Cosine of an angle in radians.</summary>
    public static double Cos(double x) => Math.Cos(x);
    /// <summary>Angle of the point (x, y), radians, −π..π.</summary>
    public static double Atan2(double y, double x) => Math.Atan2(y, x);
    /// <summary>Angle whose cosine is x, radians, 0..π.</summary>
    public static double Acos(double x) => Math.Acos(x);
    /// <summary>e to the power x.</summary>
    public static double Exp(double x) => Math.Exp(x);
    /// <summary>Natural logarithm.</summary>
    public static double Log(double x) => Math.Log(x);
    /// <summary>x to the power y, x not negative.</summary>
    public static double Pow(double x, double y) => Math.Pow(x, y);
}
