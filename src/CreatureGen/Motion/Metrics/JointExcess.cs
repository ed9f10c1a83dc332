using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Metrics;

/// <summary>How far a rotation is beyond a joint's limit, worked out apart from what keeps joints within them, so that an error there is seen here.</summary>
internal static class JointExcess
{
    private const int Narrowings = 48;

    /// <summary>1/φ: golden-section search.</summary>
    private const double Golden = 0.6180339887498949;

    /// <summary>Angle beyond the limit, radians; 0 within.</summary>
    /// <param name="rotation">Unit, in the joint's own axes: rest⁻¹ · local.</param>
    /// <param name="limit">What it may be.</param>
    public static double Of(Quaternion rotation, JointLimit limit)
    {
        Rotation.SwingTwist(rotation, Vector3.UnitY, out Quaternion swing, out Quaternion twist);
        double about = 2 * PortableMath.Atan2(twist.Y, twist.W);
        double sine = Math.Sqrt(((double)swing.X * swing.X) + ((double)swing.Z * swing.Z));
        double perSine = sine > 1e-9 ? 2 * PortableMath.Atan2(sine, swing.W) / sine : 2;
        double twisted = Math.Max(0, Math.Max(limit.Twist.Min - about, about - limit.Twist.Max));
        double swung = Outside(perSine * swing.X, perSine * swing.Z, limit);
        return Math.Sqrt((twisted * twisted) + (swung * swung));
    }

    /// <summary>Distance of a swing from the quarter of an ellipse that bounds it, 0 inside.</summary>
    private static double Outside(double x, double z, JointLimit limit)
    {
        double p = Math.Abs(x);
        double q = Math.Abs(z);
        double a = x < 0 ? -limit.SwingX.Min : limit.SwingX.Max;
        double b = z < 0 ? -limit.SwingZ.Min : limit.SwingZ.Max;
        if ((p * p * b * b) + (q * q * a * a) <= a * a * b * b)
        {
            // A limit of 0 leaves a line.
            return a > 0 && b > 0 ? 0 : a > 0 ? q + Math.Max(0, p - a) : b > 0 ? p + Math.Max(0, q - b) : Math.Sqrt((p * p) + (q * q));
        }

        double from = 0;
        double to = 0.5 * PortableMath.Pi;
        for (int i = 0; i < Narrowings; i++)
        {
            double low = to - (Golden * (to - from));
            double high = from + (Golden * (to - from));
            if (Squared(low) < Squared(high))
            {
                to = high;
            }
            else
            {
                from = low;
            }
        }

        return Math.Sqrt(Squared(0.5 * (from + to)));

        double Squared(double angle)
        {
            PortableMath.SinCos(angle, out double s, out double c);
            double dp = p - (a * c);
            double dq = q - (b * s);
            return (dp * dp) + (dq * dq);
        }
    }
}
