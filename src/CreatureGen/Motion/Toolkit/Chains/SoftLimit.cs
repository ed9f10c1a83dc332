using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Chains;

/// <summary>Keeps a rotation within a <see cref="JointLimit"/> without a kink: free up to 85 % of the way to its end, then ever slower towards it.</summary>
/// <remarks>
/// The rotation is taken apart into a twist about local Y and then a swing; the swing's rotation vector (x, 0, z) gives the angles about X and Z. The swing is bounded all round, by the ellipse of its four
/// ends, as <see cref="SwingTwistLimit"/> has it; what swings too far is drawn in towards the rest pose. Beyond b = 0.85·m the angle a becomes b + (m − b)(1 − e^(−(a−b)/(m−b))): the slope goes on at b
/// and the angle never reaches m.
/// </remarks>
internal readonly struct SoftLimit
{
    private const double Free = 0.85;

    /// <summary>Radians; a range that is less counts as so much where ranges are compared.</summary>
    private const double MinRange = 1e-6;

    /// <summary>Part of the way to the end of a range up to which a rotation is told to be free without a root or a division: a little less than it is.</summary>
    private const float CertainlyFree = 0.84f;

    private readonly JointLimit limit;
    private readonly SwingTwistBounds free;

    public SoftLimit(JointLimit limit)
    {
        this.limit = limit;
        free = new SwingTwistBounds(limit, CertainlyFree);
    }

    /// <summary>The angles of a rotation about its X and Z (swing) and Y (twist), radians.</summary>
    public static void Angles(Quaternion q, out double x, out double twist, out double z) => SwingTwistLimit.Split(q, out x, out z, out twist);

    /// <summary>Whether a rotation is certainly left as it is: told without an inverse function.</summary>
    public bool Leaves(Quaternion q) => free.HoldSmall(q) || LeavesNear(q);

    /// <summary>The same of what is not far from where it is bent back, or large.</summary>
    private bool LeavesNear(Quaternion q) =>
        SwingTwistLimit.TryBound(q, out float x, out float z, out float twist) && Swung(x, z) <= Free && twist >= (float)Free * limit.Twist.Min && twist <= (float)Free * limit.Twist.Max;

    /// <summary>The rotation within the limit.</summary>
    public Quaternion Apply(Quaternion q)
    {
        if (Leaves(q))
        {
            return q;
        }

        Angles(q, out double x, out double twist, out double z);
        double swung = Swung(x, z);
        double st = Soft(twist, limit.Twist);
        if (swung <= Free && st == twist)
        {
            return q;
        }

        double fraction = swung > Free ? Soft(swung, AngleRange.Both(1f)) / swung : 1;
        return Turn(x * fraction, st, z * fraction);
    }

    /// <summary>How far a swing goes, 1 on the ellipse of the four ends.</summary>
    private double Swung(double x, double z)
    {
        double across = x / Math.Max(x < 0 ? -limit.SwingX.Min : limit.SwingX.Max, MinRange);
        double aside = z / Math.Max(z < 0 ? -limit.SwingZ.Min : limit.SwingZ.Max, MinRange);
        return Math.Sqrt((across * across) + (aside * aside));
    }

    private static Quaternion Turn(double x, double twist, double z) => Rotation.Multiply(SwingTwistLimit.Swing(x, z), AxisRotation.Yaw(twist));

    private static double Soft(double a, AngleRange range)
    {
        double max = a < 0 ? -range.Min : range.Max;
        double size = Math.Abs(a);
        double free = Free * max;
        if (size <= free)
        {
            return a;
        }

        double room = max - free;
        double kept = room > 0 ? free + (room * (1 - PortableMath.Exp((free - size) / room))) : 0;
        return a < 0 ? -kept : kept;
    }
}
