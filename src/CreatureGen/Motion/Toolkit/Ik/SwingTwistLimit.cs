using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>
/// Keeps a joint's whole turn away from its rest pose within its <see cref="JointLimit"/>: the twist about the bone in its range, the swing of the bone within an elliptical cone.
/// </summary>
/// <remarks>
/// <para>A turn is a twist about local Y, then a swing about an axis across it. Drawn as axis times angle, the swing is a point (x, z); the limit is an area around zero whose four quarters
/// are quarters of ellipses with the ends of <see cref="JointLimit.SwingX"/> and <see cref="JointLimit.SwingZ"/> as half axes: along each axis exactly the joint's range, and no corners between.
/// A swing outside goes to the nearest point of that area. There are no Euler angles, hence no gimbal lock.</para>
/// <para>Based on: P. Baerlocher and R. Boulic, "Parametrization and range of motion of the ball-and-socket joint" (2001); D. Eberly, "Distance from a point to an ellipse" (2013), whose root is
/// found here by Newton's method from the side on which it cannot overshoot.</para>
/// </remarks>
public static class SwingTwistLimit
{
    /// <summary>Radians. Turns that miss a limit by less are within it: what floats lose in a few multiplications.</summary>
    public const float Slack = 1e-5f;

    private const int NewtonSteps = 24;

    private const double Hair = 1e-9;

    /// <summary>The turn within the limit nearest to a turn.</summary>
    /// <param name="turn">Unit quaternion, in the joint's own axes: rest⁻¹ · local.</param>
    /// <param name="limit">What it may be.</param>
    /// <returns>The turn itself, to the bit, when it is within the limit.</returns>
    public static Quaternion Clamp(Quaternion turn, JointLimit limit) => new SwingTwistBounds(limit).Hold(turn) ? turn : ClampUnheld(turn, limit);

    /// <summary>The same of a turn that its bounds do not tell to be within.</summary>
    private static Quaternion ClampUnheld(Quaternion turn, JointLimit limit)
    {
        Split(turn, out double x, out double z, out double twist);
        double boundedTwist = Scalar.Clamp(twist, limit.Twist.Min, limit.Twist.Max);
        double boundedX = x;
        double boundedZ = z;
        bool swings = ClampSwing(limit.SwingX, limit.SwingZ, ref boundedX, ref boundedZ);
        if (!swings && Math.Abs(boundedTwist - twist) <= Slack)
        {
            return turn;
        }

        Quaternion swing = Swing(boundedX, boundedZ);
        FastTrigonometry.SinCos((float)(0.5 * boundedTwist), out float s, out float c);
        return Rotation.Normalize(Rotation.Multiply(swing, new Quaternion(0f, s, 0f, c)));
    }

    /// <summary>How far a turn lies outside its limit: the angle between it and its <see cref="Clamp"/>, radians; 0 within.</summary>
    /// <param name="turn">Unit quaternion, in the joint's own axes.</param>
    /// <param name="limit">What it may be.</param>
    public static float Excess(Quaternion turn, JointLimit limit) => (float)Rotation.AngleBetween(turn, Clamp(turn, limit));

    /// <summary>A local rotation brought within its joint's limit.</summary>
    /// <param name="local">Unit quaternion, in the parent's space.</param>
    /// <param name="joint">Gives rest rotation and limit.</param>
    /// <remarks>What costs no inverse function is inlined: nearly all joints of a frame are well within their limits, and a quaternion that is handed over costs as much as the test.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion ClampLocal(Quaternion local, Joint joint) =>
        BoneAxes.AreOwn(joint) && new SwingTwistBounds(joint.Limit).Hold(Rotation.Multiply(Rotation.Inverse(joint.LocalRotation), local)) ? local : ClampNear(local, joint);

    /// <summary>Brings all joints of a local pose within their limits.</summary>
    /// <param name="skeleton">Gives rest rotations and limits.</param>
    /// <param name="local">Changed in place.</param>
    /// <exception cref="ArgumentException">The pose is not as long as the skeleton.</exception>
    public static void ClampPose(Skeleton skeleton, in Pose local)
    {
        local.Require(skeleton);
        for (int i = 0; i < local.Rotations.Length; i++)
        {
            local.Rotations[i] = ClampLocal(local.Rotations[i], skeleton.Joints[i]);
        }
    }

    /// <summary>A local rotation that is near its joint's limit, or beyond: of a bone along its own +Y, one that its bounds do not hold, which is not asked again.</summary>
    internal static Quaternion ClampNear(Quaternion local, Joint joint)
    {
        Quaternion rest = joint.LocalRotation;
        Quaternion turn = Rotation.Multiply(Rotation.Inverse(rest), local);
        if (!BoneAxes.AreOwn(joint))
        {
            return ClampAlong(local, rest, turn, joint);
        }

        Quaternion bounded = ClampUnheld(turn, joint.Limit);
        return bounded == turn ? local : Rotation.Normalize(Rotation.Multiply(rest, bounded));
    }

    /// <summary>The same for a bone along another axis than +Y: the limit is of the turn as the bone's own axes see it.</summary>
    private static Quaternion ClampAlong(Quaternion local, Quaternion rest, Quaternion turn, Joint joint)
    {
        Quaternion axes = BoneAxes.Of(joint);
        Quaternion inverse = Rotation.Inverse(axes);
        Quaternion inBone = Rotation.Multiply(inverse, Rotation.Multiply(turn, axes));
        Quaternion bounded = Clamp(inBone, joint.Limit);
        return bounded == inBone ? local : Rotation.Normalize(Rotation.Multiply(rest, Rotation.Multiply(axes, Rotation.Multiply(bounded, inverse))));
    }

    /// <summary>Bounds of the angles of a turn that is not large, without an inverse function: of their signs, and no nearer to 0 than they are.</summary>
    internal static bool TryBound(Quaternion turn, out float x, out float z, out float twist)
    {
        // |(x, z)| is the sine of half the swing; y over the length of (y, w) that of half the twist.
        float across = (turn.X * turn.X) + (turn.Z * turn.Z);
        float along = (turn.Y * turn.Y) + (turn.W * turn.W);
        if (across > 0.25f || turn.Y * turn.Y > 0.25f * along)
        {
            x = z = twist = 0f;
            return false;
        }

        float inverse = 1f / (float)Math.Sqrt(along);
        twist = SwingTwistBounds.AnglePerHalfSine * (turn.W < 0f ? -inverse : inverse) * turn.Y;
        x = SwingTwistBounds.AnglePerHalfSine * inverse * ((turn.X * turn.W) + (turn.Z * turn.Y));
        z = SwingTwistBounds.AnglePerHalfSine * inverse * ((turn.Z * turn.W) - (turn.X * turn.Y));
        return true;
    }

    /// <summary>The parts of a turn: swing as axis times angle across local Y, then twist, radians.</summary>
    /// <param name="turn">Unit quaternion.</param>
    /// <param name="x">Swing about local X.</param>
    /// <param name="z">Swing about local Z.</param>
    /// <param name="twist">−π..π; 0 where the bone points back along itself, since any twist would do.</param>
    internal static void Split(Quaternion turn, out double x, out double z, out double twist)
    {
        double sign = turn.W < 0f ? -1 : 1;
        double along = Math.Sqrt(((double)turn.Y * turn.Y) + ((double)turn.W * turn.W));
        double sx = turn.X;
        double sz = turn.Z;
        if (along > Tolerance.OppositeDirections)
        {
            // The swing is turn · twist⁻¹; its w is the length of (y, w).
            double ty = sign * turn.Y / along;
            double tw = sign * turn.W / along;
            twist = 2 * FastTrigonometry.Of((float)ty, (float)tw);
            sx = sign * ((turn.X * tw) + (turn.Z * ty));
            sz = sign * ((turn.Z * tw) - (turn.X * ty));
        }
        else
        {
            twist = 0;
            along = 0;
        }

        double across = Math.Sqrt((sx * sx) + (sz * sz));
        double scale = across > 1e-12 ? 2 * FastTrigonometry.Of((float)across, (float)along) / across : 2;
        x = sx * scale;
        z = sz * scale;
    }

    /// <summary>The rotation of a swing given as axis times angle.</summary>
    internal static Quaternion Swing(double x, double z)
    {
        double angle = Math.Sqrt((x * x) + (z * z));
        FastTrigonometry.SinCos((float)(0.5 * angle), out float s, out float c);
        double scale = angle > 1e-12 ? s / angle : 0.5;
        return new Quaternion((float)(x * scale), 0f, (float)(z * scale), c);
    }

    /// <summary>Moves a swing to the nearest one within the limit; says whether it had to.</summary>
    internal static bool ClampSwing(AngleRange rangeX, AngleRange rangeZ, ref double x, ref double z)
    {
        double a = x < 0 ? -rangeX.Min : rangeX.Max;
        double b = z < 0 ? -rangeZ.Min : rangeZ.Max;
        if (a >= PortableMath.Pi - Slack && b >= PortableMath.Pi - Slack)
        {
            return false;
        }

        double p = Math.Abs(x);
        double q = Math.Abs(z);
        if (a < Hair || b < Hair)
        {
            double flatP = Math.Min(p, a < Hair ? 0 : a);
            double flatQ = Math.Min(q, b < Hair ? 0 : b);
            bool out1 = p - flatP > Slack || q - flatQ > Slack;
            if (out1)
            {
                x = x < 0 ? -flatP : flatP;
                z = z < 0 ? -flatQ : flatQ;
            }

            return out1;
        }

        double g = (p / a * (p / a)) + (q / b * (q / b));
        if (g <= 1)
        {
            return false;
        }

        Nearest(a, b, p, q, out double nearP, out double nearQ);
        if (Math.Abs(nearP - p) + Math.Abs(nearQ - q) <= Slack)
        {
            return false;
        }

        x = x < 0 ? -nearP : nearP;
        z = z < 0 ? -nearQ : nearQ;
        return true;
    }

    /// <summary>The point of the ellipse with half axes a, b nearest to the point (p, q) outside it, in the first quadrant.</summary>
    /// <remarks>It is (a²p/(t + a²), b²q/(t + b²)) with t ≥ 0 the root of (ap/(t + a²))² + (bq/(t + b²))² = 1, whose left side falls and is convex.</remarks>
    private static void Nearest(double a, double b, double p, double q, out double nearP, out double nearQ)
    {
        double aa = a * a;
        double bb = b * b;
        double t = Math.Max(0, Math.Max((a * p) - aa, (b * q) - bb));
        for (int i = 0; i < NewtonSteps; i++)
        {
            double u = a * p / (t + aa);
            double v = b * q / (t + bb);
            double f = (u * u) + (v * v) - 1;
            double slope = -2 * ((u * u / (t + aa)) + (v * v / (t + bb)));
            double step = -f / slope;
            if (!(step > 1e-10 * (t + aa + bb)))
            {
                break;
            }

            t += step;
        }

        nearP = aa * p / (t + aa);
        nearQ = bb * q / (t + bb);
    }
}
